"""Writes ../powers.ts: 2^(j/32) in two doubles, and ln 2 / 32 cut into parts.

    pip install mpmath==1.4.1
    python3 packages/numbers/reference/make-powers.py
"""

from pathlib import Path

from mpmath import floor, log, mp, mpf, power

mp.prec = 400
STEPS = 32


def cut(value, bits):
    """The upper `bits` bits of a positive number."""
    scale = mpf(2) ** (bits - int(floor(log(value, 2))) - 1)
    return floor(value * scale) / scale


def two_doubles(value):
    high = float(value)
    return high, float(value - mpf(high))


step = log(2) / STEPS
upper = cut(step, 36)
powers = [two_doubles(power(2, mpf(j) / STEPS)) for j in range(STEPS)]
lines = [
    "// Written by reference/make-powers.py. Do not edit.",
    "/** ln 2 / 32 in two parts; the first has 36 bits, so that whole multiples of it up to 2^17 are exact. */",
    f"export const STEP = [{float(upper)!r}, {float(step - upper)!r}] as const",
    f"export const STEPS_PER_ONE = {float(1 / step)!r}",
    "/** 2^(j/32) for j = 0..31, the nearest doubles and what is left. */",
    f"export const POWERS_HI = [{', '.join(repr(high) for high, _ in powers)}] as const",
    f"export const POWERS_LO = [{', '.join(repr(low) for _, low in powers)}] as const",
]
(Path(__file__).parent.parent / "powers.ts").write_text("\n".join(lines) + "\n")
