class Sketch:
    pass
