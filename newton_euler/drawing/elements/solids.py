"""Bodies to scale: disks, plates, tubes, cones, spheres, boxes, with their holes."""

import math
from collections.abc import Sequence
from typing import Literal

from ...algebra.errors import checked_words
from ...algebra.vectors import FrameError, cross3, dot3, scale3, sub3
from ...kinematics.frames import Frame
from ..page.primitives import SQUARE
from ..page.projection import circle, moved, norm3, normal_of, on_plane, unit3
from ..page.recorder import Direction, Place, Recorder

SMOOTH = math.cos(math.radians(25))  # cosine of the angle below which two faces of a wall are one
SHADES = {"light": "top", "medium": "body", "dark": "inside"}


@checked_words
class Solids(Recorder):
    """The methods of a sketch that draw bodies, which hide each other as they do in space."""

    def disk(
        self,
        C: Place,
        normal: Direction,
        radius: float,
        spoke: Place | None = None,
        thickness: float = 0,
        hole: float = 0,
    ) -> None:
        """Draw a disk about C, ``thickness`` metres thick, with a round ``hole`` of this radius.
        ``spoke``: a place on its rim to which a line shows how the disk has turned.
        """
        C, normal, r = self._place(C), self._unit(normal), self._length(radius)
        thickness, hole = self._or_default(thickness) or 0.0, self._bore(hole, r)
        back = moved(C, -thickness / 2, normal)
        near = thickness / 2 if self.view.depth(normal) > 0 else -thickness / 2
        spoke = None if spoke is None else moved(self._place(spoke), near, normal)
        front = moved(C, near, normal)
        self._rim(moved(C, thickness / 2, normal), normal, r)  # the extent holds both rims
        rim = self._rim(back, normal, r)
        holes = [circle(back, normal, hole)] if hole else []

        @self._record
        def command(canvas):
            _extrude(canvas, rim, holes, scale3(thickness, normal), normal)
            if spoke:
                canvas.line((front, spoke), "ring", depth=canvas.depth(front) + canvas.pt)

    def plate(
        self,
        corners: Sequence[Place],
        holes: Sequence[Sequence[Place]] = (),
        thickness: float = 0,
        shade: Literal["light", "medium", "dark"] = "medium",
    ) -> None:
        """Draw a plane plate with these corners, three or more places in order.

        holes : their outlines, each a sequence of places, as from :meth:`around`
        thickness : in metres, half of it on either side of the corners; a plate may so become a
            block with an L-shaped outline and a bore

        >>> from newton_euler import Frame
        >>> from newton_euler.drawing import Sketch
        >>> ground = Frame("ground")
        >>> s = Sketch(None, ground)
        >>> corners = [(0, 0, 0), (4, 0, 0), (4, 2, 0), (0, 2, 0)]
        >>> s.plate(corners, holes=[s.around((1, 1, 0), (1.5, 1, 0), ground.k)], thickness=0.2)
        """
        corners = self._several(corners, "the corners")
        if len(corners) < 3:
            raise FrameError(f"a plate has three corners or more, got {len(corners)}")
        holes = self._outlines(holes)
        thickness = self._or_default(thickness) or 0.0
        normal = normal_of(corners)
        if thickness:
            if not norm3(normal):
                raise FrameError(f"a plate with a thickness has an area; got the corners {corners}")
            normal = unit3(normal)

        def lower(outline):
            return [moved(P, -thickness / 2, normal) for P in outline]

        base, bores = lower(corners), [lower(hole) for hole in holes]
        if thickness:
            self._extend([moved(P, sign * thickness, normal) for P in base for sign in (0, 1)])
        along = scale3(thickness, normal)
        self._record(lambda canvas: _extrude(canvas, base, bores, along, normal, SHADES[shade]))

    def _outlines(self, holes):
        """The outlines of holes as lists of triples."""
        try:
            return [self._several(holes[n], "the places of a hole") for n in range(len(holes))]
        except (TypeError, KeyError, IndexError, FrameError) as error:
            raise FrameError(
                f"holes are outlines of places, as holes=[s.around(...)]; got {str(holes)[:60]}"
            ) from error

    def cylinder(self, A: Place, B: Place, radius: float, bore: float = 0) -> None:
        """Draw a cylinder with the axis from A to B; with a ``bore``, its radius, an open tube."""
        A, B = self._places(A, B)
        axis, r = self._unit(sub3(B, A)), self._length(radius)
        bore = self._bore(bore, r)
        first, last = (self._rim(P, axis, r) for P in (A, B))
        if not bore:
            self._record(lambda canvas: canvas.cylinder(first, last, axis, "side", "top"))
            return
        hole = circle(A, axis, bore)
        self._record(lambda canvas: _extrude(canvas, first, [hole], sub3(B, A), axis, "top"))

    def _bore(self, radius, outer):
        """The radius of a hole in a body of the radius ``outer``, or 0."""
        radius = self._or_default(radius) or 0.0
        if radius >= outer:
            raise FrameError(f"a hole is narrower than its body, {outer:g} m; got {radius:g}")
        return radius

    def cone(
        self, apex: Place, axis: Direction, length: float, radius: float, open: bool = False
    ) -> None:
        """Draw a cone from its apex along ``axis`` to a base of ``radius`` at the distance
        ``length``; ``open``: without the base, so that one sees into it.
        """
        apex, axis = self._place(apex), self._unit(axis)
        base = self._rim(moved(apex, self._length(length), axis), axis, radius)
        self._capped([apex], base, axis, open)

    def hemisphere(self, C: Place, axis: Direction, radius: float, open: bool = False) -> None:
        """Draw half a sphere about C, with its top along ``axis``; ``open``: a shell without the
        base, as a dome, or as a bowl where ``axis`` points down.
        """
        C, axis, r = self._place(C), self._unit(axis), self._length(radius)
        rim = self._rim(C, axis, r)
        outline = circle(C, self.view.eye, r)
        half = [p for p in outline if dot3(sub3(p, C), axis) > 0]
        self._capped(self._extend(half), rim, scale3(-1, axis), open)

    def _capped(self, points, rim, outwards, is_open):
        """Record a convex body between some points and a flat base."""

        @self._record
        def command(canvas):
            if is_open:
                canvas.shell([*points, *rim], rim, outwards)
            else:
                canvas.solid([*points, *rim], "side")
                canvas.end(rim, outwards, "top")

    def sphere(self, C: Place, radius: float) -> None:
        """Draw a sphere about C, with the front of its equator."""
        C, r = self._place(C), self._length(radius)
        outline = self._rim(C, self.view.eye, r)
        equator = circle(C, self.view.tilted(self.view.up), r)

        @self._record
        def command(canvas):
            depth = canvas.depth(C) + r / 2
            canvas.line(outline, "body", closed=True, depth=depth)
            far = min(range(len(equator)), key=lambda n: canvas.depth(equator[n]))
            near = [p for p in equator[far:] + equator[:far] if canvas.depth(sub3(p, C)) > 0]
            canvas.line(near, "seam", depth=depth + canvas.pt)

    def box(self, centre: Place, frame: Frame, sizes: Sequence[float]) -> None:
        """Draw a box about ``centre`` with its edges, of three ``sizes`` in metres, along the axes
        of ``frame``. For a block with holes, see :meth:`plate`.
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
                    canvas.line(corners, style, closed=True, normal=outwards)


def _extrude(canvas, outline, holes, along, normal, style="body"):
    """Add the body between an outline and its copy moved by ``along``; if zero, the one face."""
    if not norm3(along):
        canvas.line(outline, style, closed=True, normal=normal, holes=holes)
        return
    loops = [outline, *holes]
    for loop, sense in zip(loops, (1, *[-1] * len(holes)), strict=True):
        # outlines with the material on their left, seen against ``along``
        if dot3(normal_of(loop), along) * sense < 0:
            loop = loop[::-1]
        for wall in _seen_walls(canvas, loop, along):
            around = [*wall, *(moved(P, 1, along) for P in reversed(wall))]
            flat = normal_of(around) if len(wall) == 2 else None
            canvas.line(around, "side" if sense > 0 else "inside", closed=True, normal=flat)
    for step, outwards in ((0, scale3(-1, along)), (1, along)):
        face, *bores = ([moved(P, step, along) for P in loop] for loop in loops)
        canvas.end(face, outwards, style, holes=bores)


def _seen_walls(canvas, loop, along):
    """The runs of edges, as places, whose wall faces the eye and has no sharp edge."""
    edges = list(zip(loop, loop[1:] + loop[:1], strict=True))
    normals = [cross3(tuple(b - a for a, b in zip(*edge, strict=True)), along) for edge in edges]
    seen = [canvas.depth(n) > 1e-9 * norm3(n) for n in normals]

    def goes_on(n):
        a, b = normals[n - 1], normals[n]
        return seen[n - 1] and seen[n] and dot3(a, b) > SMOOTH * norm3(a) * norm3(b)

    start = next((n for n in range(len(edges)) if not goes_on(n)), 0)
    runs = []
    for n in (*range(start, len(edges)), *range(start)):
        if not seen[n]:
            continue
        if runs and n != start and goes_on(n):
            runs[-1].append(edges[n][1])
        else:
            runs.append(list(edges[n]))
    return runs
