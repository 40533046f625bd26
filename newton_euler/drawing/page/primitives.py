"""The parts of a figure: strokes, the symbols made of them, labels, and their styles."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple, TypeAlias

from ...algebra.scalars import Triple
from ...algebra.vectors import add3, cross3, scale3, sub3
from .projection import View, circle, convex_hull, mean, moved, on_plane, perpendiculars, unit3

# colours that colour-blind readers can distinguish (after Okabe and Ito 2008); bodies are grey
KINDS = {"velocity": "#0072B2", "acceleration": "#D55E00", "rate": "#008060",
         "force": "#B0408A", "plain": "#000000"}  # fmt: skip
DARK, SHADED, MIDDLE, LIGHT, PALE = "#454a50", "#aab1b9", "#c9ced4", "#dde1e5", "#eef0f2"
BLACK, WHITE = "#000000", "#ffffff"
MOVED = "#8a5a00"  # axes of a frame that moves
Outline: TypeAlias = list[Triple]  # the places of a face, of a hole, of a rim, in order
Outlines: TypeAlias = Sequence[Outline]
Kind: TypeAlias = Literal["velocity", "acceleration", "rate", "force", "plain"]
Line: TypeAlias = Literal["solid", "dashed", "dotted", "centre"]
DASHES = {"solid": "-", "dashed": (0, (5, 3)), "dotted": (0, (1, 2)),
          "centre": (0, (9, 2.5, 2, 2.5))}  # fmt: skip
FONT = 11  # points
SQUARE = (1, 1), (-1, 1), (-1, -1), (1, -1)  # corners of a square

# layers: bodies hide each other by depth; marks and then arrows lie over them
BODY, MARK, ARROW = range(3)


def _style(edge, width, face="none", dashes="solid", ends="round"):
    """The keyword arguments of a matplotlib patch, with long names: short ones are slower."""
    return {"edgecolor": edge, "facecolor": face, "linewidth": width,
            "linestyle": DASHES[dashes], "capstyle": ends, "joinstyle": "round"}  # fmt: skip


STYLES = {
    "thin": _style(DARK, 0.9),
    "body": _style(DARK, 1.1, LIGHT),
    "side": _style(DARK, 1.1, MIDDLE),
    "top": _style(DARK, 1.1, PALE),
    "inside": _style(DARK, 1.1, SHADED),
    "seam": _style(DARK, 0.7),
    "ring": _style(DARK, 1.4),
    "rod edge": _style(DARK, 5.6),
    "rod": _style(LIGHT, 3.6),
    "shaft edge": _style(DARK, 9.5, ends="butt"),
    "shaft": _style(LIGHT, 7.5, ends="butt"),
    "centre": _style(DARK, 0.7, dashes="centre", ends="butt"),
    "cable": _style(DARK, 1.4),
    "spring": _style(DARK, 1.2),
    "wire": _style(DARK, 2.6),
    "patch": _style("none", 0, "#f1ede4"),
    "support": _style(DARK, 1.3),
    "tip": _style(WHITE, 1.5, WHITE),
    "joint": _style(BLACK, 1.2, WHITE),
    "dot": _style(BLACK, 0.5, BLACK),
    "axis": _style(BLACK, 1.0, BLACK),
    "moved axis": _style(MOVED, 1.2, MOVED, "dashed", "butt"),
    "measure": _style(BLACK, 0.7, BLACK),
    "path": _style("#6b6f75", 1.1),
    **{f"line {name}": _style(DARK, 0.9, dashes=name, ends="butt") for name in DASHES},
    **{kind: _style(colour, 1.8, colour) for kind, colour in KINDS.items()},
    **{f"{kind} sum": _style(colour, 3.2, colour) for kind, colour in KINDS.items()},
}


class Note(NamedTuple):
    """A label of a place, ``gap`` points from it, best at the angle ``towards`` from the right."""

    place: tuple
    text: str
    towards: float
    gap: float
    colour: str
    weight: str
    fixed: tuple | None  # points to the right and up, if it must not be moved


@dataclass(frozen=True, slots=True)
class Stroke:
    """A line, or a closed outline with its filling, through places in space (triples)."""

    points: list
    styles: tuple
    layer: int
    closed: bool
    depth: float
    normal: tuple | None = None  # normal of a flat face
    cut: bool = False  # a piece of a line that a face cuts
    holes: tuple = ()  # holes in its filling, each a list of places


class Canvas(View):
    """A view with strokes and labels of one picture; ``pt``: the length of a point in metres."""

    def __init__(self, view: View, pt: float, extent: Sequence[Triple], centre: Triple):
        super().__init__(view.right, view.up)
        self.pt, self.centre = pt, centre
        self.strokes: list[Stroke] = []
        self.notes: list[Note] = []
        self.triads: list = []  # (origin, pairs (tip, label)) of each system of axes
        self.spots = [self.project(p) for p in extent] or [(0.0, 0.0)]

    def line(
        self,
        points: Sequence[Triple],
        styles: str | tuple[str, ...],
        layer: int = BODY,
        closed: bool = False,
        depth: float | None = None,
        normal: Triple | None = None,
        holes: Outlines = (),
    ) -> None:
        """Add a stroke of this ``depth``, by default that of its middle; a face has a normal."""
        styles = (styles,) if isinstance(styles, str) else styles
        depth = self.depth(mean(points)) if depth is None else depth
        self.spots += map(self.project, points)
        stroke = Stroke(list(points), styles, layer, closed, depth, normal, holes=tuple(holes))
        self.strokes.append(stroke)

    def curve(self, points: Sequence[Triple], style: str) -> None:
        """Add a curve through the points, in pieces, so that each has a depth of its own."""
        for n in range(0, len(points) - 1, 4):
            self.line(points[n : n + 5], style)

    def solid(
        self, points: Sequence[Triple], style: str, layer: int = BODY, depth: float | None = None
    ) -> None:
        """Add the outline of a convex body."""
        if depth is None:
            depth = (self.depth(mean(points)) + max(map(self.depth, points))) / 2
        self.line(convex_hull(self, points), style, layer, True, depth)

    def end(
        self, rim: Outline, outwards: Triple, style: str, layer: int = BODY, holes: Outlines = ()
    ) -> None:
        """Add the flat end of a body; one that faces away still separates inside and outside."""
        seen = style if self.depth(outwards) > 0 else ()
        self.line(rim, seen, layer, True, normal=outwards, holes=holes)

    def shell(self, points: Outline, rim: Outline, outwards: Triple) -> None:
        """Add a convex vessel open at its rim, through which one looks in from ``outwards``."""
        depths = [self.depth(p) for p in points]
        if self.depth(outwards) <= 0:
            self.solid(points, "side")
            return
        self.line(rim, "inside", closed=True, depth=min(depths))
        wall = convex_hull(self, points)
        self.line(wall, "side", closed=True, depth=max(depths), holes=[rim])

    def cylinder(
        self, first: Outline, last: Outline, axis: Triple, side: str, top: str, layer: int = BODY
    ) -> None:
        """Add a cylinder between two rims."""
        self.solid(first + last, side, layer)
        self.end(first, scale3(-1, axis), top, layer)
        self.end(last, axis, top, layer)

    def disc(self, P: Triple, radius: float, style: str, layer: int = MARK) -> None:
        """Add a circle on the page, radius in points."""
        self.line(circle(P, self.eye, radius * self.pt, 24), style, layer, closed=True)

    def head(self, tail: Triple, tip: Triple, style: str, layer: int, size: float = 8) -> None:
        """Add an arrowhead at ``tip``, ``size`` points long."""
        x, y = self.project(sub3(tip, tail))
        length = math.hypot(x, y) or 1.0
        x, y = size * self.pt * x / length, size * self.pt * y / length
        wings = (self.offset(tip, -x - w * y, -y + w * x) for w in (0.32, -0.32))
        self.line([tip, *wings], ("tip", style), layer, True)

    def arrow(self, tail: Triple, tip: Triple, style: str, layer: int) -> None:
        """Add an arrow; if it points at the eye or away from it, a circle with a dot or a cross."""
        v = sub3(tip, tail)
        if self.is_seen(v):
            self.line((tail, tip), style, layer)
            self.head(tail, tip, style, layer, min(8, 0.6 * math.hypot(*self.project(v)) / self.pt))
        else:
            self.disc(tail, 4, "joint", layer)
            if self.depth(v) > 0:
                self.disc(tail, 1.3, style, layer)
            else:
                x = 2.8 * self.pt
                for y in (-x, x):
                    self.line((self.offset(tail, -x, -y), self.offset(tail, x, y)), style, layer)

    def support(self, P: Triple, normal: Triple, half: float) -> None:
        """Add ground seen edge-on: a line, hatched on the side opposite to the normal."""
        n = unit3(self.offset((0, 0, 0), *self.project(normal)))
        along = cross3(n, self.eye)
        self.line((moved(P, -half, along), moved(P, half, along)), "support")
        for k in range(-4, 6):
            self.hatch(moved(P, half * k / 5, along), along)

    def hatch(self, P: Triple, along: Triple) -> None:
        """Add a short hatching line at P, on the right of a unit vector in the page."""
        n = cross3(self.eye, along)
        self.line((P, moved(P, -5 * self.pt, moved(n, 0.8, along))), "thin")

    def floor(self, P: Triple, normal: Triple, half: float) -> None:
        """Add ground seen from above or below: a hatched patch."""
        e1, e2 = (scale3(half, e) for e in perpendiculars(normal))
        e2 = max((e2, scale3(-1, e2)), key=lambda e: self.slant(add3(e1, e)))

        def corner(s, t):
            return on_plane(P, s, e1, t, e2)

        back = self.depth(P) - half  # behind what stands on it
        self.line([corner(s, t) for s, t in SQUARE], "patch", closed=True, depth=back)
        for k in range(-3, 4):
            s = k / 2
            first = corner(max(-1, s - 1), max(-1, -1 - s))
            self.line((first, corner(min(1, s + 1), min(1, 1 - s))), "seam", depth=back)

    def note(
        self,
        place: Triple,
        text: str,
        away_from: Triple | None = None,
        gap: float = 3,
        colour: str = BLACK,
        weight: str = "normal",
        fixed: tuple[float, float] | None = None,
    ) -> None:
        """Add the label of a place, best away from another; one letter is italic unless bold."""
        if text:
            if len(text) == 1 and text.isalpha() and weight != "bold":
                text = f"${text}$"
            x, y = self.project(sub3(place, away_from)) if away_from else (0, 0)
            towards = math.atan2(y, x)
            self.notes.append(Note(self.project(place), text, towards, gap, colour, weight, fixed))

    def shapes(self) -> list[list[list[tuple[float, float]]]]:
        """The outlines of each stroke and of its holes on the page, in points."""
        pt, project = self.pt, self.project
        return [
            [[(x / pt, y / pt) for x, y in map(project, line)] for line in (s.points, *s.holes)]
            for s in self.strokes
        ]

    def box(self) -> tuple[float, float, float, float]:
        """Left, right, bottom and top of all that was added, in metres on the page."""
        xs, ys = zip(*self.spots, strict=True)
        return min(xs), max(xs), min(ys), max(ys)
