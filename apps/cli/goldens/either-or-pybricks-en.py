# either-or. Made with Botgarten.
# For an EV3 with Pybricks 4.
# Port 1: color sensor
# Port B: motor of the right wheel
# Port C: motor of the left wheel
from pybricks.ev3devices import ColorSensor, Motor
from pybricks.hubs import EV3Brick
from pybricks.parameters import Color, Port
from pybricks.robotics import DriveBase
from pybricks.tools import wait
from umath import pi

# What was learned: the weights of the neural network
HIDDEN_WEIGHTS = [[0.6, -1], [-1, 0.6]]
HIDDEN_BIASES = [0, 0]
WEIGHTS_GREEN = [1, 1]

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


def total(inputs, weights):
    result = 0
    for value, weight in zip(inputs, weights):
        result += value * weight
    return result


def layer(inputs, weights, biases):
    sums = []
    for row, bias in zip(weights, biases):
        sums.append(total(inputs, row) + bias)
    return sums


def relu(value):
    return max(0, value)


def think(inputs):
    hidden = [relu(value) for value in layer(inputs, HIDDEN_WEIGHTS, HIDDEN_BIASES)]
    return total(hidden, WEIGHTS_GREEN)


def highest(choices):
    # Of those above 0 the highest; of equals the first
    best, chosen = 0, None
    for level, what in choices:
        if level > best:
            best, chosen = level, what
    return chosen


def lamp(color):
    if color is None:
        ev3.light.off()
    else:
        ev3.light.on(color)


def turn(percent, degrees):
    if percent * degrees == 0:
        stop()
        return
    robot.settings(turn_rate=abs(speed(percent)) * 56 / 180)
    robot.turn(degrees if percent > 0 else -degrees)


while True:
    for _ in range(44):
        straight(50, 5)
        inputs = [color_sensor.rgb()[0], color_sensor.rgb()[2]]
        green = think(inputs)
        lamp(highest([(green, Color.GREEN)]))
        wait(10)
    turn(50, 180)
    wait(10)
