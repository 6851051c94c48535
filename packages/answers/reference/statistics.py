"""Reference values by pandas and SciPy: python statistics.py > statistics.json

Every p is exact over all signs: scipy.stats.wilcoxon with PermutationMethod (SciPy 1.15 or newer), zeros dropped.
"""
import json

import numpy as np
import pandas as pd
from scipy.stats import PermutationMethod, rankdata, wilcoxon

random = np.random.default_rng(2020)


def counted(values):
    series = pd.Series(values)
    counts = series.value_counts().reindex(range(1, 6), fill_value=0)
    return {
        "counts": counts.tolist(),
        "mean": series.mean(),
        "median": series.median(),
        "shares": (counts / len(series)).tolist(),
    }


def tested(differences):
    moved = np.array([one for one in differences if one != 0])
    exact = wilcoxon(moved, method=PermutationMethod(n_resamples=np.inf))
    ranks = rankdata(np.abs(moved))
    plus, minus = float(ranks[moved > 0].sum()), float(ranks[moved < 0].sum())
    return {
        "differences": [int(one) for one in differences],
        "n": len(moved),
        "plus": plus,
        "minus": minus,
        "p": float(exact.pvalue),
        "r": (plus - minus) / (plus + minus),
    }


counts = [counted(random.integers(1, 6, size)) for size in (1, 2, 5, 6, 7, 10, 22, 23, 240)]
small = [random.integers(-3, 4, size) for size in (5, 6, 8, 10, 12, 15, 18)]
risen = [random.integers(-1, 4, size) for size in (6, 9, 12, 16)]
plain = [[1, 2, 3, 4, 5], [-1, 2, -3, 4, 5, 6], [1, 1, 1, 1, 1, 1], [0, 0, 2, -2, 0, 1, 1]]
tests = [tested(one) for one in [*plain, *small, *risen]]
print(json.dumps({"counts": counts, "tests": tests}, indent=1))
