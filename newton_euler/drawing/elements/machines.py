"""Parts of machines: gears, pulleys and cables."""

import math
from collections.abc import Sequence

from ...algebra.errors import checked_words
from ...algebra.vectors import FrameError, scale3, sub3
from ..page.projection import between, circle, moved, norm3, on_circle, perpendiculars, silhouette
from ..page.recorder import Direction, Place, Recorder
from .cables import Pulley, route


@checked_words
class Machines(Recorder):
    """The methods of a sketch that draw gears, pulleys and cables."""

    def gear(
        self, C: Place, normal: Direction, radius: float, cone_apex: Place | None = None
    ) -> None:
        """Draw a gear wheel of this pitch radius about C; with ``cone_apex`` its pitch cone."""
        C, normal, r = self._place(C), self._unit(normal), self._length(radius)
        apex = None if cone_apex is None else self._place(cone_apex)
        e1, e2 = perpendiculars(normal)
        count, tooth = 28, ((-0.3, 0.95), (-0.15, 1.05), (0.15, 1.05), (0.3, 0.95))
        corners = ((f, 2 * math.pi * (n + d) / count) for n in range(count) for d, f in tooth)
        rim = self._extend([on_circle(C, e1, e2, r * f, angle) for f, angle in corners])

        @self._record
        def command(canvas):
            canvas.line(rim, "body", closed=True, normal=normal)
            hub = circle(C, normal, 0.18 * r, closed=True)
            canvas.line(hub, "seam", depth=canvas.depth(C) + canvas.pt)
            for end in silhouette(canvas, apex, circle(C, normal, r)) if apex else ():
                canvas.line((apex, end), "line centre")

    def pulley(self, C: Place, normal: Direction, radius: float) -> Pulley:
        """Draw a pulley about C with its axle along ``normal``, and return it for :meth:`cable`;
        ``radius``: of the bottom of its groove, where a cable runs.
        """
        wheel = Pulley(self._place(C), self._unit(normal), self._length(radius))
        C, normal, r = wheel.centre, wheel.normal, wheel.radius
        half = 0.14 * r

        def ring(radius, along):
            return circle(moved(C, along, normal), normal, radius)

        flanges = [self._extend(ring(1.1 * r, sign * half)) for sign in (-1, 1)]

        @self._record
        def command(canvas):
            depth = canvas.depth(C)
            canvas.solid(ring(r, -half) + ring(r, half), "side", depth=depth - 1e-6 * r)
            for sign, flange in zip((-1, 1), flanges, strict=True):
                outwards = scale3(sign, normal)
                canvas.line(flange, "body", closed=True, normal=outwards)
                if canvas.depth(outwards) > 0:
                    groove = circle(moved(C, half, outwards), normal, r, closed=True)
                    canvas.line(groove, "seam", depth=depth + canvas.pt)
                ends = (ring(0.16 * r, sign * x) for x in (half, half + 0.1 * r))
                canvas.cylinder(*ends, outwards, "joint", "joint")

        return wheel

    def cable(self, *stops: Place | Pulley, turns: Sequence[int] | None = None) -> None:
        """Draw a cable from stop to stop, places and pulleys that :meth:`pulley` returned; one that
        ends on the pulley on which it began is a closed belt.

        turns : for each pulley 1 or -1: round it right-handed about its normal, or left-handed; by
            default the turns with the shortest cable

        >>> from newton_euler import Frame
        >>> from newton_euler.drawing import Sketch
        >>> ground = Frame("ground")
        >>> s = Sketch(None, ground, plane="yz")
        >>> wheel = s.pulley((0, 0, 2), ground.i, 0.2)
        >>> s.cable((0, -0.2, 0), wheel, (0, 0.2, 1))  # two weights hang on it
        """
        ends = [P if isinstance(P, Pulley) else self._place(P) for P in stops]
        if len(ends) < 2:
            raise FrameError(
                f"a cable runs between two places or pulleys at least; got {len(ends)}"
            )
        spans, arcs = route(ends, turns)
        for line in [*spans, *arcs]:
            self._extend(line)

        @self._record
        def command(canvas):
            for n, (A, B) in enumerate(spans):
                # an end on a pulley has the depth of its tangent point: it is drawn in front of the
                # groove or behind it, like that point
                lead, tail = (
                    min(1 / 3, stop.radius / norm3(sub3(B, A))) if isinstance(stop, Pulley) else 0
                    for stop in ends[n : n + 2]
                )
                first, last = between(A, B, lead), between(A, B, 1 - tail)
                if lead:
                    canvas.line((A, first), "cable", depth=canvas.depth(A))
                if tail:
                    canvas.line((last, B), "cable", depth=canvas.depth(B))
                canvas.line((first, last), "cable")
            for arc in arcs:
                canvas.curve(arc, "cable")
