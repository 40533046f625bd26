"""What a figure is made of: strokes (lines and faces), the symbols drawn with them (arrows, supports, solids), labels, and how each looks."""

import math
from dataclasses import dataclass
from typing import NamedTuple

from .projection import across, circle, hull, mean, unit3
from .vectors import add3, cross3, scale3, sub3

# colours that colour-blind readers tell apart (Okabe and Ito); bodies are grey
KINDS = {"velocity": "#0072B2", "acceleration": "#D55E00", "rate": "#008060", "force": "#B0408A", "plain": "#000000"}
DARK, MIDDLE, LIGHT, PALE, BLACK, WHITE = "#454a50", "#c9ced4", "#dde1e5", "#eef0f2", "#000000", "#ffffff"
DASHES = {"solid": "-", "dashed": (0, (5, 3)), "dotted": (0, (1, 2)), "centre": (0, (9, 2.5, 2, 2.5))}
FONT = 11  # points

BODY, MARK, ARROW = range(3)  # layers: bodies cover each other by depth; marks and then arrows lie over them


def _look(edge, width, face="none", dashes="solid", ends="round"):
    """The arguments of a matplotlib patch; ``width`` in points. The names are whole, since matplotlib is slower with short ones."""
    return {"edgecolor": edge, "facecolor": face, "linewidth": width, "linestyle": DASHES[dashes], "capstyle": ends, "joinstyle": "round"}


LOOKS = {
    "thin": _look(DARK, 0.9),
    "body": _look(DARK, 1.1, LIGHT),
    "side": _look(DARK, 1.1, MIDDLE),
    "top": _look(DARK, 1.1, PALE),
    "seam": _look(DARK, 0.7),
    "ring": _look(DARK, 1.4),
    "rod edge": _look(DARK, 5.6),
    "rod": _look(LIGHT, 3.6),
    "shaft edge": _look(DARK, 9.5, ends="butt"),
    "shaft": _look(LIGHT, 7.5, ends="butt"),
    "centre": _look(DARK, 0.7, dashes="centre", ends="butt"),
    "cable": _look(DARK, 1.4),
    "spring": _look(DARK, 1.2),
    "patch": _look("none", 0, "#f1ede4"),
    "support": _look(DARK, 1.3),
    "tip": _look(WHITE, 1.5, WHITE),
    "joint": _look(BLACK, 1.2, WHITE),
    "dot": _look(BLACK, 0.5, BLACK),
    "axis": _look(BLACK, 1.0, BLACK),
    "measure": _look(BLACK, 0.7, BLACK),
    "path": _look("#6b6f75", 1.1),
    **{f"line {name}": _look(DARK, 0.9, dashes=name, ends="butt") for name in DASHES},
    **{kind: _look(colour, 1.8, colour) for kind, colour in KINDS.items()},
}


class Note(NamedTuple):
    """A text beside a place on the page, which stands ``gap`` points from it in the direction ``towards`` (an angle) if that is free."""

    place: tuple
    text: str
    towards: float
    gap: float
    colour: str
    weight: str
    fixed: tuple | None  # points to the right and up, if it is not to be moved


def italic(text):
    """A symbol of one letter in italics, as it is set in print; anything else as it is."""
    return f"${text}$" if len(text) == 1 and text.isalpha() else text


@dataclass(frozen=True, slots=True)
class Stroke:
    """A line, or a closed outline with its filling, through places in space."""

    points: list
    looks: tuple
    layer: int
    closed: bool
    depth: float
    normal: tuple | None = None  # of a flat face
    cut: bool = False  # a piece of a line that a face cuts

    def drawn(self, ax, view, clip):
        """The stroke as patches, one for each look. They are not clipped; ``clip`` only saves matplotlib from making a path for it."""
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path

        xy = [view.flat(p) for p in self.points]
        path = Path(xy + xy[:1], closed=True) if self.closed else Path(xy)
        changed = ({} if self.closed else {"facecolor": "none"}) | ({"capstyle": "butt"} if self.cut else {})
        for look in self.looks:
            patch = PathPatch(path, clip_on=False, zorder=2 + self.layer, **(LOOKS[look] | changed))
            patch.set_clip_path(clip)
            yield ax.add_artist(patch)


class Ink:
    """What is drawn, for one length ``pt`` of a point: strokes in space with their looks, and notes beside places."""

    def __init__(self, view, pt, extent, centre):
        self.view, self.pt, self.centre, self.strokes, self.notes = view, pt, centre, [], []
        self.spots = [view.flat(p) for p in extent] or [(0.0, 0.0)]

    def put(self, points, looks, layer, closed, depth, normal=None):
        """A stroke. ``depth``: how near it counts as, by default the depth of its middle; ``normal``: of a flat face."""
        looks = (looks,) if isinstance(looks, str) else looks
        if depth is None:
            depth = self.view.depth(mean(points))
        self.spots += map(self.view.flat, points)
        self.strokes.append(Stroke(list(points), looks, layer, closed, depth, normal))

    def line(self, points, looks, layer=BODY, closed=False, depth=None):
        """A line through the points."""
        self.put(points, looks, layer, closed, depth)

    def face(self, corners, look, normal, layer=BODY):
        """A plane face."""
        self.put(corners, look, layer, True, None, normal)

    def solid(self, points, look, layer=BODY, depth=None):
        """The outline of a convex body."""
        if depth is None:
            depth = (self.view.depth(mean(points)) + max(map(self.view.depth, points))) / 2
        self.put(hull(self.view, points), look, layer, True, depth)

    def end(self, rim, outwards, look, layer=BODY):
        """The flat end of a body; turned away from the eye it is not seen, but still parts what is inside from what is outside."""
        self.face(rim, look if self.view.depth(outwards) > 0 else (), outwards, layer)

    def cylinder(self, first, last, axis, side, top, layer=BODY):
        """A cylinder between two rims."""
        self.solid(first + last, side, layer)
        self.end(first, scale3(-1, axis), top, layer)
        self.end(last, axis, top, layer)

    def disc(self, P, radius, look, layer=MARK):
        """A circle on the page, radius in points."""
        self.line(circle(P, self.view.eye, radius * self.pt, 24), look, layer, closed=True)

    def head(self, tail, tip, look, layer, size=8):
        """An arrowhead at ``tip``, ``size`` points long."""
        x, y = self.view.flat(sub3(tip, tail))
        length = math.hypot(x, y) or 1.0
        x, y = size * self.pt * x / length, size * self.pt * y / length
        wing = 0.32
        corners = [tip, self.view.lifted(tip, -x - wing * y, -y + wing * x), self.view.lifted(tip, -x + wing * y, -y - wing * x)]
        self.line(corners, ("tip", look), layer, True)

    def arrow(self, tail, tip, look, layer):
        """An arrow, or where it points at the eye or away from it, a circle with a dot or a cross."""
        v = sub3(tip, tail)
        if self.view.seen(v):
            self.line((tail, tip), look, layer)
            self.head(tail, tip, look, layer, min(8, 0.6 * math.hypot(*self.view.flat(v)) / self.pt))
        else:
            self.disc(tail, 4, "joint", layer)
            d = 2.8 * self.pt
            if self.view.depth(v) > 0:
                self.disc(tail, 1.3, look, layer)
            else:
                for s in (-1, 1):
                    self.line((self.view.lifted(tail, -d, -s * d), self.view.lifted(tail, d, s * d)), look, layer)

    def support(self, P, normal, half):
        """Ground seen edge-on: a line, hatched on the far side of the normal."""
        n = unit3(self.view.lifted((0, 0, 0), *self.view.flat(normal)))
        along = cross3(n, self.view.eye)
        self.line((add3(P, scale3(-half, along)), add3(P, scale3(half, along))), "support")
        slant = scale3(5 * self.pt, add3(scale3(-1, n), scale3(-0.8, along)))
        for k in range(-4, 6):
            foot = add3(P, scale3(half * k / 5, along))
            self.line((foot, add3(foot, slant)), "thin")

    def floor(self, P, normal, half):
        """Ground seen in perspective: a patch with hatching."""
        e1, e2 = (scale3(half, e) for e in across(normal))
        e2 = max((e2, scale3(-1, e2)), key=lambda e: self.view.slant(add3(e1, e)))

        def corner(s, t):
            return add3(P, add3(scale3(s, e1), scale3(t, e2)))

        back = self.view.depth(P) - half
        self.line([corner(s, t) for s, t in ((1, 1), (-1, 1), (-1, -1), (1, -1))], "patch", closed=True, depth=back)
        for k in range(-3, 4):
            s = k / 2
            self.line((corner(max(-1, s - 1), max(-1, -1 - s)), corner(min(1, s + 1), min(1, 1 - s))), "seam", depth=back)

    def note(self, place, text, away_from=None, gap=3, colour=BLACK, weight="normal", fixed=None):
        """A label beside a place, rather on the side away from another place."""
        if text:
            x, y = self.view.flat(sub3(place, away_from)) if away_from else (0, 0)
            self.notes.append(Note(self.view.flat(place), text, math.atan2(y, x), gap, colour, weight, fixed))

    def box(self):
        """Left, right, bottom and top of everything."""
        xs, ys = zip(*self.spots, strict=True)
        return min(xs), max(xs), min(ys), max(ys)
