#!/usr/bin/env python3
# friendship. Gemacht mit Botgarten.
# Für einen EV3 mit ev3dev.
# Port 2: Abstandssensor
# Port 3: Abstandssensor
# Port B: Motor vom rechten Rad
# Port C: Motor vom linken Rad
from time import sleep

from ev3dev2.motor import OUTPUT_B, OUTPUT_C, LargeMotor, SpeedDPS
from ev3dev2.sensor import INPUT_2, INPUT_3
from ev3dev2.sensor.lego import UltrasonicSensor

# Was gelernt wurde: die Gewichte vom neuronalen Netz
WEIGHTS_LEFT = [0.8, 0]
WEIGHTS_RIGHT = [0, 0.8]

left_eye = UltrasonicSensor(INPUT_2)
right_eye = UltrasonicSensor(INPUT_3)
right_motor = LargeMotor(OUTPUT_B)
left_motor = LargeMotor(OUTPUT_C)


def distance(eye):
    # In cm, höchstens 100
    return min(eye.distance_centimeters, 100)


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
    return SpeedDPS(cut(percent) * 7.2)


while True:
    inputs = [distance(left_eye), distance(right_eye)]
    left, right = think(inputs)
    left_motor.on(speed(left))
    right_motor.on(speed(right))
    sleep(0.01)
