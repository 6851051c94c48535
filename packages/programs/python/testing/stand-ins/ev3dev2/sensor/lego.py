import brick


class _Sensor:
    def __init__(self, address):
        self._port = address


class TouchSensor(_Sensor):
    @property
    def is_pressed(self):
        return brick.read(self._port, "touch") > 0


class ColorSensor(_Sensor):
    COLOR_NOCOLOR = 0
    COLOR_BLACK = 1
    COLOR_BLUE = 2
    COLOR_GREEN = 3
    COLOR_YELLOW = 4
    COLOR_RED = 5
    COLOR_WHITE = 6
    COLOR_BROWN = 7

    @property
    def color(self):
        seen = brick.read(self._port, "colour")
        return _colors.index(seen) if seen in _colors else self.COLOR_NOCOLOR

    @property
    def reflected_light_intensity(self):
        return brick.read(self._port, "light")

    @property
    def ambient_light_intensity(self):
        return brick.read(self._port, "light")

    @property
    def rgb(self):
        return tuple([brick.read(self._port, part) for part in ("red", "green", "blue")])


_colors = ["#585858", "#000000", "#0057A6", "#00642E", "#F7D117", "#B30006", "#FFFFFF", "#532115"]


class UltrasonicSensor(_Sensor):
    @property
    def distance_centimeters(self):
        return brick.read(self._port, "distance")


class GyroSensor(_Sensor):
    @property
    def angle(self):
        return brick.read(self._port, "angle")

    @property
    def rate(self):
        return brick.read(self._port, "rate")

    def reset(self):
        brick.reset_gyro(self._port)


class InfraredSensor(_Sensor):
    @property
    def proximity(self):
        return brick.read(self._port, "infrared")


class SoundSensor(_Sensor):
    @property
    def sound_pressure(self):
        return brick.read(self._port, "sound")
