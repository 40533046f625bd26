"""A plane outline with holes, drawn out to a body: plates, disks and tubes with a thickness."""

import math

from ...algebra.scalars import Triple
from ...algebra.vectors import cross3, dot3, scale3
from ..page.primitives import Canvas, Outline, Outlines
from ..page.projection import moved, norm3, normal_of

SMOOTH = math.cos(math.radians(25))  # cosine of the angle below which two faces of a wall are one


def extrude(
    canvas: Canvas,
    outline: Outline,
    holes: Outlines,
    along: Triple,
    normal: Triple,
    style: str = "body",
) -> None:
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
