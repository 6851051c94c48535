"""Writes corridor.json: values of a corridor of three places between two walls, by value iteration (Sutton & Barto, 2nd
edition, 4.4). States near-the-left-wall 0, middle 1, near-the-right-wall 2, and 3, the bump, which ends the try. Actions:
left, stay, right. Each place to the right pays 1, a bump -5, staying 0, to the left -0.5. Plain Python: python3 corridor.py."""

import json
import pathlib

TO = [[3, 0, 1], [0, 1, 2], [1, 2, 3], [3, 3, 3]]
PAY = [[-5, 0, 1], [-0.5, 0, 1], [-0.5, 0, -5], [0, 0, 0]]
ENDS = [False, False, False, True]


def solved(gamma):
    q = [[0.0] * 3 for _ in TO]
    while True:
        new = [
            [0.0 if ENDS[s] else PAY[s][a] + (0.0 if ENDS[to] else gamma * max(q[to])) for a, to in enumerate(row)]
            for s, row in enumerate(TO)
        ]
        if all(abs(a - b) < 1e-15 for one, other in zip(new, q) for a, b in zip(one, other)):
            return new
        q = new


values = {str(gamma): solved(gamma) for gamma in (0, 0.5, 0.9)}
world = {"to": TO, "reward": PAY, "ends": ENDS, "starts": [0, 1, 2]}
path = pathlib.Path(__file__).with_name("corridor.json")
path.write_text(json.dumps({"world": world, "values": values}, indent=1) + "\n")
