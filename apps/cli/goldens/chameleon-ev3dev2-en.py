#!/usr/bin/env python3
# chameleon. Made with Botgarten.
# For an EV3 with ev3dev.
# Port 1: color sensor
# Port B: motor of the right wheel
# Port C: motor of the left wheel
from math import pi
from time import sleep

from ev3dev2.led import Leds
from ev3dev2.motor import OUTPUT_B, OUTPUT_C, MoveTank, SpeedDPS
from ev3dev2.sensor import INPUT_1
from ev3dev2.sensor.lego import ColorSensor

# What was learned: the weights of the neural network
WEIGHTS_GREEN = [1, 0, 0]
WEIGHTS_ORANGE = [0, 1, 0]
WEIGHTS_RED = [0, 0, 1]

leds = Leds()
color_sensor = ColorSensor(INPUT_1)
wheels = MoveTank(OUTPUT_C, OUTPUT_B)


def cut(percent):
    return max(-100, min(100, percent))


def speed(percent):
    # At 100 percent a wheel turns twice a second.
    return SpeedDPS(cut(percent) * 7.2)


def straight(percent, cm):
    # The sign of percent and of cm decides about forward and backward.
    if percent * cm == 0:
        wheels.off()
        return
    degrees = cm / (pi * 5.6) * 360
    wheels.on_for_degrees(speed(percent), speed(percent), degrees)


def sees(sensor, color):
    return 100 if sensor.color == color else 0


def total(inputs, weights):
    result = 0
    for value, weight in zip(inputs, weights):
        result += value * weight
    return result


def think(inputs):
    green = total(inputs, WEIGHTS_GREEN)
    orange = total(inputs, WEIGHTS_ORANGE)
    red = total(inputs, WEIGHTS_RED)
    return green, orange, red


def highest(choices):
    # Of those above 0 the highest; of equals the first
    best, chosen = 0, None
    for level, what in choices:
        if level > best:
            best, chosen = level, what
    return chosen


def lamp(color):
    leds.animate_stop()
    if color is None:
        leds.all_off()
    else:
        leds.set_color("LEFT", color)
        leds.set_color("RIGHT", color)


def turn(percent, angle):
    if percent * angle == 0:
        wheels.off()
        return
    degrees = angle * 18 / 5.6
    wheels.on_for_degrees(speed(percent), speed(-percent), degrees)


while True:
    for _ in range(36):
        straight(50, 5)
        inputs = [
            sees(color_sensor, ColorSensor.COLOR_GREEN),
            sees(color_sensor, ColorSensor.COLOR_YELLOW),
            sees(color_sensor, ColorSensor.COLOR_RED),
        ]
        green, orange, red = think(inputs)
        lamp(highest([(green, "GREEN"), (orange, "AMBER"), (red, "RED")]))
        sleep(0.01)
    turn(50, 180)
    sleep(0.01)
