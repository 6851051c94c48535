"""Writes grids.json: transition tables and values of grid worlds that Gymnasium does not have. Sutton & Barto, 2nd edition:
the windy grid of example 6.5 (7 x 10, start 3-0, goal 3-7, wind 0 0 0 1 1 1 2 2 1 0, reward -1 until the goal) and a bandit
with two levers (2.1); and an errand like Taxi (Dietterich 2000): state = room and whether the parcel is carried.
Order of actions as in Gymnasium's toy_text: left, down, right, up. Plain Python: python3 grids.py."""

import json
import pathlib

MOVES = [(0, -1), (1, 0), (0, 1), (-1, 0)]


def solved(table, gamma):
    q = {s: [0.0] * len(actions) for s, actions in table.items()}
    while True:
        v = {s: max(q[s], default=0.0) for s in table}
        new = {
            s: [sum(p * (r + gamma * v[to] * (not done)) for p, to, r, done in row) for row in actions]
            for s, actions in table.items()
        }
        if all(abs(a - b) < 1e-14 for s in table for a, b in zip(new[s], q[s])):
            return new
        q = new


def windy():
    wind = [0, 0, 0, 1, 1, 1, 2, 2, 1, 0]
    goal = 3 * 10 + 7
    table = {}
    for row in range(7):
        for column in range(10):
            s = row * 10 + column
            table[s] = []
            if s == goal:
                continue
            for down, right in MOVES:
                r = min(6, max(0, row + down))
                c = min(9, max(0, column + right))
                r = max(0, r - wind[column])
                to = r * 10 + c
                table[s].append([[1.0, to, -1.0, to == goal]])
    steps, s = 0, 30
    q = solved(table, 1.0)
    while s != goal:
        s = table[s][q[s].index(max(q[s]))][0][1]
        steps += 1
    return table, steps


def errand(rows):
    height, width = len(rows), len(rows[0])
    count = height * width
    table = {}
    for carries in (0, 1):
        for row in range(height):
            for column in range(width):
                s = carries * count + row * width + column
                table[s] = []
                if rows[row][column] == "W" or (carries and rows[row][column] == "G"):
                    continue
                for down, right in MOVES:
                    r, c = row + down, column + right
                    if not (0 <= r < height and 0 <= c < width) or rows[r][c] == "W":
                        r, c = row, column
                    now = 1 if carries or rows[r][c] == "P" else 0
                    done = bool(now) and rows[r][c] == "G"
                    table[s].append([[1.0, now * count + r * width + c, 50.0 if done else 0.0, done]])
    return table


def bandit(chances):
    pulls = [[[p, 2 * k, 50.0, True], [1 - p, 2 * k, 0.0, True]] for k, p in enumerate(chances)]
    return {0: [], 1: pulls, 2: []}


def world(table, gamma, **more):
    return {"gamma": gamma, "table": table, "q": solved(table, gamma), **more}


windy_table, windy_steps = windy()
worlds = {
    "windy": world(windy_table, 0.9, steps=windy_steps),
    "errand": world(errand(["FPFG", "FWWF", "SFFF"]), 0.8),
    "bandit": world(bandit([0.3, 0.6]), 0.8),
}
pathlib.Path(__file__).with_name("grids.json").write_text(json.dumps(worlds) + "\n")
