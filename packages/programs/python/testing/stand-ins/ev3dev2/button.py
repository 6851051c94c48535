import brick


class Button:
    @property
    def up(self):
        return brick.key("up")

    @property
    def down(self):
        return brick.key("down")

    @property
    def left(self):
        return brick.key("left")

    @property
    def right(self):
        return brick.key("right")

    @property
    def enter(self):
        return brick.key("enter")

    @property
    def backspace(self):
        return brick.key("escape")

    def any(self):
        return brick.key("any")
