"""What the tests of figures share: a sketch on fresh axes, and what came out of it."""

import io

from matplotlib.colors import to_hex
from matplotlib.figure import Figure

from newton_euler import Frame
from newton_euler.drawing.page.primitives import DARK
from newton_euler.drawing.sketch import Sketch

ground = Frame("ground")
O = ground.point("O", 0, 0, 0)


def sketch(**view):
    return Sketch(Figure(figsize=(5, 4), dpi=100).add_subplot(), ground, **view)


def png(s):
    out = io.BytesIO()
    s.ax.figure.savefig(out, format="png")
    return out.getvalue()


def vertices(s, colour=DARK):
    """The coordinates on the page of each line and outline of one colour, in the order of drawing;
    the sketch is finished before.
    """
    s.finish()
    return [
        p.get_path().vertices for p in s.ax.patches if to_hex(p.get_edgecolor()) == colour.lower()
    ]


def texts(s):
    s.finish()
    return {t.get_text(): t for t in s.ax.texts}


def colour_at(s, *place):
    """The colour in which a place of the scene is seen, as "#rrggbb"."""
    from PIL import Image

    image = Image.open(io.BytesIO(png(s))).convert("RGB")
    x, y = s.ax.transData.transform(s.view.project(place))
    return to_hex([c / 255 for c in image.getpixel((round(x), round(image.height - y)))])
