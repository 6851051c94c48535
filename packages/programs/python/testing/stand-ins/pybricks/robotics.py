from math import pi

import brick


class DriveBase:
    def __init__(self, left_motor, right_motor, wheel_diameter, axle_track):
        self._wheel = wheel_diameter
        self._track = axle_track
        self._speed = 0
        self._rate = 0

    def settings(self, straight_speed=None, turn_rate=None):
        if straight_speed is not None:
            self._speed = straight_speed
        if turn_rate is not None:
            self._rate = turn_rate

    def _go(self, left, right, degrees):
        brick.move(left, right, degrees)
        while not brick.arrived():
            brick.wait(10)

    def straight(self, distance):
        percent = self._speed * 360 / (pi * self._wheel) / 7.2
        percent = -percent if distance < 0 else percent
        self._go(percent, percent, abs(distance) * 360 / (pi * self._wheel))

    def turn(self, angle):
        percent = self._rate * self._track / self._wheel / 7.2
        percent = -percent if angle < 0 else percent
        self._go(percent, -percent, abs(angle) * self._track / self._wheel)
