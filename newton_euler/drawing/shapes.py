"""The bodies of a figure, true to scale: rods, disks, solids, plates, pulleys and the cables over
them.
"""

import math

from ..algebra.vectors import FrameError, add3, scale3, sub3
from ..kinematics.frames import Frame
from .cables import Pulley, route
from .primitives import DASHES
from .projection import between, circle, norm3, normal_of, on_circle, perpendiculars, silhouette
from .recorder import Recorder


class Bodies(Recorder):
    """The methods of a sketch that draw bodies, which hide each other as they do in space."""

    def rod(self, A, B):
        """Draw a slender rod from A to B."""
        self._straight(A, B, "rod edge", "rod")

    def shaft(self, A, B):
        """Draw a shaft from A to B with its centre line."""
        self._straight(A, B, "shaft edge", "shaft", "centre")

    def line(self, A, B, style="dashed"):
        """Draw a thin line from A to B, ``style`` solid, dashed, dotted or centre."""
        if style not in DASHES:
            raise FrameError(f"a line is {', '.join(DASHES)}; got {style!r}")
        self._straight(A, B, f"line {style}")

    def _straight(self, A, B, *styles):
        ends = self._place(A), self._place(B)
        self._record(lambda canvas: canvas.line(ends, styles))

    def spring(self, A, B):
        """Draw a coil spring from A to B."""
        A, B = self._place(A), self._place(B)

        @self._record
        def command(canvas):
            side = canvas.left_of(A, B)
            swings = [
                (0, 0),
                (0.15, 0),
                *((0.15 + 0.7 * (n + 0.5) / 12, (-1) ** n) for n in range(12)),
                (0.85, 0),
                (1, 0),
            ]
            canvas.line(
                [add3(between(A, B, t), scale3(5 * s * canvas.pt, side)) for t, s in swings],
                "spring",
            )

    def disk(self, C, normal, radius, spoke=None):
        """Draw a thin disk about C. ``spoke``: a place on its rim that is joined to C, which shows
        how it has turned.
        """
        C, normal = self._place(C), self._unit(normal)
        rim = self._rim(C, normal, radius)
        spoke = None if spoke is None else self._place(spoke)

        @self._record
        def command(canvas):
            canvas.face(rim, "body", normal)
            if spoke:
                canvas.line((C, spoke), "ring", depth=canvas.depth(C) + canvas.pt)

    def ring(self, C, normal, radius):
        """Draw a circle about C without a filling."""
        rim = self._rim(self._place(C), self._unit(normal), radius)
        self._record(lambda canvas: canvas.curve([*rim, rim[0]], "ring"))

    def _rim(self, C, normal, radius):
        return self._extend(circle(C, normal, self._length(radius)))

    def cone(self, apex, axis, length, radius):
        """Draw a cone from its apex along ``axis`` to a base of ``radius`` at the distance
        ``length``.
        """
        apex, axis = self._place(apex), self._unit(axis)
        base = self._rim(add3(apex, scale3(self._length(length), axis)), axis, radius)

        @self._record
        def command(canvas):
            canvas.solid([apex, *base], "side")
            canvas.end(base, axis, "top")

    def gear(self, C, normal, radius, cone_apex=None):
        """Draw a gear wheel about C with the pitch ``radius``; with ``cone_apex`` also the lines of
        its pitch cone.
        """
        C, normal, r = self._place(C), self._unit(normal), self._length(radius)
        apex = None if cone_apex is None else self._place(cone_apex)
        e1, e2 = perpendiculars(normal)
        count, tooth = 28, ((-0.3, 0.95), (-0.15, 1.05), (0.15, 1.05), (0.3, 0.95))
        rim = self._extend(
            [
                on_circle(C, e1, e2, r * f, 2 * math.pi * (n + d) / count)
                for n in range(count)
                for d, f in tooth
            ]
        )

        @self._record
        def command(canvas):
            canvas.face(rim, "body", normal)
            canvas.line(
                circle(C, normal, 0.18 * r, closed=True), "seam", depth=canvas.depth(C) + canvas.pt
            )
            for end in silhouette(canvas, apex, circle(C, normal, r)) if apex else ():
                canvas.line((apex, end), "line centre")

    def cylinder(self, A, B, radius):
        """Draw a cylinder with the axis from A to B."""
        A, B = self._place(A), self._place(B)
        axis = self._unit(sub3(B, A))
        first, last = (self._rim(P, axis, radius) for P in (A, B))
        self._record(lambda canvas: canvas.cylinder(first, last, axis, "side", "top"))

    def sphere(self, C, radius):
        """Draw a sphere about C."""
        C, r = self._place(C), self._length(radius)
        outline = self._rim(C, self.view.eye, r)
        equator = circle(C, self.view.tilted(self.view.up), r)

        @self._record
        def command(canvas):
            depth = canvas.depth(C) + r / 2
            canvas.line(outline, "body", closed=True, depth=depth)
            near = [p for p in equator[36:] + equator[:36] if canvas.depth(sub3(p, C)) > 0]
            canvas.line(near, "seam", depth=depth + canvas.pt)

    def plate(self, corners):
        """Draw a plane plate with these corners, three or more places in order."""
        corners = [self._place(P) for P in corners]
        if len(corners) < 3:
            raise FrameError(f"a plate has three corners or more, got {len(corners)}")
        self._record(lambda canvas: canvas.face(corners, "body", normal_of(corners)))

    def box(self, centre, frame, sizes):
        """Draw a box about ``centre`` with its edges, of three ``sizes`` in metres, along the axes
        of ``frame``.
        """
        if not isinstance(frame, Frame):
            raise FrameError(
                "box(centre, frame, sizes) takes the directions of its edges from a Frame, "
                f"got {frame!r}"
            )
        C, sizes = self._place(centre), self._triple(sizes, "sizes")
        halves = [
            scale3(s / 2, e.components(self.frame))
            for s, e in zip(sizes, (frame.i, frame.j, frame.k), strict=True)
        ]

        def corners(outwards, n):
            middle, a, b = add3(C, outwards), halves[(n + 1) % 3], halves[(n + 2) % 3]
            return [
                add3(middle, add3(scale3(s, a), scale3(t, b)))
                for s, t in ((1, 1), (-1, 1), (-1, -1), (1, -1))
            ]

        faces = [
            (n, outwards, self._extend(corners(outwards, n)))
            for n in range(3)
            for outwards in (halves[n], scale3(-1, halves[n]))
        ]

        @self._record
        def command(canvas):
            for n, outwards, face in faces:
                if canvas.depth(outwards) > 1e-12 * norm3(sizes):
                    canvas.face(face, ("body", "side", "top")[n], halves[n])

    # -- pulleys and cables

    def pulley(self, C, normal, radius):
        """Draw a pulley about C with its axle along ``normal``; ``radius`` is that of the bottom of
        its groove, where a cable runs.

        Returns the pulley, to be named as a stop in :meth:`cable`.
        """
        wheel = Pulley(self._place(C), self._unit(normal), self._length(radius))
        C, normal, r = wheel.centre, wheel.normal, wheel.radius
        half = 0.14 * r

        def ring(radius, along):
            return circle(add3(C, scale3(along, normal)), normal, radius)

        flanges = [self._extend(ring(1.1 * r, sign * half)) for sign in (-1, 1)]

        @self._record
        def command(canvas):
            depth = canvas.depth(C)
            canvas.solid(ring(r, -half) + ring(r, half), "side", depth=depth - 1e-6 * r)
            for sign, flange in zip((-1, 1), flanges, strict=True):
                outwards = scale3(sign, normal)
                canvas.face(flange, "body", outwards)
                if canvas.depth(outwards) > 0:
                    canvas.line(
                        circle(add3(C, scale3(half, outwards)), normal, r, closed=True),
                        "seam",
                        depth=depth + canvas.pt,
                    )
                canvas.cylinder(
                    ring(0.16 * r, sign * half),
                    ring(0.16 * r, sign * (half + 0.1 * r)),
                    outwards,
                    "joint",
                    "joint",
                )

        return wheel

    def cable(self, *stops, turns=None):
        """Draw a cable from place to place. Over a pulley, as :meth:`pulley` returned it, it runs
        in the groove and is tangent to it; one that ends on the pulley where it began is a closed
        belt.

        turns : which way it goes round each pulley, 1 for right-handed about the pulley's normal
            and -1 for the other; by default the shortest of the ways

        >>> from matplotlib.figure import Figure
        >>> from newton_euler import Frame
        >>> from newton_euler.drawing.sketch import Sketch
        >>> ground = Frame("ground")
        >>> s = Sketch(Figure().add_subplot(), ground, plane="yz")
        >>> s.cable((0, -0.2, 0), s.pulley((0, 0, 2), ground.i, 0.2), (0, 0.2, 1))  # two weights hang on it
        """
        stops = [stop if isinstance(stop, Pulley) else self._place(stop) for stop in stops]
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
                # the ends that touch a pulley have the depth of their tangent points, so that they
                # lie over its groove or behind it as these do
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
