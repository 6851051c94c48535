import brick
from pybricks import ev3devices
from pybricks.ev3devices import Motor  # noqa: F401
from pybricks.parameters import Color


class UltrasonicSensor(ev3devices.UltrasonicSensor):
    def __init__(self, port):
        self._port = brick.plug(port)


def _color(red, green, blue):
    high, low = max(red, green, blue), min(red, green, blue)
    span = high - low
    if span == 0:
        hue = 0
    elif high == red:
        hue = (green - blue) / span % 6
    elif high == green:
        hue = (blue - red) / span + 2
    else:
        hue = (red - green) / span + 4
    color = Color()
    color.h = hue * 60
    color.s = 100 * span / high if high else 0
    color.v = high / 2.55
    return color


class ColorSensor:
    def __init__(self, port):
        self._port = brick.plug(port)
        self._known = ()

    def detectable_colors(self, colors):
        self._known = colors

    def color(self):
        color = ev3devices.ColorSensor(self._port).color()
        if color is not None and color not in self._known:
            raise ValueError("the sensor was not told of this color")
        return color

    def reflection(self):
        return brick.read(self._port, "light")

    def ambient(self):
        return brick.read(self._port, "light")

    def hsv(self):
        return _color(*[brick.read(self._port, part) for part in ("red", "green", "blue")])


class ForceSensor:
    def __init__(self, port):
        self._port = brick.plug(port)

    def pressed(self, force=3):
        return brick.read(self._port, "touch") > 0
