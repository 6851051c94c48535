"""Writes forward.json: 500 random fully connected networks and what NumPy says they give. Run: python3 make.py (NumPy 2).

A case is [layers, inputs, outputs]; a layer is [activations, biases, weights by neuron]. Weights have three places and
biases one, so that the file stays small; inputs and outputs are whole doubles.
"""

import json
import pathlib

import numpy as np

draw = np.random.default_rng(2026)
alone = {
    "identity": lambda v: v,
    "relu": lambda v: np.maximum(v, 0),
    "sigmoid": lambda v: 1 / (1 + np.exp(-v)),
    "tanh": np.tanh,
    "threshold": lambda v: np.heaviside(v, 0.0),
}


def softmax(v):
    grown = np.exp(v - v.max())
    return grown / grown.sum()


def layer(before, after, last):
    share = last and draw.random() < 0.3
    one = draw.choice(list(alone))
    names = ["softmax" if share else (str(draw.choice(list(alone))) if last else str(one)) for _ in range(after)]
    wide = float(draw.choice([0.5, 1, 3]))
    weights = draw.uniform(-wide, wide, size=(after, before)).round(3)
    return names, draw.uniform(-60, 60, size=after).round(1), weights


def carried_out(layers, values):
    for names, biases, weights in layers:
        sums = (weights @ values + biases) / 100
        if names[0] == "softmax":
            values = 100 * softmax(sums)
        else:
            values = np.array([100 * alone[name](v) for name, v in zip(names, sums)])
    return values


def case():
    links = int(draw.integers(1, 5))
    sizes = [int(size) for size in draw.integers(1, 6, size=links + 1)]
    layers = [layer(before, after, k == links - 1) for k, (before, after) in enumerate(zip(sizes, sizes[1:]))]
    inputs = draw.uniform(0, 100, size=sizes[0])
    outputs = carried_out(layers, inputs)
    return [[[names, biases.tolist(), weights.tolist()] for names, biases, weights in layers], inputs.tolist(), outputs.tolist()]


text = ",\n".join(json.dumps(case(), separators=(",", ":")) for _ in range(500))
pathlib.Path(__file__).with_name("forward.json").write_text(f"[\n{text}\n]\n")
