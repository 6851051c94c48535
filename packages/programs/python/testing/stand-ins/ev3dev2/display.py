import brick


class Display:
    def clear(self):
        brick.clear()

    def update(self):
        pass

    def rectangle(self, clear_screen=True, x1=10, y1=10, x2=80, y2=40, fill_color="black", outline_color="black"):
        pass

    def text_pixels(self, text, clear_screen=True, x=0, y=0):
        brick.display(y // 16, x // 10, text)
