"""What a colour sensor names on every side of every boundary of the rules in the spec (robot-and-world.md, "Body").

Rules, h 0-360, s and v 0-100, first match: v <= 10 black; (h < 10 or h > 350) and s > 90 and v > 50 red; 40 < h < 70,
s > 90, v > 50 yellow; h < 50, 50 < s < 100, v < 50 brown; s < 10, v > 90 white; 70 < h < 160, s > 80 green;
200 < h < 250, s > 90, v > 50 blue; ours: s < 10 (and middle v) grey. Exact fractions of whole 0..255 channels, so that
"on the boundary" is on it. Run: python3 packages/simulation/reference/colours.py
"""

import json
from fractions import Fraction as F
from itertools import product
from pathlib import Path


def hsv(r, g, b):
    most, least = max(r, g, b), min(r, g, b)
    span = most - least
    s = F(0) if most == 0 else F(100 * span, most)
    if span == 0:
        h = F(0)
    elif most == r:
        h = (F(60 * (g - b), span)) % 360
    elif most == g:
        h = F(60 * (b - r), span) + 120
    else:
        h = F(60 * (r - g), span) + 240
    return h, s, F(100 * most, 255)


def name(r, g, b):
    h, s, v = hsv(r, g, b)
    if v <= 10:
        return "black"
    if (h < 10 or h > 350) and s > 90 and v > 50:
        return "red"
    if 40 < h < 70 and s > 90 and v > 50:
        return "yellow"
    if h < 50 and 50 < s < 100 and v < 50:
        return "brown"
    if s < 10 and v > 90:
        return "white"
    if 70 < h < 160 and s > 80:
        return "green"
    if 200 < h < 250 and s > 90 and v > 50:
        return "blue"
    if s < 10:
        return "grey"
    return None


def rgb(h, s, v):
    """The nearest whole channels to a hue, saturation and value."""
    c = v / 100 * s / 100
    x = c * (1 - abs((h / 60) % 2 - 1))
    m = v / 100 - c
    r, g, b = [(c, x, 0), (x, c, 0), (0, c, x), (0, x, c), (x, 0, c), (c, 0, x)][int(h / 60) % 6]
    return tuple(max(0, min(255, round((part + m) * 255))) for part in (r, g, b))


HUES = [0, 10, 40, 50, 70, 160, 200, 250, 350]
SATURATIONS = [0, 10, 50, 80, 90, 100]
VALUES = [0, 10, 50, 90, 100]
CANONICAL = ["#000000", "#B30006", "#F7D117", "#532115", "#FFFFFF", "#00642E", "#0057A6", "#585858"]


def near(edges, step, low, high):
    return sorted({min(high, max(low, edge + d)) for edge in edges for d in (-step, 0, step)})


def samples():
    """Around every crossing of boundaries, and around each canonical colour by one in every channel."""
    found = set()
    for h, s, v in product(near(HUES, 2, 0, 359), near(SATURATIONS, 1.5, 0, 100), near(VALUES, 1.5, 0, 100)):
        found.add(rgb(h, s, v))
    for colour in CANONICAL:
        channels = [int(colour[k : k + 2], 16) for k in (1, 3, 5)]
        for d in product((-1, 0, 1), repeat=3):
            found.add(tuple(max(0, min(255, c + e)) for c, e in zip(channels, d)))
    return sorted(found)


if __name__ == "__main__":
    rows = [["#%02X%02X%02X" % sample, name(*sample)] for sample in samples()]
    lines = ",\n".join("  " + json.dumps(row) for row in rows)
    Path(__file__).with_name("colours.json").write_text("[\n" + lines + "\n]\n")
    by_name = {}
    for _, seen in rows:
        by_name[seen] = by_name.get(seen, 0) + 1
    print(len(rows), "colours:", by_name)
