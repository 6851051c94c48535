"""Writes practice.json: networks after 100 rounds of practice, as PyTorch leaves them; NumPy agrees within 1e-12.

    apt-get install python3-torch        (PyTorch 1.13, CPU; NumPy 1.24)
    python3 packages/learning/neural-network/reference/make-train.py

A case is [sizes, activation of hidden layers, activation of outputs, optimizer, momentum, decay, batch, start, end]; start and
end are, layer by layer, weights by neuron and then biases, in hundredths. Batches are taken in the order of the rows. The rate is
0.02, with Adam 0.005. Outputs with softmax practise by cross-entropy, at a tenth of that.
"""

import itertools
import json
from pathlib import Path

import numpy as np
import torch

torch.set_default_dtype(torch.float64)
torch.set_num_threads(1)
draw = np.random.default_rng(20261124)
ROUNDS, ROWS = 100, 21
inputs = draw.uniform(0, 1, (ROWS, 3)).round(2)
wheels = draw.uniform(-1, 1, (ROWS, 2)).round(2)
chosen = np.eye(2)[draw.integers(0, 2, ROWS)]


def rate_of(optimizer, out):
    return (0.005 if optimizer == "adam" else 0.02) / (10 if out == "softmax" else 1)



def softmax(z):
    grown = np.exp(z - z.max(axis=1, keepdims=True))
    return grown / grown.sum(axis=1, keepdims=True)


curves = {
    "identity": (lambda z: z, lambda z, y: np.ones_like(z)),
    "relu": (lambda z: np.maximum(z, 0), lambda z, y: (z > 0) * 1.0),
    "sigmoid": (lambda z: 1 / (1 + np.exp(-z)), lambda z, y: y * (1 - y)),
    "tanh": (np.tanh, lambda z, y: 1 - y * y),
    "softmax": (softmax, None),
}
in_torch = {"identity": lambda z: z, "relu": torch.relu, "sigmoid": torch.sigmoid, "tanh": torch.tanh}


def by_torch(sizes, hidden, out, optimizer, momentum, decay, batch, start):
    weights = [torch.tensor(w, requires_grad=True) for w, _ in start]
    biases = [torch.tensor(b, requires_grad=True) for _, b in start]
    groups = [{"params": weights, "weight_decay": decay}, {"params": biases, "weight_decay": 0}]
    rate = rate_of(optimizer, out)
    one = torch.optim.Adam(groups, lr=rate) if optimizer == "adam" else torch.optim.SGD(groups, lr=rate, momentum=momentum)
    x = torch.tensor(inputs)
    t = torch.tensor(chosen if out == "softmax" else wheels)
    for _ in range(ROUNDS):
        for at in range(0, ROWS, batch):
            y = x[at : at + batch]
            for k, (w, b) in enumerate(zip(weights, biases)):
                z = y @ w.T + b
                last = k == len(weights) - 1
                y = z if last and out == "softmax" else in_torch[out if last else hidden](z)
            wanted = t[at : at + batch]
            if out == "softmax":
                loss = torch.nn.functional.cross_entropy(y, wanted.argmax(dim=1))
            else:
                loss = torch.nn.functional.mse_loss(y, wanted)
            one.zero_grad()
            loss.backward()
            one.step()
    return [(w.detach().numpy(), b.detach().numpy()) for w, b in zip(weights, biases)]


def by_numpy(sizes, hidden, out, optimizer, momentum, decay, batch, start):
    theta = [[w.copy(), b.copy()] for w, b in start]
    first = [[np.zeros_like(w), np.zeros_like(b)] for w, b in start]
    second = [[np.zeros_like(w), np.zeros_like(b)] for w, b in start]
    rate, updates = rate_of(optimizer, out), 0
    t = chosen if out == "softmax" else wheels
    for _ in range(ROUNDS):
        for at in range(0, ROWS, batch):
            ys, zs = [inputs[at : at + batch]], []
            for k, (w, b) in enumerate(theta):
                zs.append(ys[-1] @ w.T + b)
                ys.append(curves[out if k == len(theta) - 1 else hidden][0](zs[-1]))
            wanted = t[at : at + batch]
            delta = ys[-1] - wanted
            if out != "softmax":
                delta = 2 / wanted.shape[1] * delta * curves[out][1](zs[-1], ys[-1])
            slopes = [None] * len(theta)
            for k in reversed(range(len(theta))):
                slopes[k] = [delta.T @ ys[k] / len(wanted) + decay * theta[k][0], delta.mean(axis=0)]
                if k > 0:
                    delta = (delta @ theta[k][0]) * curves[hidden][1](zs[k - 1], ys[k])
            updates += 1
            for k, part in itertools.product(range(len(theta)), range(2)):
                g = slopes[k][part]
                if optimizer == "sgd":
                    first[k][part] = momentum * first[k][part] + g
                    theta[k][part] -= rate * first[k][part]
                else:
                    first[k][part] = 0.9 * first[k][part] + 0.1 * g
                    second[k][part] = 0.999 * second[k][part] + 0.001 * g * g
                    whole = first[k][part] / (1 - 0.9**updates)
                    spread = second[k][part] / (1 - 0.999**updates)
                    theta[k][part] -= rate * whole / (np.sqrt(spread) + 1e-8)
    return theta


def flat(layers):
    return [float(v) for w, b in layers for v in [*w.ravel(), *b]]


def start_of(sizes):
    return [(draw.uniform(-0.9, 0.9, (n, m)).round(3), draw.uniform(-0.3, 0.3, n).round(3)) for m, n in zip(sizes, sizes[1:])]


def cases():
    ways = [("sgd", 0, 0), ("sgd", 0.9, 0), ("sgd", 0.9, 0.01), ("adam", 0, 0), ("adam", 0, 0.01)]
    for sizes in ([3, 2], [3, 4, 2], [3, 4, 3, 2]):
        nets = [("identity", out) for out in curves] if len(sizes) == 2 else [(hidden, "identity") for hidden in in_torch]
        nets += [] if len(sizes) == 2 else [("sigmoid", "tanh"), ("tanh", "softmax")]
        for (hidden, out), (optimizer, momentum, decay), batch in itertools.product(nets, ways, [1, 16, ROWS]):
            given = (sizes, hidden, out, optimizer, momentum, decay, batch)
            start = start_of(sizes)
            end = by_torch(*given, start)
            off = np.abs(np.array(flat(end)) - flat(by_numpy(*given, start))).max()
            assert off < 1e-12, (given, off)
            yield [*given, flat(start), flat(end)]


text = ",\n".join(json.dumps(case, separators=(",", ":")) for case in cases())
rows = json.dumps({"inputs": inputs.tolist(), "wheels": wheels.tolist(), "chosen": chosen.tolist()}, separators=(",", ":"))
Path(__file__).with_name("practice.json").write_text(f'{{"rows":{rows},"cases":[\n{text}\n]}}\n')
