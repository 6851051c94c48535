"""Milliseconds an iteration of scikit-learn's Lloyd on one thread, and what it found, to compare.

python3 peer.py ROUNDS < {"points", "start"}; prints {"ms", "iterations", "labels"}."""

import json
import os
import sys
import time

for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ[name] = "1"

import numpy as np
from sklearn.cluster import k_means

rounds = int(sys.argv[1])
task = json.load(sys.stdin)
points, start = np.array(task["points"]), np.array(task["start"])
settings = {"init": start, "n_init": 1, "algorithm": "lloyd", "tol": 0, "return_n_iter": True, "random_state": 0}
k_means(points, len(start), **settings)
before = time.process_time()
for _ in range(rounds):
    _, labels, _, iterations = k_means(points, len(start), **settings)
spent = time.process_time() - before
print(json.dumps({"ms": 1000 * spent / rounds / iterations, "iterations": iterations, "labels": labels.tolist()}))
