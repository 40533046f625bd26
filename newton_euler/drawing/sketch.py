"""Figures: scenes of frames, vectors, bodies and dimension lines, true to scale, in an orthographic
projection.

A :class:`Sketch` records what it is told to draw. :meth:`Sketch.finish`, which runs by itself when
the figure is shown or saved, projects everything onto a plain 2-D Axes, draws the far before the
near, and puts each label where it covers least. Bodies are to scale; symbols (joints, arrows, axes,
dimension lines) have sizes in points of the printed page.

Here are frames, vectors, supports and measures; ``shapes`` has the bodies, ``recording`` the order
of events, ``projection`` the view, ``covering`` occlusion, ``labels`` label placement,
``primitives`` lines, faces and their styles. ``animation`` makes films of sketches.
"""

import math

from ..algebra.vectors import FrameError, add3, cross3, dot3, scale3, sub3
from ..kinematics.frames import Frame
from .primitives import ARROW, BODY, KINDS, MARK
from .projection import between, circle, norm3, on_circle, perpendicular_towards, unit3
from .shapes import Bodies


class Sketch(Bodies):
    """A figure of a scene on ``ax``, a plain 2-D matplotlib Axes. Lengths in metres; a *place* is a
    Point, or a Vector or triple of coordinates from the origin of ``ground``; a *direction* is a
    Vector, or a triple along the axes of ``ground``.

    azimuth, elevation : the direction from which the scene is seen, in degrees: about the axis
        ``up``, from the axis after it ("x" if up is "z") towards the next, and above the horizontal
    plane : two axes, as "xz", for a plane figure with the first to the right and the second up
    """

    # -- frames and vectors

    def axes(self, P, frame, length=None, labels="xyz"):
        """Draw the unit vectors of ``frame`` as arrows at P, ``length`` metres long.

        labels : three, as a string or a list, or "" for arrows without; in a list, an axis with the
            label "" is left out
        """
        if not isinstance(frame, Frame):
            raise FrameError(f"axes(P, frame) draws the axes of a Frame, got {frame!r}")
        if labels and len(labels) != 3:
            raise FrameError(
                "the axes have three labels, as in labels='XYZ' or labels=['x_1', 'y_1', "
                f"'z_1']; got {labels!r}"
            )
        P, units = (
            self._place(P),
            [self._triple(e.components(self.frame), "axis") for e in (frame.i, frame.j, frame.k)],
        )
        length = length and self._length(length)

        @self._record
        def command(canvas):
            for e, text in zip(units, labels or (" ", " ", " "), strict=True):
                if text:
                    tip = add3(P, scale3(length or 38 * canvas.pt, e))
                    canvas.arrow(P, tip, "axis", MARK)
                    canvas.note(tip, text.strip(), away_from=P, gap=2)

    def vector(self, P, v, label="", kind="velocity"):
        """Draw an arrow from P along ``v``. ``kind``, which sets the colour: velocity,
        acceleration, rate, force, plain.

        The longest arrow of each kind gets a length that suits the figure, the others their share
        of it.
        """
        if kind not in KINDS:
            raise FrameError(f"an arrow is of the kind {', '.join(KINDS)}; got {kind!r}")
        P, v = self._place(P), self._triple(v, "direction")
        size = norm3(v)
        self._longest[kind] = max(size, self._longest.get(kind, 0))

        @self._record
        def command(canvas):
            tip = P
            if size:
                tip = add3(
                    P, scale3(62 * canvas.pt / size * max(size / self._longest[kind], 0.25), v)
                )
                canvas.arrow(P, tip, kind, ARROW)
            canvas.note(tip, label, away_from=P, colour=KINDS[kind])

    def turn(self, P, axis, label="", radius=None):
        """Draw a curved arrow about ``axis`` through P, right-handed: an angular velocity.
        ``radius`` in metres.
        """
        P, axis = self._place(P), self._unit(axis)
        radius = radius and self._length(radius)

        @self._record
        def command(canvas):
            r = radius or 17 * canvas.pt
            e1, e2 = canvas.perpendiculars(canvas.tilted(axis))
            arc = [on_circle(P, e1, e2, r, math.radians(a)) for a in range(-200, 65, 10)]
            # the rear goes behind the body that turns, the front is never hidden
            for n in range(0, len(arc) - 2, 2):
                in_front = canvas.depth(sub3(arc[n + 1], P)) > -1e-9 * r
                canvas.line(arc[n : n + 3], "rate", MARK if in_front else BODY)
            canvas.head(arc[-4], arc[-1], "rate", MARK)
            canvas.note(arc[-3], label, away_from=P, colour=KINDS["rate"], gap=5)

    # -- supports and joints

    def ground(self, P, normal, size=None):
        """Draw fixed ground at P, a hatched patch that faces ``normal``, ``size`` metres wide."""
        P, normal = self._place(P), self._unit(normal)
        size = size and self._length(size)

        @self._record
        def command(canvas):
            edge_on = abs(canvas.depth(normal)) < 0.2
            (canvas.support if edge_on else canvas.floor)(P, normal, (size or 44 * canvas.pt) / 2)

    def hinge(self, P, axis=None):
        """Draw a hinge at P: a small circle, or a sleeve along ``axis``."""
        P, axis = self._place(P), None if axis is None else self._unit(axis)

        @self._record
        def command(canvas):
            if axis is None or abs(canvas.depth(axis)) > 0.95:
                canvas.disc(P, 3.6, "joint")
            else:
                ends = (
                    circle(add3(P, scale3(s * 8 * canvas.pt, axis)), axis, 4 * canvas.pt)
                    for s in (-1, 1)
                )
                canvas.cylinder(*ends, axis, "joint", "joint", MARK)

    def ball_joint(self, P):
        """Draw a ball joint at P."""
        P = self._place(P)
        self._record(lambda canvas: (canvas.disc(P, 5.5, "joint"), canvas.disc(P, 3.4, "side")))

    def dot(self, P):
        """Draw a small black dot at P."""
        P = self._place(P)
        self._record(lambda canvas: canvas.disc(P, 2, "dot"))

    # -- measures and names

    def arc(self, C, A, B, label=""):
        """Draw the angle at C from CA to CB, with its label."""
        C, A, B = map(self._place, (C, A, B))
        a, b = sub3(A, C), sub3(B, C)
        reach = min(norm3(a), norm3(b))
        if not reach:
            raise FrameError(f"an angle at {C} needs two other places to point to; got {A} and {B}")
        a, b = unit3(a), unit3(b)
        normal = cross3(a, b)
        angle = math.atan2(norm3(normal), dot3(a, b))
        # at 0 and at 180 degrees any plane will do: the one that faces the eye most
        if norm3(normal) <= 1e-9:
            normal = perpendicular_towards(a, self.view.eye)
        side = unit3(cross3(normal, a))

        @self._record
        def command(canvas):
            r = min(30 * canvas.pt, 0.7 * reach)
            canvas.line([on_circle(C, a, side, r, angle * n / 24) for n in range(25)], "thin", MARK)
            canvas.note(on_circle(C, a, side, r, angle / 2), label, away_from=C, gap=2)

    def dimension(self, A, B, label="", offset=None):
        """Draw a dimension line beside AB. ``offset``: by how much, in metres: a number, to the
        left of AB as seen, or a direction.
        """
        A, B = self._place(A), self._place(B)
        shift = (
            offset
            if offset is None or isinstance(offset, (int, float))
            else self._triple(offset, "offset")
        )

        @self._record
        def command(canvas):
            left = canvas.left_of(A, B)
            if shift is None:
                inside = dot3(sub3(canvas.centre, A), left) > 0
                by = scale3((-16 if inside else 16) * canvas.pt, left)
            else:
                by = shift if isinstance(shift, tuple) else scale3(shift, left)
            a, b = add3(A, by), add3(B, by)
            if norm3(by):
                beyond = scale3(3 * canvas.pt / norm3(by), by)
                for P, p in ((A, a), (B, b)):
                    canvas.line((between(P, p, 0.2), add3(p, beyond)), "measure", MARK)
            if canvas.is_seen(sub3(B, A)):
                canvas.line((a, b), "measure", MARK)
                canvas.head(b, a, "measure", MARK, 6)
                canvas.head(a, b, "measure", MARK, 6)
            canvas.note(between(a, b, 0.5), label, away_from=between(A, B, 0.5))

    def path(self, points, lift=0):
        """Draw a curve through many places. ``lift``: how many metres nearer to the eye it counts
        as, for occlusion: enough of it brings a curve out of the body on whose surface it lies
        (half the radius of a sphere, the radius of a cylinder).
        """
        points = [self._place(P) for P in points]
        shift = scale3(self._length(lift), self.view.eye) if lift else (0.0, 0.0, 0.0)
        self._record(lambda canvas: canvas.curve([add3(P, shift) for P in points], "path"))

    def label(self, P, text, offset=None):
        """Write the name of a place, bold, beside it. ``offset``: a pair, points to the right and
        up; or a direction to put it in.
        """
        P = self._place(P)
        pair = (
            tuple(map(float, offset))
            if isinstance(offset, (tuple, list)) and len(offset) == 2
            else None
        )
        towards = None if offset is None or pair else self._triple(offset, "offset")

        @self._record
        def command(canvas):
            away = sub3(P, towards) if towards else canvas.centre
            canvas.note(P, text, away_from=away, gap=5, weight="bold", fixed=pair)
