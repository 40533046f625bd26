"""What covers what: the order in which strokes are drawn, the far before the near."""

import math
from dataclasses import replace
from itertools import pairwise

from .primitives import BODY
from .projection import between, mean, norm3
from .vectors import dot3, sub3


def far_to_near(ink):
    """The strokes in the order of drawing. Bodies go by depth, but what lies beyond the plane of a face is always drawn before the face,
    and what lies on the eye's side after it; a line through a face is cut in two."""
    faces = [s for s in ink.strokes if s.normal and s.layer == BODY and abs(ink.view.depth(s.normal)) > 0.02]
    bodies = []
    for stroke in ink.strokes:
        if stroke.layer == BODY:
            bodies += _cut(ink.view, stroke, faces)
    bodies.sort(key=lambda s: s.depth)
    marks = [s for s in ink.strokes if s.layer != BODY]
    return _by_planes(ink.view, bodies, 1e-3 * ink.pt) + sorted(marks, key=lambda s: (s.layer, s.depth))


def _cut(view, stroke, faces):
    """The pieces of a straight line between the faces it passes through; anything else whole."""
    if stroke.closed or len(stroke.points) != 2:
        return [stroke]
    A, B = stroke.points
    cuts = {0.0, 1.0}
    for face in faces:
        a, b = (dot3(face.normal, sub3(P, face.points[0])) for P in (A, B))
        if a * b < 0 and _inside(view, between(A, B, a / (a - b)), face.points):
            cuts.add(a / (a - b))
    cuts = sorted(cuts)
    if len(cuts) == 2:
        return [stroke]
    pieces = [(between(A, B, s), between(A, B, t)) for s, t in pairwise(cuts)]
    return [replace(stroke, points=piece, depth=view.depth(mean(piece)), cut=True) for piece in pieces]


def _inside(view, p, corners):
    """Whether p is seen inside the polygon: a ray to the right crosses its edges an odd number of times."""
    x, y = view.flat(p)
    flat = [view.flat(q) for q in corners]
    odd = False
    for (x0, y0), (x1, y1) in zip(flat, flat[1:] + flat[:1], strict=True):
        if (y0 > y) != (y1 > y) and x < x0 + (y - y0) * (x1 - x0) / (y1 - y0):
            odd = not odd
    return odd


def _by_planes(view, strokes, eps):
    """Strokes sorted by depth, put into an order that also obeys the planes of the faces, as far as these agree."""
    import numpy as np

    faces = [n for n, s in enumerate(strokes) if s.normal and abs(view.depth(s.normal)) > 0.02]
    if not faces:
        return strokes
    starts = np.cumsum([0, *(len(s.points) for s in strokes[:-1])])
    points = np.array([p for s in strokes for p in s.points])
    seen = points @ np.array([view.right, view.up]).T
    low, high = np.minimum.reduceat(seen, starts), np.maximum.reduceat(seen, starts)
    before = [set() for _ in strokes]  # what must be drawn before each
    for f in faces:
        face = strokes[f]
        normal = np.array(face.normal) * math.copysign(1 / norm3(face.normal), view.depth(face.normal))
        height = (points - points[starts[f]]) @ normal
        least, most = np.minimum.reduceat(height, starts), np.maximum.reduceat(height, starts)
        meets = ((low < high[f] - eps) & (high > low[f] + eps)).all(axis=1)
        for n in np.flatnonzero(meets & (least > -eps) & (most > -eps)):
            if most[n] > eps or not strokes[n].closed:
                before[n].add(f)
        for n in np.flatnonzero(meets & (most < eps) & (least < -eps)):
            before[f].add(n)
    return _released(strokes, before)


def _released(items, before):
    """The items in their order, each held back until all ``before`` it are out; where they wait for each other the first goes."""
    waiting, out = list(range(len(items))), []
    while waiting:
        n = next((n for n in waiting if not before[n].intersection(waiting)), waiting[0])
        waiting.remove(n)
        out.append(items[n])
    return out
