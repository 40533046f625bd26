"""Arrows: axes, vectors, rotations."""

import math
from collections.abc import Sequence

from ...algebra.vectors import FrameError, sub3
from ...kinematics.frames import Frame
from ..page.primitives import ARROW, BODY, KINDS, MARK
from ..page.projection import between, moved, norm3, on_circle
from ..page.recorder import Direction, Place, Recorder


class Vectors(Recorder):
    """The methods of a sketch that draw arrows."""

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
        drawn = [(e, text) for e, text in zip(units, labels or "   ", strict=True) if text]

        @self._record
        def command(canvas):
            axes = [(moved(P, length or 38 * canvas.pt, e), text.strip()) for e, text in drawn]
            canvas.triads.append((P, axes))
            for tip, text in axes:
                canvas.arrow(P, tip, "axis", MARK)
                canvas.note(tip, text, away_from=P, gap=2)

    def vector(self, P: Place, v: Direction, label: str = "", kind: str = "velocity") -> None:
        """Draw an arrow from P along ``v``. ``kind``, which sets the colour: velocity,
        acceleration, rate, force, plain.

        The longest arrow of each kind is 62 points long, the others in proportion, but no shorter
        than a quarter of it. For an arrow to the scale of the bodies, see :meth:`arrow`.
        """
        _known(kind)
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

    def arrow(self, A: Place, B: Place, label: str = "", kind: str = "plain") -> None:
        """Draw an arrow from A to B, true to scale as a body is, with its label at the middle."""
        _known(kind)
        A, B = self._places(A, B)

        @self._record
        def command(canvas):
            middle = between(A, B, 0.5)
            canvas.arrow(A, B, kind, ARROW)
            beside = moved(middle, -1, canvas.left_of(A, B))
            canvas.note(middle, label, away_from=beside, colour=KINDS[kind])

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

    def swing(self, C: Place, A: Place, axis: Direction, label: str = "") -> None:
        """Draw a curved arrow from A on its circle about ``axis`` through C, right-handed: the rate
        at which an arm CA swings. It is 44 points long, and at most 60 degrees.
        """
        C, A, axis = self._place(C), self._place(A), self._unit(axis)
        centre, e1, e2, radius = self._circle_through(A, C, axis)

        @self._record
        def command(canvas):
            angle = min(44 * canvas.pt / radius, math.pi / 3)
            arc = [on_circle(centre, e1, e2, radius, angle * n / 16) for n in range(17)]
            canvas.line(arc, "rate", ARROW)
            canvas.head(arc[-4], arc[-1], "rate", ARROW)
            canvas.note(arc[10], label, away_from=centre, colour=KINDS["rate"], gap=4)


def _known(kind):
    if not isinstance(kind, str) or kind not in KINDS:
        raise FrameError(f"an arrow is of the kind {', '.join(KINDS)}; got {kind!r}")
