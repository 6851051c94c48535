"""Adds to each data set of elbows.json what scikit-learn's KMeans gives as the least inertia of 1 to 6 groups, out of 200
starts. The points are those of the sorting playground (its tests compare). Run: python3 elbows.py (scikit-learn 1.9)."""

import json
import pathlib

from sklearn.cluster import KMeans

file = pathlib.Path(__file__).with_name("elbows.json")
sets = json.loads(file.read_text())
for one in sets.values():
    one["inertia"] = [
        KMeans(groups, n_init=200, random_state=2026, tol=0).fit(one["points"]).inertia_ for groups in range(1, 7)
    ]
file.write_text(json.dumps(sets) + "\n")
