"""Writes clusterings.json: 100 data sets whose groups never stay empty, with what scikit-learn's k_means gives for
them, and 60 more (empty groups, the other distances) with what the obvious loop of model.md gives, written down here
once more from its rules. Run: python3 make.py (scikit-learn 1.9, NumPy 2)."""

import json
import math
import pathlib
import warnings

import numpy as np
from sklearn.cluster import k_means
from sklearn.datasets import make_blobs, make_moons

warnings.simplefilter("ignore")
draw = np.random.default_rng(2026)


def far(a, b, distance):
    """What labels are chosen by: squared for straight distances."""
    if distance == "manhattan":
        total = 0.0
        for x, y in zip(a, b):
            total += abs(x - y)
        return total
    if distance == "euclidean":
        total = 0.0
        for x, y in zip(a, b):
            total += (x - y) * (x - y)
        return total
    product, own, other = 0.0, 0.0, 0.0
    for x, y in zip(a, b):
        product += x * y
        own += x * x
        other += y * y
    return 1.0 if own == 0 or other == 0 else 1 - product / (math.sqrt(own) * math.sqrt(other))


def direction(point):
    length = 0.0
    for x in point:
        length += x * x
    return [0.0 if length == 0 else (1 / math.sqrt(length)) * x for x in point]


def middle(members, distance):
    if distance == "manhattan":
        columns = [sorted(column) for column in zip(*members)]
        half = len(members) // 2
        return [c[half] if len(c) % 2 else (c[half - 1] + c[half]) / 2 for c in columns]
    rows = [direction(m) for m in members] if distance == "cosine" else members
    sums = [0.0] * len(rows[0])
    for row in rows:
        for feature, value in enumerate(row):
            sums[feature] += value
    return [total / len(rows) for total in sums]


def loop(points, start, distance):
    """Lloyd's algorithm as model.md says it, one rule a line. Also says whether a group was ever empty."""
    centres, labels, inertia, ever_empty = [list(c) for c in start], None, [], False
    for iteration in range(1, 301):
        before = labels
        away = [[far(p, c, distance) for c in centres] for p in points]
        labels = [row.index(min(row)) for row in away]
        total = 0.0
        for row in away:
            total += min(row)
        inertia.append(total)
        if labels == before:
            break
        own = list(labels)
        empty = [g for g in range(len(centres)) if g not in labels]
        ever_empty = ever_empty or bool(empty)
        farthest = sorted(range(len(points)), key=lambda p: (-away[p][labels[p]], p))
        if away[farthest[0]][labels[farthest[0]]] > 0:
            for group, point in zip(empty, farthest):
                own[point] = group
        groups = [[p for p, g in zip(points, own) if g == group] for group in range(len(centres))]
        centres = [middle(members, distance) if members else centre for members, centre in zip(groups, centres)]
    return {"centres": centres, "labels": labels, "inertia": inertia, "iterations": iteration}, ever_empty


def data(kind):
    count, features = int(draw.integers(8, 60)), int(draw.integers(1, 5))
    seed = int(draw.integers(1 << 30))
    if kind % 5 == 0:
        return make_moons(count, noise=0.1, random_state=seed)[0]
    if kind % 5 == 1:
        return draw.integers(0, 6, size=(count, features)).astype(float) + draw.uniform(0, 1e-3, (count, features))
    return make_blobs(count, features, centers=int(draw.integers(1, 6)), random_state=seed)[0]


def problem(kind, far_out):
    points = data(kind).round(6)
    groups = int(draw.integers(2 if far_out else 1, min(7, len(points))))
    start = points[draw.choice(len(points), groups, replace=False)].copy()
    # A centre far out stays empty and has to be moved.
    if far_out:
        start[-1] += 1000
    return points, start


def by_library():
    """100 sets on which no group is ever empty: scikit-learn's answer."""
    found = []
    while len(found) < 100:
        points, start = problem(len(found), far_out=False)
        if loop(points.tolist(), start.tolist(), "euclidean")[1]:
            continue
        centres, labels, inertia, iterations = k_means(
            points, len(start), init=start, n_init=1, algorithm="lloyd", tol=0, return_n_iter=True
        )
        answer = {"centres": centres.tolist(), "labels": labels.tolist(), "inertia": float(inertia)}
        found.append({"points": points.tolist(), "start": start.tolist(), **answer, "iterations": int(iterations)})
    return found


def by_loop(distance, far_out):
    """20 sets with the answer of the loop; with `far_out` every one of them has had an empty group."""
    found = []
    while len(found) < 20:
        points, start = problem(len(found), far_out)
        answer, empty = loop(points.tolist(), start.tolist(), distance)
        if empty == far_out:
            found.append({"points": points.tolist(), "start": start.tolist(), "distance": distance, **answer})
    return found


cases = {
    "scikit": by_library(),
    "empty": by_loop("euclidean", True),
    "others": by_loop("manhattan", False) + by_loop("cosine", False) + by_loop("manhattan", True),
}
text = "{\n" + ",\n".join(
    f'"{name}": [\n' + ",\n".join(json.dumps(row, separators=(",", ":")) for row in rows) + "\n]"
    for name, rows in cases.items()
) + "\n}\n"
pathlib.Path(__file__).with_name("clusterings.json").write_text(text)
