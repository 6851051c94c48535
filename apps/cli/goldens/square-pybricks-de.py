# square. Gemacht mit Botgarten.
# Für einen EV3 mit Pybricks 4.
# Port B: Motor vom rechten Rad
# Port C: Motor vom linken Rad
from pybricks.ev3devices import Motor
from pybricks.parameters import Port
from pybricks.robotics import DriveBase
from pybricks.tools import wait
from umath import pi

right_motor = Motor(Port.B)
left_motor = Motor(Port.C)
robot = DriveBase(left_motor, right_motor, wheel_diameter=56, axle_track=180)


def stop():
    left_motor.brake()
    right_motor.brake()


def cut(percent):
    return max(-100, min(100, percent))


def speed(percent):
    # Bei 100 Prozent dreht sich ein Rad zweimal in der Sekunde.
    return cut(percent) * 7.2


def straight(percent, cm):
    # Das Vorzeichen von percent und cm entscheidet über vor und zurück.
    if percent * cm == 0:
        stop()
        return
    robot.settings(straight_speed=abs(speed(percent)) * pi * 56 / 360)
    robot.straight(cm * 10 if percent > 0 else -cm * 10)


def turn(percent, degrees):
    if percent * degrees == 0:
        stop()
        return
    robot.settings(turn_rate=abs(speed(percent)) * 56 / 180)
    robot.turn(degrees if percent > 0 else -degrees)


for _ in range(4):
    straight(50, 120)
    turn(-50, 90)
    wait(10)
