"""The same practice by PyTorch: python3 loop.py relu|tanh BATCH ROUNDS < numbers, as loop.c reads and writes them."""

import sys
import time

import torch

torch.set_default_dtype(torch.float64)
torch.set_num_threads(1)
curve = {"relu": torch.relu, "tanh": torch.tanh}[sys.argv[1]]
batch, rounds = int(sys.argv[2]), int(sys.argv[3])
numbers = torch.tensor([float(word) for word in sys.stdin.read().split()])
w1, b1, w2, b2 = (part.clone().requires_grad_() for part in torch.split(numbers[:58], [32, 8, 16, 2]))
rows = numbers[58:].reshape(512, 6)
parts = [w1, b1, w2, b2]
one = torch.optim.SGD(parts, lr=0.03, momentum=0.9)
begun = time.process_time()
for _ in range(rounds):
    for at in range(0, 512, batch):
        x, t = rows[at : at + batch, :4], rows[at : at + batch, 4:]
        y = curve(x @ w1.reshape(8, 4).T + b1) @ w2.reshape(2, 8).T + b2
        one.zero_grad()
        torch.nn.functional.mse_loss(y, t).backward()
        one.step()
speed = rounds * 512 / (time.process_time() - begun)
print(speed, *[float(value) for part in parts for value in part])
