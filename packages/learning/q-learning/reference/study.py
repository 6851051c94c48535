"""Writes study.json: Algorithm 1 of the thesis, written down literally. Run: python3 study.py (no library needed; minutes).

Two parts. `moves`: a few runs opened: the state of the random stream it begins with, and every table after each move. `shares`: over 10,000 runs a
row, the share of runs whose shown way is a shortest one after 10, 30, 100, 300 and 1000 moves."""

import json
import pathlib
import random
from multiprocessing import Pool

here = pathlib.Path(__file__).parent
graphs = json.loads((here / "graphs.json").read_text())
AFTER = [10, 30, 100, 300, 1000]
RUNS = 10_000
SETTINGS = [
    (alpha, gamma, nu, rho)
    for alpha, gamma in [(0.1, 0.2), (0.5, 0.8), (0.9, 0.8)]
    for nu, rho in [(0.1, 0.5), (0.1, 0.9), (0.9, 0.5), (0.9, 0.9)]
]


def table_of(graph):
    table = {station: {} for station in range(graph["stations"])}
    for a, b in graph["edges"]:
        table[a][b] = 0.0
        table[b][a] = 0.0
    for a, b in graph["closed"]:
        del table[a][b]
    return {station: dict(sorted(row.items())) for station, row in table.items()}


def best(row):
    """The action with the highest value; of equal ones the lowest station."""
    choice = None
    for action in row:
        if choice is None or row[action] > row[choice]:
            choice = action
    return choice


def learn(graph, setting, draw, moves, after_move):
    alpha, gamma, nu_limit, rho_limit = setting
    table = table_of(graph)
    stations = list(table)
    s = None
    for move in range(1, moves + 1):
        rho = draw()
        nu = draw()
        if s is None or nu < nu_limit:
            s = stations[int(draw() * len(stations))]
        actions = list(table[s])
        a = actions[int(draw() * len(actions))] if rho < rho_limit else best(table[s])
        r = 50 if a == graph["goal"] else 0
        q = table[s][a]
        max_q = table[a][best(table[a])]
        table[s][a] = (1 - alpha) * q + alpha * (r + gamma * max_q)
        s = a
        after_move(move, table)


def shown_way(graph, table):
    way = [graph["start"]]
    while way[-1] != graph["goal"]:
        step = best(table[way[-1]])
        if step in way:
            return None
        way.append(step)
    return way


def xoshiro128(state):
    """xoshiro128** 1.1 of Blackman and Vigna; an output of 32 bits makes one number from 0 to 1."""
    mask = 0xFFFFFFFF
    s = list(state)

    def rotate(x, k):
        return ((x << k) | (x >> (32 - k))) & mask

    def word():
        result = rotate(s[1] * 5 & mask, 7) * 9 & mask
        t = s[1] << 9 & mask
        s[2] ^= s[0]
        s[3] ^= s[1]
        s[1] ^= s[2]
        s[0] ^= s[3]
        s[2] ^= t
        s[3] = rotate(s[3], 11)
        return result

    return lambda: word() / 2**32


def opened(name, setting, seed):
    state = [random.Random(f"{seed} {word}").getrandbits(32) for word in range(4)]
    tables = []

    def keep(_, table):
        tables.append([value for row in table.values() for value in row.values()])

    learn(graphs[name], setting, xoshiro128(state), 60, keep)
    return {"map": name, "setting": setting, "stream": state, "tables": tables}


def share(job):
    name, setting = job
    graph = graphs[name]
    hits = [0] * len(AFTER)
    source = random.Random(f"{name} {setting}")
    for _ in range(RUNS):

        def look(move, table):
            if move in AFTER:
                way = shown_way(graph, table)
                hits[AFTER.index(move)] += way is not None and len(way) == graph["shortest"]

        learn(graph, setting, source.random, AFTER[-1], look)
    return {"map": name, "setting": setting, "runs": RUNS, "shortest": hits}


if __name__ == "__main__":
    moves = [opened(name, setting, f"{name} {setting}") for name in graphs for setting in SETTINGS[::5]]
    with Pool() as pool:
        shares = pool.map(share, [(name, setting) for name in graphs for setting in SETTINGS], chunksize=1)
    out = {"after": AFTER, "moves": moves, "shares": shares}
    (here / "study.json").write_text(json.dumps(out) + "\n")
