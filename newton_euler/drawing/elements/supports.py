"""What holds a mechanism: ground, roads, hinges, ball joints."""

from collections.abc import Sequence
from itertools import pairwise

from ...algebra.errors import checked_words
from ...algebra.vectors import FrameError, scale3, sub3
from ..page.primitives import MARK
from ..page.projection import between, circle, moved, norm3
from ..page.recorder import Direction, Place, Recorder


@checked_words
class Supports(Recorder):
    """The methods of a sketch that draw supports and joints."""

    def ground(self, P: Place, normal: Direction, size: float | None = None) -> None:
        """Draw fixed ground at P, a hatched patch that faces ``normal``, ``size`` metres wide."""
        P, normal = self._place(P), self._unit(normal)
        size = self._or_default(size)

        @self._record
        def command(canvas):
            edge_on = abs(canvas.depth(normal)) < 0.2
            (canvas.support if edge_on else canvas.floor)(P, normal, (size or 44 * canvas.pt) / 2)

    def road(self, points: Sequence[Place]) -> None:
        """Draw ground through two places or more, hatched on the right as one goes along it."""
        points = self._several(points, "the places of a road")
        if len(points) < 2:
            raise FrameError(f"a road leads through two places or more, got {len(points)}")

        @self._record
        def command(canvas):
            canvas.line(points, "support")
            ahead = 3 * canvas.pt  # distance to the next hatching line
            for A, B in pairwise(points):
                seen = canvas.offset((0, 0, 0), *canvas.project(sub3(B, A)))
                length = norm3(seen)
                while ahead < length:
                    canvas.hatch(between(A, B, ahead / length), scale3(1 / length, seen))
                    ahead += 6 * canvas.pt
                ahead -= length

    def hinge(self, P: Place, axis: Direction | None = None) -> None:
        """Draw a hinge at P: a small circle, or a sleeve along ``axis``."""
        P, axis = self._place(P), None if axis is None else self._unit(axis)

        @self._record
        def command(canvas):
            if axis is None or abs(canvas.depth(axis)) > 0.95:
                canvas.disc(P, 3.6, "joint")
            else:
                pt = canvas.pt
                ends = (circle(moved(P, x, axis), axis, 4 * pt) for x in (-8 * pt, 8 * pt))
                canvas.cylinder(*ends, axis, "joint", "joint", MARK)

    def ball_joint(self, P: Place) -> None:
        """Draw a ball joint at P."""
        P = self._place(P)
        self._record(lambda canvas: (canvas.disc(P, 5.5, "joint"), canvas.disc(P, 3.4, "side")))
