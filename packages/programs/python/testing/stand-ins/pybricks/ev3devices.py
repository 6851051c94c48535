import brick
from pybricks.parameters import Color, Direction, Stop

_colors = {
    "#000000": Color.BLACK,
    "#0057A6": Color.BLUE,
    "#00642E": Color.GREEN,
    "#F7D117": Color.YELLOW,
    "#B30006": Color.RED,
    "#FFFFFF": Color.WHITE,
    "#532115": Color.BROWN,
    "#585858": Color.NONE,
}


class Motor:
    def __init__(self, port, positive_direction=Direction.CLOCKWISE):
        self._port = port

    def run(self, speed):
        brick.motor(self._port, speed / 7.2)

    def stop(self):
        brick.motor(self._port, 0)

    def brake(self):
        brick.motor(self._port, 0)

    def run_angle(self, speed, rotation_angle, then=Stop.HOLD, wait=True):
        percent = speed / 7.2
        brick.turn(self._port, -percent if rotation_angle < 0 else percent, abs(rotation_angle))
        while wait and not self.done():
            brick.wait(10)

    def done(self):
        return brick.turned(self._port)

    def angle(self):
        return brick.encoder(self._port)

    def reset_angle(self, angle):
        brick.reset_encoder(self._port)

    def speed(self):
        return brick.power(self._port) * 7.2


class UltrasonicSensor:
    def __init__(self, port):
        self._port = port

    def distance(self):
        return brick.read(self._port, "distance") * 10


class ColorSensor:
    def __init__(self, port):
        self._port = port

    def color(self):
        return _colors.get(brick.read(self._port, "colour"))

    def reflection(self):
        return brick.read(self._port, "light")

    def ambient(self):
        return brick.read(self._port, "light")

    def rgb(self):
        return tuple([brick.read(self._port, part) / 2.55 for part in ("red", "green", "blue")])


class TouchSensor:
    def __init__(self, port):
        self._port = port

    def pressed(self):
        return brick.read(self._port, "touch") > 0


class GyroSensor:
    def __init__(self, port):
        self._port = port

    def angle(self):
        return brick.read(self._port, "angle")

    def speed(self):
        return brick.read(self._port, "rate")

    def reset_angle(self, angle):
        brick.reset_gyro(self._port)


class InfraredSensor:
    def __init__(self, port):
        self._port = port

    def distance(self):
        return brick.read(self._port, "infrared")
