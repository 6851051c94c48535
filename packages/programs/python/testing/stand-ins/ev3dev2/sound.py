import brick


class Sound:
    PLAY_WAIT_FOR_COMPLETE = 0
    PLAY_NO_WAIT_FOR_COMPLETE = 1

    def play_tone(self, frequency, duration, delay=0.0, volume=100, play_type=0):
        brick.tone(frequency, duration)
        if play_type == Sound.PLAY_WAIT_FOR_COMPLETE:
            brick.wait(duration * 1000)

    def speak(self, text, espeak_opts="-a 200 -s 130"):
        brick.say(text)

    def set_volume(self, pct):
        brick.set_volume(max(0, min(100, pct)))

    def get_volume(self):
        return brick.volume()
