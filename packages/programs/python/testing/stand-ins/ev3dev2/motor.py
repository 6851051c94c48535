import brick

OUTPUT_A = "A"
OUTPUT_B = "B"
OUTPUT_C = "C"
OUTPUT_D = "D"


class SpeedDPS:
    def __init__(self, degrees_per_second):
        self._percent = degrees_per_second / 7.2


class _Motor:
    POLARITY_INVERSED = "inversed"

    def __init__(self, address):
        self._port = address

    def on(self, speed):
        brick.motor(self._port, speed._percent)

    def off(self, brake=True):
        brick.motor(self._port, 0)

    def on_for_degrees(self, speed, degrees):
        percent = speed._percent
        brick.turn(self._port, -percent if degrees < 0 else percent, abs(degrees))
        while not brick.turned(self._port):
            brick.wait(10)

    @property
    def position(self):
        return brick.encoder(self._port)

    @position.setter
    def position(self, value):
        brick.reset_encoder(self._port)

    @property
    def speed(self):
        return brick.power(self._port) * 7.2


class LargeMotor(_Motor):
    pass


class MediumMotor(_Motor):
    pass


class MoveTank:
    def __init__(self, left_motor_port, right_motor_port):
        self._left = left_motor_port
        self._right = right_motor_port

    def on(self, left_speed, right_speed):
        brick.motor(self._left, left_speed._percent)
        brick.motor(self._right, right_speed._percent)

    def off(self):
        brick.motor(self._left, 0)
        brick.motor(self._right, 0)

    def on_for_degrees(self, left_speed, right_speed, degrees):
        sign = -1 if degrees < 0 else 1
        brick.move(left_speed._percent * sign, right_speed._percent * sign, abs(degrees))
        while not brick.arrived():
            brick.wait(10)
