import brick
from math import floor


def random():
    return brick.random()


def randint(a, b):
    return a + floor(brick.random() * (b - a + 1))


def choice(sequence):
    return sequence[floor(brick.random() * len(sequence))]
