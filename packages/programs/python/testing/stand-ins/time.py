import brick


def sleep(secs):
    brick.wait(secs * 1000)
