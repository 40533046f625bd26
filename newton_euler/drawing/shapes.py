"""The bodies of a figure, true to scale: rods, disks, solids, plates, pulleys and cables."""

import math
from collections.abc import Sequence

from ..algebra.vectors import FrameError, scale3, sub3
from ..kinematics.frames import Frame
from .cables import Pulley, route
from .primitives import DASHES, SQUARE
from .projection import (
    between,
    circle,
    moved,
    norm3,
    normal_of,
    on_circle,
    on_plane,
    perpendiculars,
    silhouette,
)
from .recorder import Direction, Place, Recorder


class Bodies(Recorder):
    """The methods of a sketch that draw bodies, which hide each other as they do in space."""

    def rod(self, A: Place, B: Place) -> None:
        """Draw a slender rod from A to B."""
        self._straight(A, B, "rod edge", "rod")

    def shaft(self, A: Place, B: Place) -> None:
        """Draw a shaft from A to B with its centre line."""
        self._straight(A, B, "shaft edge", "shaft", "centre")

    def line(self, A: Place, B: Place, style: str = "dashed") -> None:
        """Draw a thin line from A to B, ``style`` solid, dashed, dotted or centre."""
        if not isinstance(style, str) or style not in DASHES:
            raise FrameError(f"a line is {', '.join(DASHES)}; got {style!r}")
        self._straight(A, B, f"line {style}")

    def _straight(self, A, B, *styles):
        ends = self._places(A, B)
        self._record(lambda canvas: canvas.line(ends, styles))

    def spring(self, A: Place, B: Place) -> None:
        """Draw a coil spring from A to B."""
        A, B = self._places(A, B)
        zigzag = [(0.15 + 0.7 * (n + 0.5) / 12, (-1) ** n) for n in range(12)]
        corners = [(0, 0), (0.15, 0), *zigzag, (0.85, 0), (1, 0)]

        @self._record
        def command(canvas):
            side = canvas.left_of(A, B)
            places = [moved(between(A, B, t), 5 * s * canvas.pt, side) for t, s in corners]
            canvas.line(places, "spring")

    def disk(self, C: Place, normal: Direction, radius: float, spoke: Place | None = None) -> None:
        """Draw a thin disk about C. ``spoke``: a place on its rim to which a line from C is drawn;
        it shows how the disk has turned.
        """
        C, normal = self._place(C), self._unit(normal)
        rim = self._rim(C, normal, radius)
        spoke = None if spoke is None else self._place(spoke)

        @self._record
        def command(canvas):
            canvas.face(rim, "body", normal)
            if spoke:
                canvas.line((C, spoke), "ring", depth=canvas.depth(C) + canvas.pt)

    def ring(self, C: Place, normal: Direction, radius: float) -> None:
        """Draw a circle about C without a filling."""
        rim = self._rim(self._place(C), self._unit(normal), radius)
        self._record(lambda canvas: canvas.curve([*rim, rim[0]], "ring"))

    def _rim(self, C, normal, radius):
        return self._extend(circle(C, normal, self._length(radius)))

    def cone(self, apex: Place, axis: Direction, length: float, radius: float) -> None:
        """Draw a cone from its apex along ``axis`` to a base of ``radius`` at the distance
        ``length``.
        """
        apex, axis = self._place(apex), self._unit(axis)
        base = self._rim(moved(apex, self._length(length), axis), axis, radius)

        @self._record
        def command(canvas):
            canvas.solid([apex, *base], "side")
            canvas.end(base, axis, "top")

    def gear(
        self, C: Place, normal: Direction, radius: float, cone_apex: Place | None = None
    ) -> None:
        """Draw a gear wheel about C with the pitch ``radius``; with ``cone_apex`` also the lines of
        its pitch cone.
        """
        C, normal, r = self._place(C), self._unit(normal), self._length(radius)
        apex = None if cone_apex is None else self._place(cone_apex)
        e1, e2 = perpendiculars(normal)
        count, tooth = 28, ((-0.3, 0.95), (-0.15, 1.05), (0.15, 1.05), (0.3, 0.95))
        corners = ((f, 2 * math.pi * (n + d) / count) for n in range(count) for d, f in tooth)
        rim = self._extend([on_circle(C, e1, e2, r * f, angle) for f, angle in corners])

        @self._record
        def command(canvas):
            canvas.face(rim, "body", normal)
            hub = circle(C, normal, 0.18 * r, closed=True)
            canvas.line(hub, "seam", depth=canvas.depth(C) + canvas.pt)
            for end in silhouette(canvas, apex, circle(C, normal, r)) if apex else ():
                canvas.line((apex, end), "line centre")

    def cylinder(self, A: Place, B: Place, radius: float) -> None:
        """Draw a cylinder with the axis from A to B."""
        A, B = self._places(A, B)
        axis = self._unit(sub3(B, A))
        first, last = (self._rim(P, axis, radius) for P in (A, B))
        self._record(lambda canvas: canvas.cylinder(first, last, axis, "side", "top"))

    def sphere(self, C: Place, radius: float) -> None:
        """Draw a sphere about C, with the front of its equator."""
        C, r = self._place(C), self._length(radius)
        outline = self._rim(C, self.view.eye, r)
        equator = circle(C, self.view.tilted(self.view.up), r)

        @self._record
        def command(canvas):
            depth = canvas.depth(C) + r / 2
            canvas.line(outline, "body", closed=True, depth=depth)
            near = [p for p in equator[36:] + equator[:36] if canvas.depth(sub3(p, C)) > 0]
            canvas.line(near, "seam", depth=depth + canvas.pt)

    def plate(self, corners: Sequence[Place]) -> None:
        """Draw a plane plate with these corners, three or more places in order."""
        corners = self._several(corners, "the corners")
        if len(corners) < 3:
            raise FrameError(f"a plate has three corners or more, got {len(corners)}")
        self._record(lambda canvas: canvas.face(corners, "body", normal_of(corners)))

    def box(self, centre: Place, frame: Frame, sizes: Sequence[float]) -> None:
        """Draw a box about ``centre`` with its edges, of three ``sizes`` in metres, along the axes
        of ``frame``.
        """
        C, sizes, edges = self._place(centre), self._triple(sizes, "size"), self._axes_of(frame)
        x, y, z = (scale3(s / 2, e) for s, e in zip(sizes, edges, strict=True))
        faces = []
        for style, half, a, b in (("body", x, y, z), ("side", y, z, x), ("top", z, x, y)):
            for outwards in (half, scale3(-1, half)):
                middle = moved(C, 1, outwards)
                corners = self._extend([on_plane(middle, s, a, t, b) for s, t in SQUARE])
                faces.append((corners, style, outwards))

        @self._record
        def command(canvas):
            for corners, style, outwards in faces:
                if canvas.depth(outwards) > 1e-12 * norm3(sizes):  # seen edge-on is invisible
                    canvas.face(corners, style, outwards)

    # -- pulleys and cables

    def pulley(self, C: Place, normal: Direction, radius: float) -> Pulley:
        """Draw a pulley about C with its axle along ``normal``; ``radius``: of the bottom of its
        groove, where a cable runs. Returns the pulley, which can be a stop of :meth:`cable`.
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
                canvas.face(flange, "body", outwards)
                if canvas.depth(outwards) > 0:
                    groove = circle(moved(C, half, outwards), normal, r, closed=True)
                    canvas.line(groove, "seam", depth=depth + canvas.pt)
                ends = (ring(0.16 * r, sign * x) for x in (half, half + 0.1 * r))
                canvas.cylinder(*ends, outwards, "joint", "joint")

        return wheel

    def cable(self, *stops: Place | Pulley, turns: Sequence[int] | None = None) -> None:
        """Draw a cable from stop to stop, places and pulleys. On a pulley, as :meth:`pulley`
        returned it, it runs in the groove; one that ends on the pulley on which it began is a
        closed belt.

        turns : for each pulley 1 or -1: round it right-handed about its normal, or left-handed; by
            default the turns with the shortest cable

        >>> from matplotlib.figure import Figure
        >>> from newton_euler import Frame
        >>> from newton_euler.drawing.sketch import Sketch
        >>> ground = Frame("ground")
        >>> s = Sketch(Figure().add_subplot(), ground, plane="yz")
        >>> wheel = s.pulley((0, 0, 2), ground.i, 0.2)
        >>> s.cable((0, -0.2, 0), wheel, (0, 0.2, 1))  # two weights hang on it
        """
        stops = tuple(P if isinstance(P, Pulley) else self._place(P) for P in stops)
        if len(stops) < 2:
            raise FrameError(
                f"a cable runs between two stops or more, places or pulleys; got {len(stops)}"
            )
        spans, arcs = route(stops, turns)
        for line in [*spans, *arcs]:
            self._extend(line)

        @self._record
        def command(canvas):
            for n, (A, B) in enumerate(spans):
                # an end on a pulley has the depth of its tangent point: drawn over the groove, or
                # behind it, as that point is
                lead, tail = (
                    min(1 / 3, stop.radius / norm3(sub3(B, A))) if isinstance(stop, Pulley) else 0
                    for stop in stops[n : n + 2]
                )
                first, last = between(A, B, lead), between(A, B, 1 - tail)
                if lead:
                    canvas.line((A, first), "cable", depth=canvas.depth(A))
                if tail:
                    canvas.line((last, B), "cable", depth=canvas.depth(B))
                canvas.line((first, last), "cable")
            for arc in arcs:
                canvas.curve(arc, "cable")
