"""What names and measures a scene: angles, dimension lines, labels."""

import math
from typing import TypeAlias

from ...algebra.errors import checked_words
from ...algebra.vectors import FrameError, cross3, dot3, scale3, sub3
from ..page.primitives import MARK
from ..page.projection import between, moved, norm3, on_circle, perpendicular_towards, unit3
from ..page.recorder import Direction, Place, Recorder

Offset: TypeAlias = Direction | tuple[float, float]


@checked_words
class Measures(Recorder):
    """The methods of a sketch that draw angles, dimension lines and labels."""

    def arc(
        self, C: Place, A: Place, B: Place, label: str = "", radius: float | None = None
    ) -> None:
        """Draw the angle at C from CA to CB, with its label. ``radius``: in metres, by default 30
        points, and up to 54 for a small angle, so that its label has room.
        """
        C, A, B = self._places(C, A, B)
        radius = self._or_default(radius)
        a, b = sub3(A, C), sub3(B, C)
        reach = min(norm3(a), norm3(b))
        if not reach:
            raise FrameError(f"an angle at {C} needs two other places; got {A} and {B}")
        a, b = unit3(a), unit3(b)
        normal = cross3(a, b)
        angle = math.atan2(norm3(normal), dot3(a, b))
        # the cross product has no direction at 0 and at 180 degrees: take the plane facing the eye
        if norm3(normal) <= 1e-9:
            normal = perpendicular_towards(a, self.view.eye)
        side = unit3(cross3(normal, a))

        @self._record
        def command(canvas):
            points = 30 * min(max(1, 0.6 / max(angle, 0.1)), 1.8)
            r = radius or min(points * canvas.pt, 0.7 * reach)
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

    def dot(self, P: Place, label: str = "", offset: Offset | None = None) -> None:
        """Draw a small black dot at P, with its name; ``offset`` as for :meth:`label`."""
        place = self._place(P)
        self._record(lambda canvas: canvas.disc(place, 2, "dot"))
        if label:
            self.label(P, label, offset)

    def label(self, P: Place, text: str, offset: Offset | None = None, bold: bool = True) -> None:
        """Write the name of a place beside it. ``offset``: a pair, points to the right and up; or a
        direction from the place. ``bold``: as for points and bodies; a quantity or a word is not.
        """
        P, pair, away = self._place(P), None, None
        if isinstance(offset, (tuple, list)) and len(offset) == 2:
            pair = tuple(map(float, offset))
        elif offset is not None:
            away = sub3(P, self._triple(offset, "offset"))

        @self._record
        def command(canvas):
            place = away or canvas.centre
            weight = "bold" if bold else "normal"
            canvas.note(P, text, away_from=place, gap=5, weight=weight, fixed=pair)
