"""Writes shares.json: random networks of every activation and what each input brings to each output, by the definition of the
Shapley value: the mean over all orders of the inputs. Exact fractions are not needed; NumPy's doubles are summed with math.fsum.
Run: python3 make.py (NumPy 2)."""

import itertools
import json
import math
import pathlib

import numpy as np

draw = np.random.default_rng(77)


def softmax(values):
    powers = np.exp(values / 100 - np.max(values / 100))
    return powers / powers.sum() * 100


bends = {
    "identity": lambda s: s,
    "relu": lambda s: np.maximum(s, 0),
    "sigmoid": lambda s: 100 / (1 + np.exp(-s / 100)),
    "tanh": lambda s: 100 * np.tanh(s / 100),
    "threshold": lambda s: np.where(s > 0, 100.0, 0.0),
    "softmax": softmax,
}


def run(layers, inputs):
    values = np.array(inputs)
    for layer in layers:
        values = bends[layer["activation"]](np.array(layer["weights"]) @ values + np.array(layer["biases"]))
    return values


def shapley(layers, inputs):
    """shares[output][input]"""
    n = len(inputs)
    parts = [[[] for _ in range(n)] for _ in layers[-1]["biases"]]
    for order in itertools.permutations(range(n)):
        present = [0.0] * n
        before = run(layers, present)
        for player in order:
            present[player] = inputs[player]
            after = run(layers, present)
            for output in range(len(after)):
                parts[output][player].append(float(after[output] - before[output]))
            before = after
    return [[math.fsum(one) / len(one) for one in output] for output in parts]


def case(number):
    sizes = [int(draw.integers(1, 6))] + [int(size) for size in draw.integers(1, 5, size=int(draw.integers(1, 4)))]
    names = list(bends)
    layers = [
        {
            "activation": names[(number + depth) % len(names)],
            "weights": draw.uniform(-1, 1, size=(after, before)).round(3).tolist(),
            "biases": draw.uniform(-20, 20, size=after).round(3).tolist(),
        }
        for depth, (before, after) in enumerate(zip(sizes, sizes[1:]))
    ]
    inputs = draw.uniform(0, 100, size=sizes[0]).round(2).tolist()
    base = run(layers, [0.0] * sizes[0]).tolist()
    return {
        "layers": layers,
        "inputs": inputs,
        "base": base,
        "outputs": run(layers, inputs).tolist(),
        "shares": shapley(layers, inputs),
    }


cases = [case(number) for number in range(48)]
pathlib.Path(__file__).with_name("shares.json").write_text(json.dumps(cases) + "\n")
