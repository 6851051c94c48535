# tidy-up. Made with Botgarten.
# For an EV3 with Pybricks 4.
# Port 1: color sensor
# Port B: motor of the right wheel
# Port C: motor of the left wheel
from pybricks.ev3devices import ColorSensor, Motor
from pybricks.hubs import EV3Brick
from pybricks.parameters import Color, Port
from pybricks.robotics import DriveBase
from pybricks.tools import wait
from umath import floor, pi, sqrt

ev3 = EV3Brick()
color_sensor = ColorSensor(Port.S1)
right_motor = Motor(Port.B)
left_motor = Motor(Port.C)
robot = DriveBase(left_motor, right_motor, wheel_diameter=56, axle_track=180)


def stop():
    left_motor.brake()
    right_motor.brake()


def cut(percent):
    return max(-100, min(100, percent))


def speed(percent):
    # At 100 percent a wheel turns twice a second.
    return cut(percent) * 7.2


def straight(percent, cm):
    # The sign of percent and of cm decides about forward and backward.
    if percent * cm == 0:
        stop()
        return
    robot.settings(straight_speed=abs(speed(percent)) * pi * 56 / 360)
    robot.straight(cm * 10 if percent > 0 else -cm * 10)


def rgb(sensor):
    # Pybricks says percent, the blocks 0 to 255.
    return [part * 2.55 for part in sensor.rgb()]


def distance_to(reading, centre):
    return sqrt(sum((a - b) ** 2 for a, b in zip(reading, centre)))


def group_of(reading, centres):
    away = [distance_to(reading, centre) for centre in centres]
    return away.index(min(away)) + 1


def middle_of(readings):
    return [sum(parts) / len(readings) for parts in zip(*readings)]


def moved(centres, readings):
    for _ in range(20):
        groups = [group_of(one, centres) for one in readings]
        for k in range(len(centres)):
            own = [one for one, group in zip(readings, groups) if group == k + 1]
            centres[k] = middle_of(own) if own else centres[k]
    return centres


def nearest(reading, centres):
    return min(distance_to(reading, centre) for centre in centres)


def spread(readings, first, count):
    centres = [first]
    while len(centres) < count:
        centres.append(max(readings, key=lambda one: nearest(one, centres)))
    return centres


def error_of(readings, centres):
    return sum(nearest(one, centres) ** 2 for one in readings)


def find_groups(readings, count):
    # k-means: middles move to their groups.
    best = None
    for first in readings[:10]:
        centres = moved(spread(readings, first, count), readings)
        error = error_of(readings, centres)
        if best is None or error < best[0]:
            best = (error, centres)
    met = []
    for one in readings:
        centre = best[1][group_of(one, best[1]) - 1]
        if centre not in met:
            met.append(centre)
    return met


def drive(left, right):
    left_motor.run(speed(left))
    right_motor.run(speed(right))


def forward(percent):
    drive(percent, percent)


def number_text(number):
    # At most four places after the point
    digits = "{:.4f}".format(round(number, 4) + 0.0)
    return digits.rstrip("0").rstrip(".")


def show(text, column, row):
    # A letter is 10 wide and 16 high.
    x = 10 * max(0, min(16, floor(column + 0.5)))
    y = 16 * max(0, min(7, floor(row + 0.5)))
    ev3.screen.draw_text(x, y, text, background_color=Color.WHITE)


readings = []
centres = []
names = {}
for _ in range(24):
    straight(40, 10)
    readings.append(rgb(color_sensor))
    wait(10)
centres[:] = find_groups(readings, 3)
forward(-25)
while True:
    show(number_text(group_of(rgb(color_sensor), centres)), 0, 0)
    wait(10)
