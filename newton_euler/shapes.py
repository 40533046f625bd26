"""The bodies of a figure, true to scale: rods, disks, solids, plates, pulleys and the cables over them."""

import math

from .frames import Frame
from .primitives import DASHES
from .projection import across, between, circle, norm3, normal_of, on_circle, silhouette
from .recording import Recording
from .tangents import Pulley, route
from .vectors import FrameError, add3, scale3, sub3


class Bodies(Recording):
    """The methods of a sketch that draw bodies; bodies cover each other as they do in space."""

    def rod(self, A, B):
        """A slender rod from A to B."""
        self._straight(A, B, "rod edge", "rod")

    def shaft(self, A, B):
        """A shaft from A to B with its centre line."""
        self._straight(A, B, "shaft edge", "shaft", "centre")

    def line(self, A, B, style="dashed"):
        """A thin line from A to B, ``style`` solid, dashed, dotted or centre."""
        if style not in DASHES:
            raise FrameError(f"a line is {', '.join(DASHES)}; got {style!r}")
        self._straight(A, B, f"line {style}")

    def _straight(self, A, B, *looks):
        A, B = self._place(A), self._place(B)
        self._record(lambda ink: ink.line((A, B), looks))

    def spring(self, A, B):
        """A coil spring from A to B."""
        A, B = self._place(A), self._place(B)

        def command(ink):
            side = ink.view.sideways(A, B)
            swings = [(0, 0), (0.15, 0), *((0.15 + 0.7 * (n + 0.5) / 12, (-1) ** n) for n in range(12)), (0.85, 0), (1, 0)]
            ink.line([add3(between(A, B, t), scale3(5 * s * ink.pt, side)) for t, s in swings], "spring")

        self._record(command)

    def disk(self, C, normal, radius, spoke=None):
        """A thin disk about C. ``spoke``: a place on its rim that is joined to C, which shows how it has turned."""
        C, normal = self._place(C), self._unit(normal)
        rim = self._reach(*circle(C, normal, self._size(radius)))
        spoke = None if spoke is None else self._place(spoke)

        def command(ink):
            ink.face(rim, "body", normal)
            if spoke:
                ink.line((C, spoke), "ring", depth=ink.view.depth(C) + ink.pt)

        self._record(command)

    def ring(self, C, normal, radius):
        """A circle about C without a filling."""
        rim = self._reach(*circle(self._place(C), self._unit(normal), self._size(radius)))

        def command(ink):
            for n in range(0, len(rim), 4):
                ink.line([*rim, rim[0]][n : n + 5], "ring")

        self._record(command)

    def cone(self, apex, axis, length, radius):
        """A cone from its apex along ``axis`` to a base of ``radius`` at the distance ``length``."""
        apex, axis = self._place(apex), self._unit(axis)
        base = self._reach(*circle(add3(apex, scale3(self._size(length), axis)), axis, self._size(radius)))

        def command(ink):
            ink.solid([apex, *base], "side")
            ink.end(base, axis, "top")

        self._record(command)

    def gear(self, C, normal, radius, cone_apex=None):
        """A gear wheel about C with the pitch ``radius``; with ``cone_apex`` also the lines of its pitch cone."""
        C, normal, r = self._place(C), self._unit(normal), self._size(radius)
        apex = None if cone_apex is None else self._place(cone_apex)
        e1, e2 = across(normal)
        count = 28
        teeth = [(n + d, 1 + h) for n in range(count) for d, h in ((-0.3, -0.05), (-0.15, 0.05), (0.15, 0.05), (0.3, -0.05))]
        rim = self._reach(*(on_circle(C, e1, e2, r * f, 2 * math.pi * n / count) for n, f in teeth))

        def command(ink):
            ink.face(rim, "body", normal)
            ink.line(circle(C, normal, 0.18 * r, closed=True), "seam", depth=ink.view.depth(C) + ink.pt)
            for end in silhouette(ink.view, apex, circle(C, normal, r)) if apex else ():
                ink.line((apex, end), "line centre")

        self._record(command)

    def cylinder(self, A, B, radius):
        """A cylinder with the axis from A to B."""
        A, B, r = self._place(A), self._place(B), self._size(radius)
        axis = self._unit(sub3(B, A))
        first, last = (self._reach(*circle(P, axis, r)) for P in (A, B))
        self._record(lambda ink: ink.cylinder(first, last, axis, "side", "top"))

    def sphere(self, C, radius):
        """A sphere about C."""
        C, r = self._place(C), self._size(radius)
        outline = self._reach(*circle(C, self.view.eye, r))
        equator = circle(C, self.view.tilted(self.view.up), r)

        def command(ink):
            ink.line(outline, "body", closed=True, depth=ink.view.depth(C) + r / 2)
            near = [p for p in equator[36:] + equator[:36] if ink.view.depth(sub3(p, C)) > 0]
            ink.line(near, "seam", depth=ink.view.depth(C) + r / 2 + ink.pt)

        self._record(command)

    def plate(self, corners):
        """A plane plate with these corners, three or more places in order."""
        corners = [self._place(P) for P in corners]
        if len(corners) < 3:
            raise FrameError(f"a plate has three corners or more, got {len(corners)}")
        self._record(lambda ink: ink.face(corners, "body", normal_of(corners)))

    def box(self, centre, frame, sizes):
        """A box about ``centre`` with its edges, of three ``sizes`` in metres, along the axes of ``frame``."""
        if not isinstance(frame, Frame):
            raise FrameError(f"box(centre, frame, sizes) takes the directions of its edges from a Frame, got {frame!r}")
        C, sizes = self._place(centre), self._triple(sizes, "sizes")
        halves = [scale3(s / 2, e.components(self.frame)) for s, e in zip(sizes, (frame.i, frame.j, frame.k), strict=True)]
        faces = [(sign, n) for n in range(3) for sign in (1, -1)]

        def corners(sign, n):
            middle, a, b = add3(C, scale3(sign, halves[n])), halves[(n + 1) % 3], halves[(n + 2) % 3]
            return [add3(middle, add3(scale3(s, a), scale3(t, b))) for s, t in ((1, 1), (-1, 1), (-1, -1), (1, -1))]

        self._reach(*(p for face in faces for p in corners(*face)))

        def command(ink):
            for sign, n in faces:
                if ink.view.depth(scale3(sign, halves[n])) > 1e-12 * norm3(sizes):
                    ink.face(corners(sign, n), ("body", "side", "top")[n], halves[n])

        self._record(command)

    # -- pulleys and cables

    def pulley(self, C, normal, radius):
        """A pulley about C with its axle along ``normal``; ``radius`` is that of the bottom of its groove, where a cable runs.

        Returns the pulley, to be named as a stop in :meth:`cable`.
        """
        wheel = Pulley(self._place(C), self._unit(normal), self._size(radius))
        C, normal, r = wheel.centre, wheel.normal, wheel.radius
        half, rim = 0.14 * r, 1.1 * r

        def ring(radius, along):
            return circle(add3(C, scale3(along, normal)), normal, radius)

        rims = self._reach(*ring(rim, -half), *ring(rim, half))

        def command(ink):
            deep = ink.view.depth(C)
            ink.solid(ring(r, -half) + ring(r, half), "side", depth=deep - 1e-6 * r)
            for sign, flange in ((-1, rims[:60]), (1, rims[60:])):
                outwards = scale3(sign, normal)
                ink.face(flange, "body", outwards)
                if ink.view.depth(outwards) > 0:
                    ink.line(circle(add3(C, scale3(half, outwards)), normal, r, closed=True), "seam", depth=deep + ink.pt)
                ink.cylinder(ring(0.16 * r, sign * half), ring(0.16 * r, sign * (half + 0.1 * r)), outwards, "joint", "joint")

        self._record(command)
        return wheel

    def cable(self, *stops, turns=None):
        """A cable from place to place. Over a pulley, as :meth:`pulley` returned it, it runs in the groove and is tangent to it; one that
        ends on the pulley where it began is a closed belt.

        turns : which way it goes round each pulley, 1 for right-handed about the pulley's normal and -1 for the other; by default the
            shortest of the ways

        >>> from matplotlib.figure import Figure
        >>> from newton_euler import Frame
        >>> from newton_euler.drawing import Sketch
        >>> ground = Frame("ground")
        >>> s = Sketch(Figure().add_subplot(), ground, plane="yz")
        >>> s.cable((0, -0.2, 0), s.pulley((0, 0, 2), ground.i, 0.2), (0, 0.2, 1))  # two weights hang on it
        """
        stops = [stop if isinstance(stop, Pulley) else self._place(stop) for stop in stops]
        if len(stops) < 2:
            raise FrameError(f"a cable runs between two stops or more, places or pulleys; got {len(stops)}")
        legs, arcs = route(stops, turns)
        self._reach(*(P for line in [*legs, *arcs] for P in line))

        def command(ink):
            for n, (A, B) in enumerate(legs):
                # the ends that touch a pulley lie over its groove or behind it as the touching point does, whatever the middle of the leg does
                lead, tail = (min(1 / 3, stop.radius / norm3(sub3(B, A))) if isinstance(stop, Pulley) else 0 for stop in stops[n : n + 2])
                first, last = between(A, B, lead), between(A, B, 1 - tail)
                if lead:
                    ink.line((A, first), "cable", depth=ink.view.depth(A))
                if tail:
                    ink.line((last, B), "cable", depth=ink.view.depth(B))
                ink.line((first, last), "cable")
            for arc in arcs:
                for n in range(0, len(arc) - 1, 4):
                    ink.line(arc[n : n + 5], "cable")

        self._record(command)
