# railway. Made with Botgarten.
# For an EV3 with Pybricks 4.
# Port 1: color sensor
# Port B: motor of the right wheel
# Port C: motor of the left wheel
from pybricks.ev3devices import ColorSensor, Motor
from pybricks.hubs import EV3Brick
from pybricks.parameters import Button, Color, Port
from pybricks.robotics import DriveBase
from pybricks.tools import wait
from umath import floor, pi
from urandom import random

# The best way: station, turn in degrees (right is above 0), way in cm
BEST_WAY = [(3, 0, 202.06), (5, 65.92, 90.33), (0, 44.21, 111.54), (1, 0, 0)]
# All that was learned: from a station to the next, and what it is worth
Q_TABLE = {
    0: {1: 50, 5: 32},
    1: {0: 0, 2: 0},
    2: {1: 49.61},
    3: {4: 25.6, 5: 32},
    4: {3: 25.59, 5: 32},
    5: {0: 40, 3: 25.6, 4: 25.6},
}
# The roads: to the next station, direction (0 right, 90 down) and way in cm
ROADS = {
    0: {1: (346.69, 107.69), 5: (71.22, 83.23)},
    1: {0: (166.69, 107.69), 2: (9.01, 107.32)},
    2: {1: (189.01, 107.32)},
    3: {4: (156.17, 104.95), 5: (175.68, 196.56)},
    4: {3: (336.17, 104.95), 5: (195.43, 103.74)},
    5: {0: (251.22, 83.23), 3: (355.68, 196.56), 4: (15.43, 103.74)},
}
REWARDS = {(0, 1): 50, (2, 1): 50}
START = 3
ENDS = [1]
STATIONS = [0, 2, 3, 4, 5]
# How it learns
LEARNING_RATE = 0.5
DISCOUNT = 0.8
EXPLORING = 0.5
ELSEWHERE = 0.1

ev3 = EV3Brick()
color_sensor = ColorSensor(Port.S1)
right_motor = Motor(Port.B)
left_motor = Motor(Port.C)
robot = DriveBase(left_motor, right_motor, wheel_diameter=56, axle_track=180)


def pick(choices):
    return choices[int(random() * len(choices))]


def show(text, column, row):
    # A letter is 10 wide and 16 high.
    x = 10 * max(0, min(16, floor(column + 0.5)))
    y = 16 * max(0, min(7, floor(row + 0.5)))
    ev3.screen.draw_text(x, y, text, background_color=Color.WHITE)


def put_down(station):
    # Put the robot on this station, facing right, and press the key in the middle.
    show(str(station), 0, 0)
    while Button.CENTER not in ev3.buttons.pressed():
        wait(10)
    while Button.CENTER in ev3.buttons.pressed():
        wait(10)
    return 0


def best_of(station):
    # The station that is worth most; of equals any
    values = Q_TABLE[station]
    most = max(values.values())
    best = [one for one in sorted(values) if values[one] == most]
    return best[0] if len(best) == 1 else pick(best)


def stop():
    left_motor.brake()
    right_motor.brake()


def cut(percent):
    return max(-100, min(100, percent))


def speed(percent):
    # At 100 percent a wheel turns twice a second.
    return cut(percent) * 7.2


def turn(percent, degrees):
    if percent * degrees == 0:
        stop()
        return
    robot.settings(turn_rate=abs(speed(percent)) * 56 / 180)
    robot.turn(degrees if percent > 0 else -degrees)


def straight(percent, cm):
    # The sign of percent and of cm decides about forward and backward.
    if percent * cm == 0:
        stop()
        return
    robot.settings(straight_speed=abs(speed(percent)) * pi * 56 / 360)
    robot.straight(cm * 10 if percent > 0 else -cm * 10)


def drive_to(station, following, heading):
    # Turn, then straight on to the station
    direction, length = ROADS[station][following]
    turn(30, (direction - heading + 180) % 360 - 180)
    straight(30, length)
    for _ in range(10):
        color = color_sensor.color()
        if color not in (Color.WHITE, Color.NONE):
            break
        straight(15, 1)
    return direction


def update(station, following, rate):
    reward = REWARDS.get((station, following), 0)
    ahead = 0
    if following not in ENDS:
        ahead = max(Q_TABLE[following].values())
    aim = reward + DISCOUNT * ahead
    Q_TABLE[station][following] = (1 - rate) * Q_TABLE[station][following] + rate * aim


def learn(episodes, moves):
    # Q-learning: what a road is worth grows with what comes behind it.
    rate, exploring = LEARNING_RATE, EXPLORING
    station, heading, steps = None, 0, 0
    while episodes > 0 and moves > 0:
        curious, lost = random(), random()
        if lost < ELSEWHERE or station is None:
            station = pick(STATIONS) if lost < ELSEWHERE else START
            heading = put_down(station)
        if curious < exploring:
            following = pick(sorted(Q_TABLE[station]))
        else:
            following = best_of(station)
        heading = drive_to(station, following, heading)
        update(station, following, rate)
        station, steps, moves = following, steps + 1, moves - 1
        if station in ENDS or steps == 120:
            station, steps, episodes = None, 0, episodes - 1
    print(Q_TABLE)


def drive_best_way():
    station, heading = START, put_down(START)
    for _ in Q_TABLE:
        if station in ENDS:
            break
        following = best_of(station)
        heading = drive_to(station, following, heading)
        station = following


learn(100, 10000)
# On the real floor you draw the way yourself.
drive_best_way()
