"""Writes exp-ln.json: what exp, ln, log10, pow and the functions of angles should give.

    pip install mpmath==1.4.1
    python3 packages/numbers/reference/make-exp-ln.py

A row is [name, arguments, hi, lo]: hi is the double nearest to the true value, hi + lo the true value to about 106 bits.
"""

import json
import math
import random
from pathlib import Path

from mpmath import acos, asin, atan, exp, ln, mp, mpf, power, tan, tanh

mp.prec = 1400
random.seed(20261121)
LARGEST = 1.7976931348623157e308


def row(name, truth, *arguments):
    value = truth(*map(mpf, arguments))
    hi = float(value)
    return [name, list(arguments), hi, float(value - mpf(hi))]


def double(low=-1020, high=1023):
    return math.ldexp(random.uniform(1, 2), random.randint(low, high))


def rows():
    for x in [0.0, 1.0, -1.0, 709.78, -708.39, -744.4, 1e-300, -1e-17, 0.5, 88.0]:
        yield row("exp", exp, x)
    for _ in range(150):
        yield row("exp", exp, random.uniform(-708, 709.7))
    for _ in range(50):
        yield row("exp", exp, random.uniform(-2, 2))
    positive = [1.0, 2.0, 10.0, 100.0, 1e15, math.e, 1 + 2**-52, 1 - 2**-53, 5e-324, 2.5e-310, LARGEST, 0.5]
    positive += [10.0**n for n in range(-20, 20)] + [double() for _ in range(120)]
    positive += [random.uniform(0.5, 2) for _ in range(100)]
    for x in positive:
        yield row("ln", ln, x)
        yield row("log10", lambda v: ln(v) / ln(mpf(10)), x)
    pairs = [(2.0, 10.0), (10.0, 300.0), (10.0, -5.0), (2.0, 0.5), (-3.0, 3.0), (-2.0, 4.0), (1.0000001, 1e7), (0.1, 20.0)]
    pairs += [(10.0, float(n)) for n in range(-30, 31)]
    pairs += [(random.uniform(0, 100), random.uniform(-100, 100)) for _ in range(200)]
    pairs += [(random.uniform(-20, 20), float(random.randint(-40, 40))) for _ in range(100)]
    pairs += [(double(-300, 300), random.uniform(-1, 1)) for _ in range(100)]
    for x, y in pairs:
        yield row("pow", power, x, y)
    for x in [1.0, -1.0, 1e-9, 18.7, 21.9, 23.0] + [double(-40, 4) for _ in range(100)] + [random.uniform(-1, 1) for _ in range(100)]:
        yield row("tanh", tanh, x)
    for _ in range(60):
        x = math.copysign(1 - double(-50, -2), random.uniform(-1, 1))
        yield row("asin", asin, x)
        yield row("acos", acos, x)
        yield row("tan", tan, random.uniform(-1000, 1000))
        yield row("tan", tan, double(-30, -2))
    for _ in range(150):
        x = random.uniform(-1, 1)
        yield row("asin", asin, x)
        yield row("acos", acos, x)
        yield row("atan", atan, math.copysign(double(-60, 60), x))
        yield row("tan", tan, random.uniform(-1.5, 1.5))
    # Where the tables of exp.ts go from one entry to the next, and what a network's neurons see.
    for j in range(-40, 41):
        edge = (j + 0.5) * math.log(2) / 32
        for x in [edge, math.nextafter(edge, 9), math.nextafter(edge, -9), edge + random.uniform(-1e-3, 1e-3)]:
            yield row("exp", exp, x)
            yield row("tanh", tanh, x / 2)
    for _ in range(300):
        yield row("exp", exp, random.uniform(-5, 5))
        yield row("tanh", tanh, random.uniform(-3, 3))
        yield row("tanh", tanh, random.uniform(-22, 22))

    # Where the last place hangs on the rest of 1 - x² beyond its double.
    for x in [0.9836072097563746, 0.9937211772403316, 0.9989083154495727, 0.9999229945640644]:
        yield row("asin", asin, x)
        yield row("acos", acos, x)


text = ",\n".join(json.dumps(one) for one in rows())
(Path(__file__).parent / "exp-ln.json").write_text(f"[\n{text}\n]\n")
