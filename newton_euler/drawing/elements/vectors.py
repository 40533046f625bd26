"""Arrows: axes, vectors, rotations."""

import math
from collections.abc import Sequence

from ...algebra.errors import checked_words
from ...algebra.scalars import clipped
from ...algebra.vectors import FrameError, Vector, sub3
from ...kinematics.frames import Frame
from ..page.primitives import ARROW, BLACK, BODY, KINDS, MARK, MOVED, Kind
from ..page.projection import between, norm3, on_circle, unit3
from ..page.projection import moved as ahead
from ..page.recorder import Direction, Place, Recorder


@checked_words
class Vectors(Recorder):
    """The methods of a sketch that draw arrows."""

    def axes(
        self,
        P: Place,
        frame: Frame,
        length: float | None = None,
        labels: Sequence[str] = "xyz",
        moved: bool | None = None,
    ) -> None:
        """Draw the unit vectors of ``frame`` as arrows at P, ``length`` metres long.

        labels : three, as a string or a list, or "" for none; an axis labelled "" is left out
        moved : True for the axes of a frame that moves, which are brown and dashed; fixed ones are
            black. By default those of every frame but the ground of the sketch.
        """
        if not isinstance(labels, (str, list, tuple)) or (labels and len(labels) != 3):
            raise FrameError(f"the axes have three labels, as labels='XYZ'; got {labels!r}")
        P, units = self._place(P), self._axes_of(frame)
        length = self._or_default(length)
        moving = frame is not self.frame if moved is None else moved
        style, colour = ("moved axis", MOVED) if moving else ("axis", BLACK)
        drawn = [(e, text) for e, text in zip(units, labels or "   ", strict=True) if text]

        @self._record
        def command(canvas):
            axes = [(ahead(P, length or 38 * canvas.pt, e), text.strip()) for e, text in drawn]
            canvas.triads.append((P, axes))
            for tip, text in axes:
                canvas.arrow(P, tip, style, MARK)
                canvas.note(tip, text, away_from=P, gap=2, colour=colour)

    def vector(
        self, P: Place, v: Direction, label: str = "", kind: Kind = "velocity", size: str = ""
    ) -> None:
        """Draw an arrow from P along ``v``; a dot if ``v`` is negligible against the longest.
        That is 62 points long (``Sketch(…, arrows=62)``), the others in proportion, but no shorter
        than a quarter of it, unless the figure moves. To the scale of the bodies: :meth:`arrow`.

        kind : velocity, acceleration, rate, force or plain, which sets the colour
        size : a unit, as "m/s", with which the magnitude is written after the label
        """
        P, v = self._place(P), self._triple(v, "direction")
        magnitude = self._measured(kind, v)

        @self._record
        def command(canvas):
            shortest = self._shortest * self._longest[kind]
            tip = self._scaled(canvas, P, v, kind, max(magnitude, shortest), kind)
            text = self._with_size(label, magnitude, kind, size)
            canvas.note(tip, text, away_from=P, colour=KINDS[kind])

    def sum(
        self, P: Place, amount: Vector, label: str = "", kind: Kind = "acceleration", size: str = ""
    ) -> None:
        """Draw the terms of a vector that is a sum (``amount.terms``) head to tail from P, each
        with its name, and the sum as the broad arrow from P that closes them, with the arguments of
        :meth:`vector`. A term that is zero is a dot with the label "… = 0".
        """
        if not isinstance(amount, Vector) or not amount.terms:
            raise FrameError(
                f"a Vector with terms is drawn, as P.acceleration(ground); got {clipped(amount)}"
            )
        P, total = self._place(P), self._triple(amount, "direction")
        terms = [(n, self._triple(term, "direction")) for n, term in amount.terms.items()]
        magnitude, *sizes = [self._measured(kind, v) for v in (total, *(v for _, v in terms))]

        @self._record
        def command(canvas):
            start = P
            for (name, v), length in zip(terms, sizes, strict=True):
                tip = self._scaled(canvas, start, v, kind, length, kind)
                text = name if tip != start else f"{name} = 0"
                canvas.note(between(start, tip, 0.5), text, colour=KINDS[kind])
                start = tip
            tip = self._scaled(canvas, P, total, kind, magnitude, f"{kind} sum")
            text = self._with_size(label, magnitude, kind, size)
            canvas.note(between(P, tip, 0.5), text, colour=KINDS[kind], weight="bold")

    def _measured(self, kind, v):
        """The magnitude of v, which counts for the scale of its kind."""
        size = norm3(v)
        self._longest[kind] = max(size, self._longest.get(kind, 0))
        return size

    def _scaled(self, canvas, P, v, kind, size, style):
        """The tip of an arrow from P that stands for this size; a dot if ``v`` is but round-off."""
        longest, own, tip = self._longest[kind], norm3(v), P
        if own > 1e-9 * longest:
            tip = ahead(P, self.arrows * canvas.pt * size / longest / own, v)
        if tip == P:
            canvas.disc(P, 2.5, style, ARROW)
        else:
            canvas.arrow(P, tip, style, ARROW)
        return tip

    def _with_size(self, label, size, kind, unit):
        """The label with the magnitude, in as many decimals as suit the longest of its kind."""
        if not unit:
            return label
        decimals = 2 - math.floor(math.log10(self._longest[kind] or 1))
        number = f"{size:.{decimals}f}" if 0 <= decimals < 7 else f"{size:.3g}"
        return f"{label} = {number} {unit}" if label else f"{number} {unit}"

    def arrow(self, A: Place, B: Place, label: str = "", kind: Kind = "plain") -> None:
        """Draw an arrow from A to B, true to scale as a body is, with its label at the middle."""
        A, B = self._places(A, B)

        @self._record
        def command(canvas):
            middle = between(A, B, 0.5)
            canvas.arrow(A, B, kind, ARROW)
            beside = ahead(middle, -1, canvas.left_of(A, B))
            canvas.note(middle, label, away_from=beside, colour=KINDS[kind])

    def turn(self, P: Place, axis: Direction, label: str = "", radius: float | None = None) -> None:
        """Draw an angular velocity as a curved arrow about ``axis`` through P; zero is a dot."""
        P, axis = self._place(P), self._triple(axis, "direction")
        radius = self._or_default(radius)
        if not norm3(axis):
            self.vector(P, axis, label, kind="rate")
            return
        axis = unit3(axis)

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
