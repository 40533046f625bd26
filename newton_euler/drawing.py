"""Figures: scenes of frames, vectors, bodies and dimension lines, true to scale, in an orthographic projection.

A :class:`Sketch` only records what it is told to draw. :meth:`Sketch.finish`, which runs by itself when the figure is shown or saved,
projects everything onto a plain 2-D Axes, draws the far before the near, and puts each label where it covers least.
Bodies are to scale; symbols (joints, arrows, axes, dimension lines) have sizes in points of the printed page.
Matplotlib is imported when the figure is finished, not with this module.

Here are frames, vectors, supports and measures; ``shapes`` has the bodies, ``recording`` what happens when, ``projection`` how space is
seen, ``covering`` what covers what, ``labels`` where labels go, ``primitives`` the colours and lines. ``animation`` makes films of sketches.
"""

import math

from .frames import Frame
from .primitives import ARROW, BODY, KINDS, MARK, italic
from .projection import across_most, between, circle, norm3, on_circle
from .shapes import Bodies
from .vectors import FrameError, add3, cross3, dot3, scale3, sub3


class Sketch(Bodies):
    """A figure of a scene on ``ax``, a plain 2-D matplotlib Axes. Lengths in metres; a *place* is a Point, or a Vector or triple of
    coordinates from the origin of ``ground``; a *direction* is a Vector, or a triple along the axes of ``ground``.

    azimuth, elevation : where the eye is, in degrees: about the axis ``up``, from the axis after it ("x" if up is "z") towards the next,
        and above the horizontal
    plane : two axes, as "xz", for a plane figure with the first to the right and the second up
    """

    # -- frames and vectors

    def axes(self, P, frame, length=None, labels="xyz"):
        """The unit vectors of ``frame`` as arrows at P, ``length`` metres long.

        labels : three, as a string or a list, or "" for arrows without; in a list, an axis with the label "" is left out
        """
        if not isinstance(frame, Frame):
            raise FrameError(f"axes(P, frame) draws the axes of a Frame, got {frame!r}")
        if labels and len(labels) != 3:
            raise FrameError(f"the axes have three labels, as in labels='XYZ' or labels=['x_1', 'y_1', 'z_1']; got {labels!r}")
        P, units = self._place(P), [self._triple(e.components(self.frame), "axis") for e in (frame.i, frame.j, frame.k)]
        length = length and self._size(length)

        def command(ink):
            for e, text in zip(units, labels or (" ", " ", " "), strict=True):
                if not text:
                    continue
                tip = add3(P, scale3(length or 38 * ink.pt, e))
                ink.arrow(P, tip, "axis", MARK)
                ink.note(tip, italic(text.strip()), away_from=P, gap=2)

        self._record(command)

    def vector(self, P, v, label="", kind="velocity"):
        """An arrow from P along ``v``. ``kind``, which sets the colour: velocity, acceleration, rate, force, plain.

        The longest arrow of each kind gets a length that suits the figure, the others their share of it.
        """
        if kind not in KINDS:
            raise FrameError(f"an arrow is of the kind {', '.join(KINDS)}; got {kind!r}")
        P, v = self._place(P), self._triple(v, "direction")
        size = norm3(v)
        self._longest[kind] = max(size, self._longest.get(kind, 0))

        def command(ink):
            tip = P
            if size:
                tip = add3(P, scale3(62 * ink.pt / size * max(size / self._longest[kind], 0.25), v))
                ink.arrow(P, tip, kind, ARROW)
            ink.note(tip, italic(label), away_from=P, colour=KINDS[kind], gap=3)

        self._record(command)

    def turn(self, P, axis, label="", radius=None):
        """A curved arrow about ``axis`` through P, right-handed: a rate of turning. ``radius`` in metres."""
        P, axis = self._place(P), self._unit(axis)
        radius = radius and self._size(radius)

        def command(ink):
            r = radius or 17 * ink.pt
            e1, e2 = ink.view.across(ink.view.tilted(axis))
            arc = [on_circle(P, e1, e2, r, math.radians(a)) for a in range(-200, 65, 10)]
            for n in range(0, len(arc) - 2, 2):  # the rear goes behind the body that turns, the front is never hidden
                in_front = ink.view.depth(sub3(arc[n + 1], P)) > -1e-9 * r
                ink.line(arc[n : n + 3], "rate", MARK if in_front else BODY)
            ink.head(arc[-4], arc[-1], "rate", MARK)
            ink.note(arc[-3], italic(label), away_from=P, colour=KINDS["rate"], gap=5)

        self._record(command)

    # -- supports and joints

    def ground(self, P, normal, size=None):
        """Fixed ground at P, a hatched patch that faces ``normal``, ``size`` metres wide."""
        P, normal = self._place(P), self._unit(normal)
        size = size and self._size(size)

        def command(ink):
            half = (size or 44 * ink.pt) / 2
            edge_on = abs(ink.view.depth(normal)) < 0.2
            (ink.support if edge_on else ink.floor)(P, normal, half)

        self._record(command)

    def hinge(self, P, axis=None):
        """A hinge at P: a small circle, or a sleeve along ``axis``."""
        P, axis = self._place(P), None if axis is None else self._unit(axis)

        def command(ink):
            if axis is None or abs(ink.view.depth(axis)) > 0.95:
                ink.disc(P, 3.6, "joint")
            else:
                first, last = (circle(add3(P, scale3(s * 8 * ink.pt, axis)), axis, 4 * ink.pt) for s in (-1, 1))
                ink.cylinder(first, last, axis, "joint", "joint", MARK)

        self._record(command)

    def ball_joint(self, P):
        """A ball joint at P."""
        P = self._place(P)
        self._record(lambda ink: (ink.disc(P, 5.5, "joint"), ink.disc(P, 3.4, "side")))

    def dot(self, P):
        """A small black dot at P."""
        P = self._place(P)
        self._record(lambda ink: ink.disc(P, 2, "dot"))

    # -- measures and names

    def arc(self, C, A, B, label=""):
        """The angle at C from CA to CB, with its label."""
        C, A, B = self._place(C), self._place(A), self._place(B)
        a, b = sub3(A, C), sub3(B, C)
        if not (norm3(a) and norm3(b)):
            raise FrameError(f"an angle at {C} needs two other places to point to; got {A} and {B}")
        a, b = scale3(1 / norm3(a), a), scale3(1 / norm3(b), b)
        angle = math.atan2(norm3(cross3(a, b)), dot3(a, b))
        if norm3(cross3(a, b)) > 1e-9:
            side = cross3(cross3(a, b), a)
        else:  # at 0 and at 180 degrees any plane will do: the one that faces the eye most
            side = cross3(across_most(a, self.view.eye), a)
        side = scale3(1 / norm3(side), side)
        reach = min(norm3(sub3(A, C)), norm3(sub3(B, C)))

        def command(ink):
            r = min(30 * ink.pt, 0.7 * reach)
            ink.line([on_circle(C, a, side, r, angle * n / 24) for n in range(25)], "thin", MARK)
            ink.note(on_circle(C, a, side, r, angle / 2), italic(label), away_from=C, gap=2)

        self._record(command)

    def dimension(self, A, B, label="", offset=None):
        """A dimension line beside AB. ``offset``: by how much, in metres: a number, to the left of AB as seen, or a direction."""
        A, B = self._place(A), self._place(B)
        shift = offset if offset is None or isinstance(offset, (int, float)) else self._triple(offset, "offset")

        def command(ink):
            left = ink.view.sideways(A, B)
            if shift is None:
                inside = dot3(sub3(ink.centre, A), left) > 0
                by = scale3((-16 if inside else 16) * ink.pt, left)
            else:
                by = shift if isinstance(shift, tuple) else scale3(shift, left)
            a, b = add3(A, by), add3(B, by)
            if norm3(by):
                beyond = scale3(3 * ink.pt / norm3(by), by)
                for P, p in ((A, a), (B, b)):
                    ink.line((between(P, p, 0.2), add3(p, beyond)), "measure", MARK)
            if ink.view.seen(sub3(B, A)):
                ink.line((a, b), "measure", MARK)
                ink.head(b, a, "measure", MARK, 6)
                ink.head(a, b, "measure", MARK, 6)
            ink.note(between(a, b, 0.5), italic(label), away_from=between(A, B, 0.5), gap=3)

        self._record(command)

    def path(self, points, lift=0):
        """A curve through many places. ``lift``: how many metres nearer to the eye it counts as, for what covers what: enough of it
        brings a curve out of the body on whose surface it lies (half the radius of a sphere, the radius of a cylinder)."""
        points = [self._place(P) for P in points]
        shift = scale3(self._size(lift), self.view.eye) if lift else (0.0, 0.0, 0.0)

        def command(ink):
            lifted = [add3(P, shift) for P in points]
            for n in range(0, len(lifted) - 1, 4):
                ink.line(lifted[n : n + 5], "path")

        self._record(command)

    def label(self, P, text, offset=None):
        """The name of a place, bold, beside it. ``offset``: a pair, points to the right and up; or a direction to put it in."""
        P = self._place(P)
        pair = tuple(map(float, offset)) if isinstance(offset, (tuple, list)) and len(offset) == 2 else None
        towards = None if offset is None or pair else self._triple(offset, "offset")

        def command(ink):
            away = sub3(P, towards) if towards else ink.centre
            ink.note(P, text, away_from=away, gap=5, weight="bold", fixed=pair)

        self._record(command)
