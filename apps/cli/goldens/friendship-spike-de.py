# friendship. Gemacht mit Botgarten.
# Für einen Hub von SPIKE Prime mit Pybricks.
# Port B: Motor vom rechten Rad
# Port C: Motor vom linken Rad
# Port D: Abstandssensor
# Port E: Abstandssensor
from pybricks.parameters import Direction, Port
from pybricks.pupdevices import Motor, UltrasonicSensor
from pybricks.tools import wait

# Was gelernt wurde: die Gewichte vom neuronalen Netz
WEIGHTS_LEFT = [0.8, 0]
WEIGHTS_RIGHT = [0, 0.8]

left_eye = UltrasonicSensor(Port.D)
right_eye = UltrasonicSensor(Port.E)
right_motor = Motor(Port.B)
left_motor = Motor(Port.C, Direction.COUNTERCLOCKWISE)


def distance(eye):
    # In cm, höchstens 100
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
    # Bei 100 Prozent dreht sich ein Rad zweimal in der Sekunde.
    return cut(percent) * 7.2


while True:
    inputs = [distance(left_eye), distance(right_eye)]
    left, right = think(inputs)
    left_motor.run(speed(left))
    right_motor.run(speed(right))
    wait(10)
