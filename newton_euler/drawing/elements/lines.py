"""Lines and slender bodies: rods, shafts, wires, circles, curves."""

import math
from collections.abc import Sequence
from itertools import groupby, pairwise

from ...algebra.errors import checked_words
from ...algebra.vectors import FrameError, dot3, sub3
from ..page.primitives import MARK, Line
from ..page.projection import moved, norm3, on_circle
from ..page.recorder import Direction, Place, Recorder

MAX_TURNS = 1000


@checked_words
class Lines(Recorder):
    """The methods of a sketch that draw lines and what is slender."""

    def rod(self, A: Place, B: Place, *more: Place) -> None:
        """Draw a slender rod from A to B, and more of them from there to further places."""
        for P, Q in pairwise((A, B, *more)):
            self._straight(P, Q, "rod edge", "rod")

    def shaft(self, A: Place, B: Place) -> None:
        """Draw a shaft from A to B with its centre line."""
        self._straight(A, B, "shaft edge", "shaft", "centre")

    def line(self, A: Place, B: Place, style: Line = "dashed") -> None:
        """Draw a thin line from A to B, ``style`` solid, dashed, dotted or centre."""
        self._straight(A, B, f"line {style}")

    def _straight(self, A, B, *styles):
        ends = self._places(A, B)
        self._record(lambda canvas: canvas.line(ends, styles))

    def wire(self, points: Sequence[Place]) -> None:
        """Draw a thin bent body through many places: a wire, a hoop, the rim of a track."""
        places = self._several(points, "the points")
        self._record(lambda canvas: canvas.curve(places, "wire"))

    def path(
        self,
        points: Sequence[Place],
        style: Line = "solid",
        on: Place | tuple[Place, Place] | None = None,
    ) -> None:
        """Draw a curve through many places, ``style`` solid, dashed, dotted or centre.

        on : of a curve on the surface of a sphere its centre, on that of a cylinder two places of
            its axis; only the near side of the curve is drawn, and the body does not hide it
        """
        places = self._several(points, "the points")
        look = "path" if style == "solid" else f"line {style}"
        if on is not None:
            runs = self._near_side(places, on)
            self._record(lambda canvas: [canvas.line(run, look, MARK) for run in runs])
        elif look == "path":
            self._record(lambda canvas: canvas.curve(places, look))
        else:  # one stroke: in pieces, the dashes would restart with each
            self._record(lambda canvas: canvas.line(places, look))

    def _near_side(self, places, on):
        """The runs of places that face the eye, seen from a centre or from an axis."""
        A, *B = map(self._triple_of, on if isinstance(on, (tuple, list)) and len(on) == 2 else [on])
        axis = self._unit(sub3(B[0], A)) if B else (0.0, 0.0, 0.0)

        def is_near(P):
            out = sub3(P, A)
            out = moved(out, -dot3(out, axis), axis)
            return self.view.depth(out) >= -1e-9 * norm3(out)

        runs = [list(run) for near, run in groupby(places, is_near) if near]
        return [run for run in runs if len(run) > 1]

    def ring(self, C: Place, normal: Direction, radius: float) -> None:
        """Draw a circle about C without a filling."""
        rim = self._rim(self._place(C), self._unit(normal), radius)
        self._record(lambda canvas: canvas.curve([*rim, rim[0]], "ring"))

    def around(
        self, C: Place, A: Place, axis: Direction, angle: float = 2 * math.pi
    ) -> list[tuple[float, float, float]]:
        """The places on a circle through A about ``axis`` through C: from A right-handed through
        ``angle`` (rad), by default once round. It draws nothing: it is the outline of a plate or of
        a hole, a wire, a path.

        >>> from newton_euler import Frame
        >>> from newton_euler.drawing import Sketch
        >>> ground = Frame("ground")
        >>> s = Sketch(None, ground, plane="xy")
        >>> half_circle = s.around((0, 0, 0), (1, 0, 0), ground.k, 3.14159)
        >>> s.wire(half_circle)
        >>> s.plate(half_circle)  # half a disk
        """
        turned = self._number(angle)
        if not abs(turned) <= MAX_TURNS * 2 * math.pi:  # nan too
            raise FrameError(f"an angle is in radians, at most {MAX_TURNS} turns; got {angle!r}")
        A, C, axis = self._triple_of(A), self._triple_of(C), self._unit(axis)
        centre, e1, e2, radius = self._circle_through(A, C, axis)
        count = max(2, math.ceil(abs(turned) / math.radians(6)))
        # the last point of a whole turn would be the first
        ends = range(count + (abs(abs(turned) - 2 * math.pi) >= 1e-9))
        angles = [turned * n / count for n in ends]
        return [on_circle(centre, e1, e2, radius, a) for a in angles]
