"""Figures: scenes of frames, vectors, bodies and dimension lines, true to scale, in an orthographic
projection.

A :class:`Sketch` records drawing commands. :meth:`Sketch.finish`, which runs by itself when the
figure is shown or saved, projects everything onto a plain 2-D Axes, draws far before near, and puts
each label where it covers least. Bodies are to scale; symbols (joints, arrows, axes, dimension
lines) have sizes in points of the printed page.

Here are frames, vectors, supports and dimension lines; ``shapes`` has the bodies, ``recorder`` the
recording and rendering, ``projection`` the view, ``occlusion`` the order of drawing,
``label_placement`` the labels, ``primitives`` lines, faces and their styles. ``animation`` makes
animations of sketches.
"""

import math
from collections.abc import Sequence

from ..algebra.vectors import FrameError, cross3, dot3, scale3, sub3
from ..kinematics.frames import Frame
from .primitives import ARROW, BODY, KINDS, MARK
from .projection import between, circle, moved, norm3, on_circle, perpendicular_towards, unit3
from .recorder import Direction, Place
from .shapes import Bodies


class Sketch(Bodies):
    """A figure of a scene on ``ax``, a plain 2-D matplotlib Axes.

    azimuth, elevation : the direction from which the scene is seen, in degrees: about the axis
        ``up``, from the axis after it ("x" if up is "z") towards the next, and above the horizontal
    plane : two axes, as "xz", for a plane figure with the first to the right and the second up

    Lengths are in metres. A *place* is a Point, or a Vector or triple of coordinates from the
    origin of ``ground``; a *direction* is a Vector, or a triple along the axes of ``ground``.

    >>> from matplotlib.figure import Figure
    >>> from newton_euler import Frame
    >>> from newton_euler.drawing import Sketch
    >>> ground = Frame("ground")
    >>> s = Sketch(Figure().add_subplot(), ground, azimuth=30, elevation=15)
    >>> s.rod((0, 0, 0), (0, 0, 2))
    >>> s.vector((0, 0, 2), (0, -1, 0), "$F$", kind="force")
    >>> s.label((0, 0, 0), "O")
    """

    # -- frames and vectors

    def axes(
        self, P: Place, frame: Frame, length: float | None = None, labels: Sequence[str] = "xyz"
    ) -> None:
        """Draw the unit vectors of ``frame`` as arrows at P, ``length`` metres long.

        labels : three, as a string or a list, or "" for arrows without; in a list, an axis with the
            label "" is left out
        """
        if not isinstance(labels, (str, list, tuple)) or (labels and len(labels) != 3):
            raise FrameError(f"the axes have three labels, as labels='XYZ'; got {labels!r}")
        P, units = self._place(P), self._axes_of(frame)
        length = self._or_default(length)

        @self._record
        def command(canvas):
            for e, text in zip(units, labels or (" ", " ", " "), strict=True):
                if text:
                    tip = moved(P, length or 38 * canvas.pt, e)
                    canvas.arrow(P, tip, "axis", MARK)
                    canvas.note(tip, text.strip(), away_from=P, gap=2)

    def vector(self, P: Place, v: Direction, label: str = "", kind: str = "velocity") -> None:
        """Draw an arrow from P along ``v``. ``kind``, which sets the colour: velocity,
        acceleration, rate, force, plain.

        The longest arrow of each kind is 62 points long, the others in proportion, but no shorter
        than a quarter of it.
        """
        if not isinstance(kind, str) or kind not in KINDS:
            raise FrameError(f"an arrow is of the kind {', '.join(KINDS)}; got {kind!r}")
        P, v = self._place(P), self._triple(v, "direction")
        size = norm3(v)
        self._longest[kind] = max(size, self._longest.get(kind, 0))

        @self._record
        def command(canvas):
            tip = P
            if size:
                tip = moved(P, 62 * canvas.pt / size * max(size / self._longest[kind], 0.25), v)
                canvas.arrow(P, tip, kind, ARROW)
            canvas.note(tip, label, away_from=P, colour=KINDS[kind])

    def turn(self, P: Place, axis: Direction, label: str = "", radius: float | None = None) -> None:
        """Draw a curved arrow about ``axis`` through P, right-handed: an angular velocity."""
        P, axis = self._place(P), self._unit(axis)
        radius = self._or_default(radius)

        @self._record
        def command(canvas):
            r = radius or 17 * canvas.pt
            e1, e2 = canvas.perpendiculars(canvas.tilted(axis))
            arc = [on_circle(P, e1, e2, r, math.radians(a)) for a in range(-200, 65, 10)]
            # the rear may be hidden by the body that turns, the front never
            for n in range(0, len(arc) - 2, 2):
                in_front = canvas.depth(sub3(arc[n + 1], P)) > -1e-9 * r
                canvas.line(arc[n : n + 3], "rate", MARK if in_front else BODY)
            canvas.head(arc[-4], arc[-1], "rate", MARK)
            canvas.note(arc[-3], label, away_from=P, colour=KINDS["rate"], gap=5)

    # -- supports and joints

    def ground(self, P: Place, normal: Direction, size: float | None = None) -> None:
        """Draw fixed ground at P, a hatched patch that faces ``normal``, ``size`` metres wide."""
        P, normal = self._place(P), self._unit(normal)
        size = self._or_default(size)

        @self._record
        def command(canvas):
            edge_on = abs(canvas.depth(normal)) < 0.2
            (canvas.support if edge_on else canvas.floor)(P, normal, (size or 44 * canvas.pt) / 2)

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

    def dot(self, P: Place) -> None:
        """Draw a small black dot at P."""
        P = self._place(P)
        self._record(lambda canvas: canvas.disc(P, 2, "dot"))

    # -- dimension lines and labels

    def arc(self, C: Place, A: Place, B: Place, label: str = "") -> None:
        """Draw the angle at C from CA to CB, with its label."""
        C, A, B = self._places(C, A, B)
        a, b = sub3(A, C), sub3(B, C)
        reach = min(norm3(a), norm3(b))
        if not reach:
            raise FrameError(f"an angle at {C} needs two other places; got {A} and {B}")
        a, b = unit3(a), unit3(b)
        normal = cross3(a, b)
        angle = math.atan2(norm3(normal), dot3(a, b))
        # at 0 and at 180 degrees the cross product has no direction: the plane that faces the eye
        if norm3(normal) <= 1e-9:
            normal = perpendicular_towards(a, self.view.eye)
        side = unit3(cross3(normal, a))

        @self._record
        def command(canvas):
            r = min(30 * canvas.pt, 0.7 * reach)
            canvas.line([on_circle(C, a, side, r, angle * n / 24) for n in range(25)], "thin", MARK)
            canvas.note(on_circle(C, a, side, r, angle / 2), label, away_from=C, gap=2)

    def dimension(
        self, A: Place, B: Place, label: str = "", offset: float | Direction | None = None
    ) -> None:
        """Draw a dimension line beside AB. ``offset``: in metres, a number, to the left of AB as
        seen, or a vector; by default 16 points away from the middle of the figure.
        """
        A, B = self._places(A, B)
        if offset is not None and not isinstance(offset, (int, float)):
            offset = self._triple(offset, "offset")

        @self._record
        def command(canvas):
            left, by = canvas.left_of(A, B), offset
            if by is None:
                by = (-16 if dot3(sub3(canvas.centre, A), left) > 0 else 16) * canvas.pt
            if not isinstance(by, tuple):
                by = scale3(by, left)
            a, b = moved(A, 1, by), moved(B, 1, by)
            if norm3(by):
                for P, p in ((A, a), (B, b)):
                    end = moved(p, 3 * canvas.pt / norm3(by), by)
                    canvas.line((between(P, p, 0.2), end), "measure", MARK)
            if canvas.is_seen(sub3(B, A)):
                canvas.line((a, b), "measure", MARK)
                for tail, tip in ((b, a), (a, b)):
                    canvas.head(tail, tip, "measure", MARK, 6)
            canvas.note(between(a, b, 0.5), label, away_from=between(A, B, 0.5))

    def path(self, points: Sequence[Place], lift: float = 0) -> None:
        """Draw a curve through many places. ``lift``: by how many metres it is moved towards the
        eye for occlusion, so that a body does not hide a curve on its surface (half the radius of a
        sphere, the radius of a cylinder).
        """
        lift = self._or_default(lift)
        places = [moved(P, lift or 0.0, self.view.eye) for P in self._several(points, "the points")]
        self._record(lambda canvas: canvas.curve(places, "path"))

    def label(
        self, P: Place, text: str, offset: Direction | tuple[float, float] | None = None
    ) -> None:
        """Write the name of a place, bold, beside it. ``offset``: a pair, points to the right and
        up; or a direction from the place.
        """
        P, pair, away = self._place(P), None, None
        if isinstance(offset, (tuple, list)) and len(offset) == 2:
            pair = tuple(map(float, offset))
        elif offset is not None:
            away = sub3(P, self._triple(offset, "offset"))

        @self._record
        def command(canvas):
            place = away or canvas.centre
            canvas.note(P, text, away_from=place, gap=5, weight="bold", fixed=pair)
