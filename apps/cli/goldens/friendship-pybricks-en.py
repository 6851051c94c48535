# friendship. Made with Botgarten.
# For an EV3 with Pybricks 4.
# Port 2: distance sensor
# Port 3: distance sensor
# Port B: motor of the right wheel
# Port C: motor of the left wheel
from pybricks.ev3devices import Motor, UltrasonicSensor
from pybricks.parameters import Port
from pybricks.tools import wait

# What was learned: the weights of the neural network
WEIGHTS_LEFT = [0.8, 0]
WEIGHTS_RIGHT = [0, 0.8]

left_eye = UltrasonicSensor(Port.S2)
right_eye = UltrasonicSensor(Port.S3)
right_motor = Motor(Port.B)
left_motor = Motor(Port.C)


def distance(eye):
    # In cm, at most 100
    return min(eye.distance() / 10, 100)


def total(inputs, weights):
    result = 0
    for value, weight in zip(inputs, weights):
        result += value * weight
    return result


def think(inputs):
    left = total(inputs, WEIGHTS_LEFT)
    right = total(inputs, WEIGHTS_RIGHT)
    return left, right


def cut(percent):
    return max(-100, min(100, percent))


def speed(percent):
    # At 100 percent a wheel turns twice a second.
    return cut(percent) * 7.2


while True:
    inputs = [distance(left_eye), distance(right_eye)]
    left, right = think(inputs)
    left_motor.run(speed(left))
    right_motor.run(speed(right))
    wait(10)
