"""Writes worlds.json: transition tables of Gymnasium's toy worlds, and their values; and policies.json: what policies on
them may expect. Run: python3 gymnasium_worlds.py (Gymnasium 1.4, NumPy 2)."""

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


def judged(table, start, policy, gamma):
    """Expected return from the start, as the solution of V = R + gamma P V, and the probability to end with the goal."""
    n = len(table)
    p, r, goal = np.zeros((n, n)), np.zeros(n), np.zeros(n)
    for s in range(n):
        for odds, to, reward, done in table[s][policy[s]]:
            r[s] += odds * reward
            goal[s] += odds * (done and to == n - 1)
            p[s, to] += odds * (not done)
    reaches = np.zeros(n)
    for _ in range(200_000):
        reaches = goal + p @ reaches
    value = np.linalg.solve(np.eye(n) - gamma * p, r)
    return {"policy": policy, "return": float(value[start]), "reaches": float(reaches[start])}


def policies(name, start):
    table, q, gamma = (worlds[name][key] for key in ("table", "q", "gamma"))
    chance = np.random.default_rng(2026)
    n = len(table)
    some = [np.argmax(q, axis=1).tolist()] + [[a] * n for a in range(4)]
    some += [chance.integers(4, size=n).tolist() for _ in range(10)]
    return [judged(table, start, policy, gamma) for policy in some]


starts = {"lake4": 0, "lake8": 0, "cliff": 36}
table_of_policies = {name: policies(name, start) for name, start in starts.items()}
pathlib.Path(__file__).with_name("policies.json").write_text(json.dumps(table_of_policies) + "\n")
