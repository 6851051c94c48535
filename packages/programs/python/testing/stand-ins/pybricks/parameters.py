class Port:
    A = "A"
    B = "B"
    C = "C"
    D = "D"
    E = "E"
    F = "F"
    S1 = "1"
    S2 = "2"
    S3 = "3"
    S4 = "4"


class Stop:
    HOLD = "hold"


class Direction:
    CLOCKWISE = 1
    COUNTERCLOCKWISE = -1


class Axis:
    Z = 3


class Button:
    LEFT = "left"
    RIGHT = "right"
    UP = "up"
    DOWN = "down"
    CENTER = "center"
    BLUETOOTH = "bluetooth"


class Color:
    pass


for _name in ("NONE", "BLACK", "WHITE", "RED", "ORANGE", "BROWN", "YELLOW", "GREEN", "BLUE"):
    _color = Color()
    _color.name = _name
    setattr(Color, _name, _color)
