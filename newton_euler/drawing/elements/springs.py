"""Springs and dampers."""

import math
from itertools import pairwise

from ...algebra.errors import checked_words
from ...algebra.vectors import FrameError, cross3, scale3, sub3
from ..page.projection import between, moved, on_circle, on_plane, perpendicular_towards
from ..page.recorder import Place, Recorder

STEPS = 24  # straight pieces of one coil


@checked_words
class Springs(Recorder):
    """The methods of a sketch that draw springs and dampers."""

    def spring(self, A: Place, B: Place, radius: float | None = None, coils: int = 8) -> None:
        """Draw a spring from A to B: a zigzag, or with ``radius`` (m) a helix of ``coils``."""
        A, B = self._places(A, B)
        if radius is not None:
            self._helix(A, B, self._length(radius), coils)
            return
        zigzag = [(0.15 + 0.7 * (n + 0.5) / 12, 5 * (-1) ** n) for n in range(12)]
        corners = [(0, 0), (0.15, 0), *zigzag, (0.85, 0), (1, 0)]
        self._record(lambda canvas: canvas.line(_beside(canvas, A, B, corners), "spring"))

    def _helix(self, A, B, r, coils):
        if not isinstance(coils, int) or not 1 <= coils <= 100:
            raise FrameError(f"a spring has 1 to 100 coils; got {coils!r}")
        axis = self._unit(sub3(B, A))
        near = perpendicular_towards(axis, self.view.eye)
        side = cross3(axis, near)
        count = STEPS * coils
        angles = [2 * math.pi * n / STEPS - math.pi / 2 for n in range(count + 1)]
        centres = [between(A, B, n / count) for n in range(count + 1)]
        pairs = zip(centres, angles, strict=True)
        helix = self._extend([on_circle(C, near, side, r, angle) for C, angle in pairs])

        edges = (A, 1.2 * r), (A, -1.2 * r), (B, -1.2 * r), (B, 1.2 * r)

        @self._record
        def command(canvas):
            # what is in the spring lies between two invisible planes
            for height in (-0.1 * r, 0.1 * r):
                plane = [on_plane(P, height, near, w, side) for P, w in edges]
                outwards = scale3(math.copysign(1, height), near)
                canvas.line(plane, (), closed=True, normal=outwards)
            # cut where it passes from behind these planes to their front
            half = STEPS // 2
            cuts = [n for n in range(count + 1) if n % half in (1, half - 1) or n in (0, count)]
            for first, last in pairwise(cuts):
                canvas.line(helix[first : last + 1], "spring")

    def damper(self, A: Place, B: Place) -> None:
        """Draw a damper from A, where its piston rod ends, to B, where its cylinder does."""
        A, B = self._places(A, B)
        cylinder = (0.35, 7), (0.65, 7), (0.65, -7), (0.35, -7)
        parts = ((0, 0), (0.5, 0)), ((0.5, 5), (0.5, -5)), cylinder, ((0.65, 0), (1, 0))

        @self._record
        def command(canvas):
            for corners in parts:
                canvas.line(_beside(canvas, A, B, corners), "spring")


def _beside(canvas, A, B, corners):
    """For each corner (t, w) the place at t of the way from A to B, w points to the left."""
    left = canvas.left_of(A, B)
    return [moved(between(A, B, t), w * canvas.pt, left) for t, w in corners]
