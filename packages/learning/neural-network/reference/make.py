"""Writes forward.json: random fully connected networks and what NumPy says they give. Run: python3 make.py (NumPy 2)."""

import json
import pathlib

import numpy as np

draw = np.random.default_rng(2026)


def network(case):
    sizes = [int(size) for size in draw.integers(1, 7, size=int(draw.integers(2, 5)))]
    weights = [draw.uniform(-1, 1, size=(after, before)) for before, after in zip(sizes, sizes[1:])]
    biases = [draw.uniform(-20, 20, size=size) for size in sizes[1:]]
    inputs = draw.uniform(0, 100, size=sizes[0])
    values = inputs
    for weight, bias in zip(weights, biases):
        values = weight @ values + bias
    return {
        "inputs": inputs.tolist(),
        "weights": [weight.tolist() for weight in weights],
        "biases": [bias.tolist() for bias in biases],
        "outputs": values.tolist(),
    }


cases = [network(case) for case in range(60)]
pathlib.Path(__file__).with_name("forward.json").write_text(json.dumps(cases) + "\n")
