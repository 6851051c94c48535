import brick

_names = {"GREEN": "green", "AMBER": "orange", "RED": "red"}


class Leds:
    def set_color(self, group, color):
        if group == "LEFT":
            brick.led(_names[color], None)

    def all_off(self):
        brick.led(None, None)

    def animate_stop(self):
        pass

    def animate_flash(self, color, groups=("LEFT", "RIGHT"), sleeptime=0.5, duration=5, block=True):
        brick.led(_names[color], "flash" if sleeptime == 0.5 else "double")
