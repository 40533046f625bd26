"""Occlusion: the order in which strokes are drawn, so that near ones hide far ones."""

import math
from dataclasses import replace
from itertools import pairwise

from ...algebra.vectors import dot3, scale3, sub3
from .primitives import BODY, Canvas, Stroke
from .projection import between, mean, norm3


def painters_order(canvas: Canvas) -> list[Stroke]:
    """The strokes in the order of drawing: a later one hides an earlier one. Bodies go from far to
    near, by the depths of their middles; but what lies behind the plane of a face is drawn before
    it, what lies on the eye's side after it, and a line through a face is cut in two (Newell,
    Newell and Sancha 1972). Of two faces in one plane, the one recorded later is drawn later.
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
    faces = {n for n, s in enumerate(strokes) if _can_hide(view, s)}
    if not faces:
        return strokes
    boxes = [_box(view, stroke) for stroke in strokes]
    before = [set() for _ in strokes]  # what must be drawn before each
    for f in faces:
        face = strokes[f]
        size = math.copysign(norm3(face.normal), view.depth(face.normal))  # normal to the eye
        normal = scale3(1 / size, face.normal)
        level = dot3(normal, face.points[0])
        left, right, bottom, top = boxes[f]
        left, right, bottom, top = left + eps, right - eps, bottom + eps, top - eps
        for n, (x0, x1, y0, y1) in enumerate(boxes):
            if x0 >= right or x1 <= left or y0 >= top or y1 <= bottom:
                continue
            heights = [dot3(normal, p) - level for p in strokes[n].points]
            least, most = min(heights), max(heights)
            if least > -eps:
                later = n in faces and numbers[n] > numbers[f]
                if most > eps or not strokes[n].closed or later:
                    before[n].add(f)
            elif most < eps:
                before[f].add(n)
    return _topological(strokes, before)


def _box(view, stroke):
    """Left, right, bottom and top of a stroke on the page."""
    xs, ys = zip(*map(view.project, stroke.points), strict=True)
    return min(xs), max(xs), min(ys), max(ys)


def _topological(items, before):
    """The items, each after those in ``before``, otherwise in the given order; a cycle starts with
    its first.
    """
    waiting, out = dict.fromkeys(range(len(items))), []
    while waiting:
        n = next((n for n in waiting if not any(map(waiting.__contains__, before[n]))), None)
        n = next(iter(waiting)) if n is None else n
        del waiting[n]
        out.append(items[n])
    return out
