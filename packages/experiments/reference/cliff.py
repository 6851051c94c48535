"""Writes cliff.json: online returns of Q-learning and SARSA on the cliff of Sutton & Barto, 2nd edition, example 6.6, over 500
episodes, by a loop of its own over NumPy arrays. alpha 0.5, gamma 1, epsilon 0.1; an episode has at most 20 x 48 moves, and
one that is stopped by that does not end the value; of equally good moves one by chance; exploring takes any of the four.
Means over all runs, with their standard errors, in ten blocks of 50 episodes. Needs NumPy: python3 cliff.py"""

import json
import pathlib

import numpy as np

ROWS, COLUMNS = 4, 12
STATES, START, GOAL = ROWS * COLUMNS, 36, 47
MOVES = [(0, -1), (1, 0), (0, 1), (-1, 0)]
ALPHA, GAMMA, EPSILON = 0.5, 1.0, 0.1
EPISODES, BLOCKS, RUNS, LIMIT = 500, 10, 400, 20 * STATES


def table():
    to = np.zeros((STATES, 4), dtype=int)
    reward = np.full((STATES, 4), -1.0)
    for state in range(STATES):
        for action, (down, right) in enumerate(MOVES):
            row = min(ROWS - 1, max(0, state // COLUMNS + down))
            column = min(COLUMNS - 1, max(0, state % COLUMNS + right))
            to[state, action] = row * COLUMNS + column
            if row == ROWS - 1 and 0 < column < COLUMNS - 1:
                to[state, action], reward[state, action] = START, -100.0
    return to, reward


def choose(random, values):
    if random.random() < EPSILON:
        return random.integers(4)
    return random.choice(np.flatnonzero(values == values.max()))


def run(random, to, reward, sarsa):
    q = np.zeros((STATES, 4))
    returns = np.zeros(EPISODES)
    falls = np.zeros(EPISODES)
    for episode in range(EPISODES):
        state = START
        action = choose(random, q[state])
        for _ in range(LIMIT):
            after, paid = to[state, action], reward[state, action]
            returns[episode] += paid
            falls[episode] += paid == -100.0
            following = choose(random, q[after]) if sarsa else None
            worth = 0.0 if after == GOAL else q[after, following] if sarsa else q[after].max()
            q[state, action] += ALPHA * (paid + GAMMA * worth - q[state, action])
            state = after
            if state == GOAL:
                break
            action = following if sarsa else choose(random, q[state])
    return returns, falls


def summary(rows):
    blocks = rows.reshape(RUNS, BLOCKS, -1).mean(axis=2)
    error = blocks.std(axis=0, ddof=1) / np.sqrt(RUNS)
    return {"mean": blocks.mean(axis=0).tolist(), "error": error.tolist()}


def main():
    to, reward = table()
    result = {"runs": RUNS, "episodes": EPISODES, "blocks": BLOCKS, "numpy": np.__version__}
    for seed, name in enumerate(["q", "sarsa"]):
        random = np.random.default_rng(2026 + seed)
        returns, falls = map(np.array, zip(*(run(random, to, reward, name == "sarsa") for _ in range(RUNS))))
        result[name] = {"returns": summary(returns), "falls": summary(falls)}
    file = pathlib.Path(__file__).with_name("cliff.json")
    file.write_text(json.dumps(result, indent=2) + "\n")


main()
