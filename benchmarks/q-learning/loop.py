"""The City in Python: `plain` loops over lists, `numpy` a table of NumPy and a world that steps as Gymnasium's do.

python3 loop.py plain|numpy MOVES < graph; prints moves a second."""

import random
import sys
import time

method, moves = sys.argv[1], int(sys.argv[2])
stations, start, goal, *rest = map(int, sys.stdin.read().split())
first, to = rest[: stations + 1], rest[stations + 1 :]
ways = [to[first[s] : first[s + 1]] for s in range(stations)]
ALPHA, GAMMA, TELEPORT, EXPLORE = 0.5, 0.8, 0.1, 0.5
open_stations = [s for s in range(stations) if s != goal and ways[s]]


def plain():
    q = [[0.0] * len(row) for row in ways]
    s, length, draw = None, 0, random.random
    for _ in range(moves):
        rho, nu = draw(), draw()
        if nu < TELEPORT:
            s = open_stations[int(draw() * len(open_stations))]
        elif s is None:
            s = start
        length += 1
        row = q[s]
        if rho < EXPLORE:
            a = int(draw() * len(row))
        else:
            best = max(row)
            ties = [i for i, value in enumerate(row) if value == best]
            a = ties[int(draw() * len(ties))] if len(ties) > 1 else ties[0]
        after = ways[s][a]
        value = 0.0 if after == goal else max(q[after])
        row[a] += ALPHA * ((50 if after == goal else 0) + GAMMA * value - row[a])
        s = after
        if s == goal or length >= 20 * stations:
            s, length = None, 0


def with_numpy():
    import numpy as np

    most = max(map(len, ways))
    q = np.full((stations, most), -np.inf)
    for s, row in enumerate(ways):
        q[s, : len(row)] = 0
    rng = np.random.default_rng(1)

    class World:
        def reset(self):
            self.s, self.length = start, 0
            return self.s, {}

        def step(self, a):
            self.s = ways[self.s][a]
            self.length += 1
            return self.s, 50 if self.s == goal else 0, self.s == goal, self.length >= 20 * stations, {}

    world = World()
    s, _ = world.reset()
    for _ in range(moves):
        if rng.random() < TELEPORT:
            s = world.s = open_stations[rng.integers(len(open_stations))]
        if rng.random() < EXPLORE:
            a = int(rng.integers(len(ways[s])))
        else:
            a = int(rng.choice(np.flatnonzero(q[s] == q[s].max())))
        after, reward, terminated, truncated, _ = world.step(a)
        target = reward + GAMMA * np.max(q[after]) * (not terminated)
        q[s, a] += ALPHA * (target - q[s, a])
        s = after
        if terminated or truncated:
            s, _ = world.reset()


begun = time.process_time()
{"plain": plain, "numpy": with_numpy}[method]()
print(moves / (time.process_time() - begun))
