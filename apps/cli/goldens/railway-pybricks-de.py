# railway. Gemacht mit Botgarten.
# Für einen EV3 mit Pybricks 4.
# Port 1: Farbsensor
# Port B: Motor vom rechten Rad
# Port C: Motor vom linken Rad
from pybricks.ev3devices import ColorSensor, Motor
from pybricks.parameters import Color, Port
from pybricks.tools import wait

# Der beste Weg: Station, Drehung in Grad (rechts ist über 0), Strecke in cm
BEST_WAY = [(3, 0, 202.06), (5, 65.92, 90.33), (0, 44.21, 111.54), (1, 0, 0)]
# Alles Gelernte: von einer Station zur nächsten, und was das wert ist
Q_TABLE = {
    0: {1: 50, 5: 32},
    1: {0: 0, 2: 0},
    2: {1: 49.61},
    3: {4: 25.6, 5: 32},
    4: {3: 25.59, 5: 32},
    5: {0: 40, 3: 25.6, 4: 25.6},
}

color_sensor = ColorSensor(Port.S1)
right_motor = Motor(Port.B)
left_motor = Motor(Port.C)


def stop():
    left_motor.brake()
    right_motor.brake()


def cut(percent):
    return max(-100, min(100, percent))


def speed(percent):
    # Bei 100 Prozent dreht sich ein Rad zweimal in der Sekunde.
    return cut(percent) * 7.2


# Auf dem echten Boden zeichnest du den Weg selbst.
while True:
    if color_sensor.color() == Color.RED:
        stop()
    elif color_sensor.reflection() > 50:
        left_motor.run(speed(30))
        right_motor.run(speed(0))
    else:
        left_motor.run(speed(0))
        right_motor.run(speed(30))
    wait(10)
