# The bricks of Pybricks 4, as far as generated files use them.
import brick
from pybricks.parameters import Color
from pybricks.tools import wait

_blinks = {2: "flash", 4: "double"}


class _Light:
    def on(self, color):
        brick.led(color.name.lower(), None)

    def off(self):
        brick.led(None, None)

    def blink(self, color, durations):
        brick.led(color.name.lower(), _blinks[len(durations)])


class _Screen:
    def clear(self):
        brick.clear()

    def draw_text(self, x, y, text, text_color=Color.BLACK, background_color=None):
        brick.display(y // 16, x // 10, text)


class _Speaker:
    def beep(self, frequency=500, duration=100):
        if duration < 0:
            brick.tone(frequency, None)
        elif duration == 0:
            brick.tone(0, None)
        else:
            brick.tone(frequency, duration / 1000)
            wait(duration)

    def volume(self, *args):
        if not args:
            return brick.volume()
        brick.set_volume(max(0, min(100, args[0])))


class _Keypad:
    def pressed(self):
        from pybricks.parameters import Button

        found = set()
        for name in ("enter", "up", "down", "left", "right"):
            if brick.key(name):
                found.add(Button.CENTER if name == "enter" else name)
        return found


class EV3Brick:
    def __init__(self):
        self.light = _Light()
        self.screen = _Screen()
        self.speaker = _Speaker()
        self.buttons = _Keypad()


class _LightMatrix:
    def off(self):
        brick.clear()

    def char(self, char):
        brick.display(0, 0, char)

    def number(self, number):
        brick.display(0, 0, str(number))

    def text(self, text, on=500, off=50):
        brick.display(0, 0, text)
        wait(len(text) * (on + off))


class _IMU:
    def heading(self):
        return brick.read(brick.plug("gyro"), "angle")

    def angular_velocity(self, axis):
        return -brick.read(brick.plug("gyro"), "rate")

    def reset_heading(self, angle):
        brick.reset_gyro(brick.plug("gyro"))


class _PrimeKeypad:
    def pressed(self):
        from pybricks.parameters import Button

        keys = {"enter": Button.CENTER, "left": Button.LEFT, "right": Button.RIGHT}
        return {button for name, button in keys.items() if brick.key(name)}


class _System:
    def set_stop_button(self, button):
        pass


class PrimeHub:
    def __init__(self):
        self.light = _Light()
        self.display = _LightMatrix()
        self.speaker = _Speaker()
        self.buttons = _PrimeKeypad()
        self.imu = _IMU()
        self.system = _System()
