# composed__common__functionsBasic. Made with Botgarten.
# For an EV3 with Pybricks 4.

n1 = 0
b = False
n2 = 1
n3 = 4


def check(name, holds):
    print(name, "holds" if holds else "does not hold")


def number():
    global n1
    n1 = n2 + n3


def breakFunct():
    global n1
    if 5 == n1:
        return
    n1 = n1 + 1000


def retBool():
    global n1
    n1 = n1
    return b


def retNumber():
    global n1
    n1 = n1
    return n1


def retNumber2(x):
    x = x / 2
    return x


# Basic Functions START
number()
breakFunct()
check("pos-1", 5 == n1)
n1 = retNumber()
b = retBool()
n1 = retNumber2(10)
# Basic Functions END
