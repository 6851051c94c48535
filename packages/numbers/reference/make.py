"""Writes coefficients.ts and the reference data of this room's tests.

    pip install mpmath==1.3.0 mmh3==5.1.0
    python3 packages/numbers/reference/make.py

Every reference value is [hi, lo]: hi is the double nearest to the true value, hi + lo the true value to about
106 bits. mpmath works at 1,400 bits here, enough for the largest doubles. Hashes: mmh3 (Austin Appleby's C++ code).
"""

import json
import math
import random
import struct
from pathlib import Path

import mmh3
from mpmath import atan, atan2, chebyfit, cos, mp, mpf, pi, sin, sqrt

mp.prec = 1400
HERE = Path(__file__).parent
random.seed(20261121)


def split(value):
    hi = float(value)
    return [hi, float(value - mpf(hi))]


def write(name, data):
    rows = ",\n".join(json.dumps(row) for row in data)
    (HERE / name).write_text(f"[\n{rows}\n]\n")


# ---- coefficients: near-minimax fits on the reduced ranges ----


def fit(function, end, terms):
    old, mp.prec = mp.prec, 300
    found = [float(c) for c in reversed(chebyfit(function, [mpf(2) ** -60, end], terms))]
    mp.prec = old
    return found


def sine(z):
    return (sin(sqrt(z)) / sqrt(z) - 1) / z


def cosine(z):
    return (cos(sqrt(z)) - 1 + z / 2) / z**2


def arctangent(z):
    return (atan(sqrt(z)) / sqrt(z) - 1) / z


def pieces(value, bits, count):
    """Cuts a constant into `count` parts of `bits` bits and a last one of 53."""
    parts, left = [], mpf(value)
    for index in range(count):
        unit = mpf(2) ** (1 - bits * (index + 1))
        part = mp.floor(left / unit) * unit
        parts.append(float(part))
        left -= part
    return [*parts, float(left)]


def typescript():
    eighth = (pi / 4) ** 2 * mpf("1.0001")
    lines = [
        "// Written by reference/make.py: near-minimax fits and constants cut into doubles. Do not edit.",
        f"export const SINE = {fit(sine, eighth, 6)} as const",
        f"export const COSINE = {fit(cosine, eighth, 6)} as const",
        f"export const ARCTANGENT = {fit(arctangent, mpf(1) / 81, 7)} as const",
        "/** pi/2 in three parts of 33 bits, so that whole multiples below 2^20 are exact, and the rest. */",
        f"export const HALF_PI_PARTS = {pieces(pi / 2, 33, 3)} as const",
        f"export const HALF_PI_AFTER_TWO = {float(pi / 2 - sum(map(mpf, pieces(pi / 2, 33, 2)[:2])))!r}",
        f"export const TWO_OVER_PI = {float(2 / pi)!r}",
        f"export const HALF_PI = {split(pi / 2)} as const",
        f"export const PI = {split(pi)} as const",
        "/** floor(2/pi * 2^1216) */",
        f"export const TWO_OVER_PI_BITS = BigInt('{hex(int(mp.floor(2 / pi * mpf(2) ** 1216)))}')",
        "/** floor(pi/2 * 2^128) */",
        f"export const HALF_PI_BITS = BigInt('{hex(int(mp.floor(pi / 2 * mpf(2) ** 128)))}')",
        "/** atan(i/32) for i = 0..32, the nearest doubles and what is left. */",
        f"export const ATAN_HI = {[split(atan(mpf(i) / 32))[0] for i in range(33)]} as const",
        f"export const ATAN_LO = {[split(atan(mpf(i) / 32))[1] for i in range(33)]} as const",
    ]
    (HERE.parent / "coefficients.ts").write_text("\n".join(lines) + "\n")


# ---- sin, cos, atan2 ----

SUBNORMAL = 5e-324
LARGEST = 1.7976931348623157e308
# The double that lies nearest to a multiple of pi/2, relatively (Muller, Elementary Functions, 11.3.2).
WORST = 6381956970095103 * 2.0**797


def angles():
    found = [SUBNORMAL, 2.5e-310, 2.2250738585072014e-308, 1e-200, 1e-20, 1e-9, 1e-4, LARGEST, WORST]
    for n in [1, 2, 3, 4, 5, 7, 8, 16, 63, 100, 999, 1000, 12345, 1048575, 1048576, 1048577, 10**9, 10**15]:
        near = float(n * pi / 2)
        found += [near, math.nextafter(near, 0), math.nextafter(near, math.inf), float(n * pi / 4)]
    found += [random.uniform(0, math.pi / 4) for _ in range(80)]
    found += [random.uniform(0, 7) for _ in range(120)]
    found += [random.uniform(0, 3000) for _ in range(120)]
    found += [random.uniform(0, 1.7e6) for _ in range(60)]
    found += [math.ldexp(random.uniform(1, 2), random.randint(-1020, 1023)) for _ in range(150)]
    return [x * random.choice([1, -1]) for x in found]


def points():
    scale = [SUBNORMAL, 2.5e-310, 1e-160, 1e-20, 1.0, 3.0, 1e20, 1e160, LARGEST]
    found = [(y, x) for y in scale for x in scale]
    found += [(random.uniform(0, 1), random.uniform(0, 1)) for _ in range(150)]
    found += [(random.uniform(0, 600), random.uniform(0, 400)) for _ in range(100)]
    found += [(1.0, random.uniform(30, 35) / 32) for _ in range(40)]
    found += [(i / 64, 1.0) for i in range(1, 65)]
    power = lambda: math.ldexp(random.uniform(1, 2), random.randint(-1020, 1023))
    found += [(power(), power()) for _ in range(100)]
    return [(y * random.choice([1, -1]), x * random.choice([1, -1])) for y, x in found]


def truth_atan2(y, x):
    value = split(atan2(mpf(y), mpf(x)))
    # Below the smallest double there is nothing left to split.
    return value


# ---- random streams and hashes ----


def rotl(x, k):
    return ((x << k) | (x >> (32 - k))) & 0xFFFFFFFF


def xoshiro128starstar(s):
    """Blackman & Vigna 2018, https://prng.di.unimi.it/xoshiro128starstar.c (public domain)."""
    result = rotl(s[1] * 5 & 0xFFFFFFFF, 7) * 9 & 0xFFFFFFFF
    t = s[1] << 9 & 0xFFFFFFFF
    s[2] ^= s[0]
    s[3] ^= s[1]
    s[1] ^= s[2]
    s[0] ^= s[3]
    s[2] ^= t
    s[3] = rotl(s[3], 11)
    return result


def uniform(s):
    """53 bits from two outputs, as genrand_res53 of Matsumoto & Nishimura's mt19937ar.c."""
    a, b = xoshiro128starstar(s) >> 5, xoshiro128starstar(s) >> 6
    return (a * 67108864.0 + b) / 9007199254740992.0


def streams():
    rows = []
    for seed in [0, 1, 2, 42, -1, 0.5, 4294967296, 1e300]:
        for name in ["", "noise", "program/Bo", "learn/a/17", "Grüße 🤖", "x" * 31, "y" * 32, "z" * 33]:
            message = struct.pack("<d", seed) + name.encode()
            state = list(struct.unpack("<4I", mmh3.hash_bytes(message, 0, x64arch=False)))
            start = list(state)
            rows.append({"seed": seed, "name": name, "state": start, "draws": [uniform(state) for _ in range(5)]})
    return rows


def fnv1a(data, value=0xCBF29CE484222325):
    """Fowler, Noll, Vo; RFC 9923."""
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return value


def hashes():
    rows = []
    for count in [0, 1, 2, 3, 10, 100]:
        values = [random.choice([random.uniform(-700, 700), 0.0, math.pi / 2, 1e-300, -1e300]) for _ in range(count)]
        rows.append({"values": values, "hash": f"{fnv1a(struct.pack(f'<{count}d', *values)):016x}"})
    return rows


typescript()
write("sin-cos.json", [[x, *split(sin(mpf(x))), *split(cos(mpf(x)))] for x in angles()])
write("atan2.json", [[y, x, *truth_atan2(y, x)] for y, x in points()])
write("streams.json", streams())
write("hashes.json", hashes())
