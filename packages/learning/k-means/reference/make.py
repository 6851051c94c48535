"""Writes clusterings.json: 100 data sets and what scikit-learn's k_means gives for them. Run: python3 make.py
(scikit-learn 1.9, NumPy 2)."""

import json
import pathlib
import warnings

import numpy as np
from sklearn.cluster import k_means
from sklearn.datasets import make_blobs, make_moons

warnings.simplefilter("ignore")
draw = np.random.default_rng(2026)


def data(case):
    count, features = int(draw.integers(8, 60)), int(draw.integers(1, 5))
    if case % 5 == 0:
        return make_moons(count, noise=0.1, random_state=case)[0]
    if case % 5 == 1:
        return draw.integers(0, 6, size=(count, features)).astype(float) + draw.uniform(0, 1e-3, (count, features))
    return make_blobs(count, features, centers=int(draw.integers(1, 6)), random_state=case)[0]


def case(index):
    points = data(index).round(6)
    groups = int(draw.integers(1, min(7, len(points))))
    # Every fourth start has a centre far out: it stays empty and has to be moved.
    start = points[draw.choice(len(points), groups, replace=False)].copy()
    if index % 4 == 0:
        start[-1] += 1000
    centres, labels, inertia, iterations = k_means(
        points, groups, init=start, n_init=1, algorithm="lloyd", tol=0, return_n_iter=True
    )
    return {
        "empty": index % 4 == 0,
        "points": points.tolist(),
        "start": start.tolist(),
        "centres": centres.tolist(),
        "labels": labels.tolist(),
        "inertia": float(inertia),
        "iterations": int(iterations),
    }


cases = [case(index) for index in range(100)]
pathlib.Path(__file__).with_name("clusterings.json").write_text(json.dumps(cases) + "\n")
