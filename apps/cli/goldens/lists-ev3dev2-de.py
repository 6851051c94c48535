#!/usr/bin/env python3
# composed__common__listOperations. Gemacht mit Botgarten.
# Für einen EV3 mit ev3dev.
from math import sqrt


def first_place(entries, wanted):
    return entries.index(wanted) if wanted in entries else -1


def last_place(entries, wanted):
    for place in range(len(entries) - 1, -1, -1):
        if entries[place] == wanted:
            return place
    return -1


def part_of(entries, first, last):
    if first < 0:
        first += len(entries)
    if last < 0:
        last += len(entries)
    return entries[first : last + 1]


def mean(numbers):
    return sum(numbers) / len(numbers)


def median(numbers):
    ordered = sorted(numbers)
    middle = len(ordered) // 2
    if len(ordered) % 2 == 1:
        return ordered[middle]
    return (ordered[middle - 1] + ordered[middle]) / 2


def deviation(numbers):
    middle = mean(numbers)
    return sqrt(mean([(number - middle) ** 2 for number in numbers]))


input_ = [1, 2, 3, 4, 3]
input2 = []
result = 0
result = len(input_)
result = result + len(input2)
if len(input_) == 0:
    result = result + 1
else:
    result = result + 2
if len(input2) == 0:
    result = result + 1
else:
    result = result + 2
# 8
result = result + first_place(input_, 3)
result = result + last_place(input_, 3)
# 14
result = result + input_[1]
result = result + input_[-2]
result = result + input_[0]
result = result + input_[-1]
# 24
result = result + input_.pop(1)
result = result + input_.pop(-2)
result = result + input_.pop(0)
result = result + input_.pop()
result = result + len(input_)
# 35
input_.insert(0, 1)
input_.insert(-2, 2)
input_.insert(0, 0)
input_.append(4)
result = result + len(input_)
# 40
input_.pop(1)
input_.pop(-2)
input_.pop(0)
input_.pop()
result = result + len(input_)
result = result + input_[-1]
# 42
input_.insert(0, 1)
input_.insert(-2, 2)
input_.insert(0, 0)
input_.append(4)
input_[2] = 3
input_[1] = 2
input_[-2] = 4
input_[0] = 1
input_[-1] = 5
result = result + sum(input_)
# 57
result = result + sum(part_of(input_, 1, 3))
result = result + sum(part_of(input_, 1, -2))
result = result + sum(part_of(input_, 1, -1))
# 89
result = result + sum(part_of(input_, -4, 4))
result = result + sum(part_of(input_, -5, -4))
result = result + sum(part_of(input_, -4, -1))
# 120
result = result + sum(part_of(input_, 0, 3))
result = result + sum(part_of(input_, 0, -4))
result = result + sum(part_of(input_, 0, -1))
# 148
result = result + min(input_)
result = result + max(input_)
# 154
result = result + mean(input_)
result = result + median(input_)
result = result + deviation(input_)
# 161.414...
# 161.414 - sim, 161.5 - board, OK
