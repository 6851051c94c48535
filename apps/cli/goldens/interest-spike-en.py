# interest. Made with Botgarten.
# For a SPIKE Prime hub with Pybricks.
# Port A: color sensor
# Port B: motor of the right wheel
# Port C: motor of the left wheel
from pybricks.hubs import PrimeHub
from pybricks.parameters import Color, Direction, Port
from pybricks.pupdevices import ColorSensor, Motor
from pybricks.robotics import DriveBase
from pybricks.tools import wait
from umath import pi

# What was learned: the weights of the neural network
WEIGHTS_A = [1, 0, 0]
WEIGHTS_B = [0, 1, 0]
WEIGHTS_C = [0, 0, 1]

hub = PrimeHub()
color_sensor = ColorSensor(Port.A)
color_sensor.detectable_colors(
    [
        Color.BLACK,
        Color.BLUE,
        Color.GREEN,
        Color.YELLOW,
        Color.RED,
        Color.WHITE,
        Color.BROWN,
        Color.NONE,
    ]
)
right_motor = Motor(Port.B)
left_motor = Motor(Port.C, Direction.COUNTERCLOCKWISE)
robot = DriveBase(left_motor, right_motor, wheel_diameter=56, axle_track=180)
shown = [""]


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


def sees(sensor, color):
    return 100 if sensor.color() == color else 0


def total(inputs, weights):
    result = 0
    for value, weight in zip(inputs, weights):
        result += value * weight
    return result


def think(inputs):
    a = total(inputs, WEIGHTS_A)
    b = total(inputs, WEIGHTS_B)
    c = total(inputs, WEIGHTS_C)
    return a, b, c


def highest(choices):
    # Of those above 0 the highest; of equals the first
    best, chosen = 0, None
    for level, what in choices:
        if level > best:
            best, chosen = level, what
    return chosen


def show(text):
    # A letter or a number up to 99 stands, a longer text goes by.
    if text == shown[0]:
        return
    shown[0] = text
    if len(text) == 1:
        hub.display.char(text)
    elif len(text) == 2 and text.isdigit():
        hub.display.number(int(text))
    else:
        hub.display.text(text)


def turn(percent, degrees):
    if percent * degrees == 0:
        stop()
        return
    robot.settings(turn_rate=abs(speed(percent)) * 56 / 180)
    robot.turn(degrees if percent > 0 else -degrees)


while True:
    for _ in range(58):
        straight(50, 5)
        inputs = [
            sees(color_sensor, Color.RED),
            sees(color_sensor, Color.YELLOW),
            sees(color_sensor, Color.GREEN),
        ]
        a, b, c = think(inputs)
        show(highest([(a, "A"), (b, "B"), (c, "C")]) or "-")
        wait(10)
    turn(50, 180)
    wait(10)
