import brick

_timers = [0]


def wait(time):
    brick.wait(time)


class StopWatch:
    def __init__(self):
        _timers[0] += 1
        self._number = _timers[0]

    def time(self):
        return brick.timer(self._number)

    def reset(self):
        brick.reset_timer(self._number)
