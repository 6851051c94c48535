# upstream__xNN__action. Gemacht mit Botgarten.
# Für einen EV3 mit Pybricks 4.
# Port A: mittlerer Motor
# Port B: Motor vom rechten Rad
# Port C: Motor vom linken Rad
# Port D: Motor
from pybricks.ev3devices import Motor
from pybricks.hubs import EV3Brick
from pybricks.parameters import Color, Port
from pybricks.robotics import DriveBase
from pybricks.tools import wait
from umath import floor, pi

ev3 = EV3Brick()
motor_a = Motor(Port.A)
right_motor = Motor(Port.B)
left_motor = Motor(Port.C)
motor_d = Motor(Port.D)
robot = DriveBase(left_motor, right_motor, wheel_diameter=56, axle_track=180)

numberVar = 0
booleanVar = True
stringVar = ""
colourVar = Color.WHITE
connectionVar = None
numberList = [0, 0]
booleanList = [True, True]
stringList = ["", ""]
colourList = [Color.WHITE, Color.WHITE]
connectionList = [connectionVar, connectionVar]


def cut(percent):
    return max(-100, min(100, percent))


def speed(percent):
    # Bei 100 Prozent dreht sich ein Rad zweimal in der Sekunde.
    return cut(percent) * 7.2


def number_text(number):
    # Höchstens vier Stellen nach dem Punkt
    digits = "{:.4f}".format(round(number, 4) + 0.0)
    return digits.rstrip("0").rstrip(".")


def show(text, column, row):
    # Ein Buchstabe ist 10 breit und 16 hoch.
    x = 10 * max(0, min(16, floor(column + 0.5)))
    y = 16 * max(0, min(7, floor(row + 0.5)))
    ev3.screen.draw_text(x, y, text, background_color=Color.WHITE)


def stop():
    left_motor.brake()
    right_motor.brake()


def straight(percent, cm):
    # Das Vorzeichen von percent und cm entscheidet über vor und zurück.
    if percent * cm == 0:
        stop()
        return
    robot.settings(straight_speed=abs(speed(percent)) * pi * 56 / 360)
    robot.straight(cm * 10 if percent > 0 else -cm * 10)


def drive_2(left, right):
    left_motor.run(speed(left))
    right_motor.run(speed(right))


def forward(percent):
    drive_2(percent, percent)


def turn(percent, degrees):
    if percent * degrees == 0:
        stop()
        return
    robot.settings(turn_rate=abs(speed(percent)) * 56 / 180)
    robot.turn(degrees if percent > 0 else -degrees)


def spin(percent):
    drive_2(percent, -percent)


def curve(left, right, cm):
    # So weit fährt die Mitte vom Roboter.
    left, right = cut(left), cut(right)
    middle = abs(left + right) / 2 or abs(left)
    if middle * cm == 0:
        stop()
        return
    degrees = cm / (pi * 5.6) * 360 / middle
    if left:
        left_motor.run_angle(speed(left), abs(left) * degrees, wait=False)
    if right:
        right_motor.run_angle(speed(right), abs(right) * degrees, wait=False)
    while not (left_motor.done() and right_motor.done()):
        wait(10)


def tone(hertz, milliseconds):
    if hertz > 0 and milliseconds > 0:
        ev3.speaker.beep(hertz, milliseconds)
    elif milliseconds > 0:
        wait(milliseconds)


def action():
    move()
    drive()
    display()
    sounds()
    lights()


def move():
    motor_a.run(speed(numberVar))
    right_motor.run(speed(numberVar))
    left_motor.run(speed(numberVar))
    motor_d.run(speed(numberVar))
    motor_a.run_angle(speed(numberVar), numberVar * 360)
    motor_a.run_angle(speed(numberVar), numberVar)
    right_motor.run_angle(speed(numberVar), numberVar * 360)
    right_motor.run_angle(speed(numberVar), numberVar)
    left_motor.run_angle(speed(numberVar), numberVar * 360)
    left_motor.run_angle(speed(numberVar), numberVar)
    show(number_text(motor_a.speed() / 7.2), numberVar, numberVar)
    show(number_text(right_motor.speed() / 7.2), numberVar, numberVar)
    show(number_text(left_motor.speed() / 7.2), numberVar, numberVar)
    show(number_text(motor_d.speed() / 7.2), numberVar, numberVar)
    motor_a.run(speed(numberVar))
    right_motor.run(speed(numberVar))
    left_motor.run(speed(numberVar))
    motor_d.run(speed(numberVar))
    motor_a.stop()
    motor_a.brake()
    right_motor.stop()
    right_motor.brake()
    left_motor.stop()
    left_motor.brake()
    motor_d.stop()
    motor_d.brake()


def drive():
    straight(numberVar, numberVar)
    straight(-numberVar, numberVar)
    forward(numberVar)
    forward(-numberVar)
    stop()
    turn(numberVar, numberVar)
    turn(-numberVar, numberVar)
    spin(numberVar)
    spin(-numberVar)
    curve(numberVar, numberVar, numberVar)
    curve(-numberVar, -numberVar, numberVar)
    drive_2(numberVar, numberVar)
    drive_2(-numberVar, -numberVar)


def display():
    show(stringVar, numberVar, numberVar)
    # Der Roboter hat keine Bilder: Hier wird nichts gezeigt.
    ev3.screen.clear()


def sounds():
    tone(numberVar, numberVar)
    ev3.speaker.beep(261.626, 2000)
    ev3.speaker.beep(293.665, 1000)
    ev3.speaker.beep(329.628, 500)
    ev3.speaker.beep(349.228, 250)
    ev3.speaker.beep(391.995, 125)
    ev3.speaker.beep(523, 150)
    ev3.speaker.beep(659, 150)
    ev3.speaker.beep(784, 300)
    ev3.speaker.beep(784, 150)
    ev3.speaker.beep(659, 150)
    ev3.speaker.beep(523, 300)
    ev3.speaker.beep(440, 100)
    ev3.speaker.beep(554, 100)
    ev3.speaker.beep(659, 100)
    ev3.speaker.beep(880, 300)
    ev3.speaker.beep(330, 200)
    ev3.speaker.beep(330, 200)
    ev3.speaker.beep(262, 400)
    ev3.speaker.beep(988, 80)
    ev3.speaker.beep(1319, 400)
    ev3.speaker.volume(numberVar)
    show(number_text(ev3.speaker.volume()), numberVar, numberVar)
    # Der Roboter spricht nur eine Sprache.
    # Mit Pybricks kann der Roboter nicht sprechen: Hier wird nichts gesagt.


def lights():
    ev3.light.on(Color.GREEN)
    ev3.light.blink(Color.GREEN, [500, 500])
    ev3.light.blink(Color.GREEN, [150, 150, 150, 550])
    ev3.light.on(Color.ORANGE)
    ev3.light.blink(Color.ORANGE, [500, 500])
    ev3.light.blink(Color.ORANGE, [150, 150, 150, 550])
    ev3.light.on(Color.RED)
    ev3.light.blink(Color.RED, [500, 500])
    ev3.light.blink(Color.RED, [150, 150, 150, 550])
    ev3.light.off()
    ev3.light.off()


action()
