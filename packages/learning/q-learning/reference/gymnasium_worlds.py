"""Writes worlds.json: transition tables of Gymnasium's toy worlds, and their values. Run: python3 gymnasium_worlds.py
(Gymnasium 1.4, NumPy 2)."""

import json
import pathlib

import gymnasium
import numpy as np


def values(table, gamma):
    v = np.zeros(len(table))
    while True:
        q = np.array(
            [
                [sum(p * (r + gamma * v[to] * (not done)) for p, to, r, done in row[a]) for a in range(4)]
                for row in (table[s] for s in range(len(table)))
            ]
        )
        new = q.max(axis=1)
        if np.abs(new - v).max() < 1e-14:
            return q
        v = new


def world(name, gamma, **options):
    env = gymnasium.make(name, **options).unwrapped
    table = {
        int(s): {int(a): [[float(p), int(to), float(r), bool(done)] for p, to, r, done in env.P[s][a]] for a in env.P[s]}
        for s in env.P
    }
    return {"name": name, "gamma": gamma, "table": table, "q": values(table, gamma).tolist()}


worlds = {
    "lake4": world("FrozenLake-v1", 0.95, map_name="4x4", is_slippery=True),
    "lake8": world("FrozenLake-v1", 0.95, map_name="8x8", is_slippery=True),
    "cliff": world("CliffWalking-v1", 0.9),
}
pathlib.Path(__file__).with_name("worlds.json").write_text(json.dumps(worlds) + "\n")
