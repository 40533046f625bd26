"""Occlusion: the order in which strokes are drawn, so that near ones hide far ones."""

import math
from dataclasses import replace
from itertools import pairwise

from ...algebra.vectors import dot3, sub3
from .primitives import BODY
from .projection import between, mean, norm3


def painters_order(canvas):
    """The strokes in the order of drawing: a later one hides an earlier one. Bodies go from far to
    near, by the depths of their middles; but what lies behind the plane of a face is drawn before
    it, what lies on the eye's side after it, and a line through a face is cut in two (Newell,
    Newell and Sancha 1972). Of two faces in one plane that recorded later is drawn later.
    Marks and arrows lie over all bodies.
    """
    bodies = [s for s in canvas.strokes if s.layer == BODY]
    faces = [s for s in bodies if _can_hide(canvas, s)]
    pieces = sorted(
        ((piece, n) for n, s in enumerate(bodies) for piece in _cut(canvas, s, faces)),
        key=lambda item: item[0].depth,
    )
    marks = sorted((s for s in canvas.strokes if s.layer != BODY), key=lambda s: (s.layer, s.depth))
    strokes, numbers = zip(*pieces, strict=True) if pieces else ((), ())
    return [*_by_planes(canvas, strokes, numbers, 1e-3 * canvas.pt), *marks]


def _can_hide(view, stroke):
    """True for a face that is not seen edge-on."""
    return stroke.normal and abs(view.depth(stroke.normal)) > 0.02


def _cut(view, stroke, faces):
    """The pieces into which faces cut a straight line; any other stroke as a whole."""
    if stroke.closed or len(stroke.points) != 2:
        return [stroke]
    A, B = stroke.points
    cuts = {0.0, 1.0}
    for face in faces:
        a, b = (dot3(face.normal, sub3(P, face.points[0])) for P in (A, B))
        if a * b < 0 and _inside(view, between(A, B, a / (a - b)), face.points):
            cuts.add(a / (a - b))
    if len(cuts) == 2:
        return [stroke]
    pieces = pairwise(between(A, B, t) for t in sorted(cuts))
    return [replace(stroke, points=p, depth=view.depth(mean(p)), cut=True) for p in pieces]


def _inside(view, p, corners):
    """True if p is seen inside the polygon: a ray to the right crosses an odd number of edges."""
    x, y = view.project(p)
    flat = [view.project(q) for q in corners]
    odd = False
    for (x0, y0), (x1, y1) in zip(flat, flat[1:] + flat[:1], strict=True):
        if (y0 > y) != (y1 > y) and x < x0 + (y - y0) * (x1 - x0) / (y1 - y0):
            odd = not odd
    return odd


def _by_planes(view, strokes, numbers, eps):
    """The strokes, sorted by depth, reordered to obey the planes of the faces too where these do
    not contradict each other, to within ``eps`` (m); ``numbers``: in the order of recording.
    """
    import numpy as np

    faces = {n: None for n, s in enumerate(strokes) if _can_hide(view, s)}
    if not faces:
        return strokes
    starts = np.cumsum([0, *(len(s.points) for s in strokes[:-1])])
    points = np.array([p for s in strokes for p in s.points])
    seen = points @ np.array([view.right, view.up]).T
    low, high = np.minimum.reduceat(seen, starts), np.maximum.reduceat(seen, starts)
    before = [set() for _ in strokes]  # what must be drawn before each
    for f in faces:
        face = strokes[f]
        size = math.copysign(norm3(face.normal), view.depth(face.normal))  # normal to the eye
        height = (points - points[starts[f]]) @ (np.array(face.normal) / size)
        least, most = np.minimum.reduceat(height, starts), np.maximum.reduceat(height, starts)
        meets = ((low < high[f] - eps) & (high > low[f] + eps)).all(axis=1)
        for n in np.flatnonzero(meets & (least > -eps) & (most > -eps)):
            if most[n] > eps or not strokes[n].closed or (n in faces and numbers[n] > numbers[f]):
                before[n].add(f)
        for n in np.flatnonzero(meets & (most < eps) & (least < -eps)):
            before[f].add(n)
    return _topological(strokes, before)


def _topological(items, before):
    """The items, each after those in ``before``, else as given; a cycle starts with its first."""
    waiting, out = list(range(len(items))), []
    while waiting:
        n = next((n for n in waiting if not before[n].intersection(waiting)), waiting[0])
        waiting.remove(n)
        out.append(items[n])
    return out
