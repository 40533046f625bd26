"""The orthographic projection of a figure, and geometry of triples, circles and outlines."""

import math
from collections.abc import Sequence

from ...algebra.scalars import Triple, real
from ...algebra.vectors import FrameError, add3, cross3, dot3, scale3, sub3


class View:
    """An orthographic projection: unit vectors right, up and to the eye, along ground axes."""

    def __init__(self, right: Triple, up: Triple):
        self.right, self.up, self.eye = right, up, cross3(right, up)

    def project(self, p: Triple) -> tuple[float, float]:
        """The coordinates of the place p on the page, to the right and up."""
        return dot3(p, self.right), dot3(p, self.up)

    def depth(self, p: Triple) -> float:
        """The coordinate of p towards the eye."""
        return dot3(p, self.eye)

    def offset(self, p: Triple, x: float, y: float) -> Triple:
        """The place that is seen at (x, y) from p, at the depth of p."""
        return on_plane(p, x, self.right, y, self.up)

    def is_seen(self, v: Triple) -> bool:
        """False if v is within 6 degrees of the line of sight, and looks like a dot."""
        return math.hypot(*self.project(v)) > 0.1 * norm3(v)

    def slant(self, v: Triple) -> float:
        """How well a direction suits hatching: best if steep and leaning to the right."""
        x, y = self.project(v)
        angle = math.atan2(y, x)
        return abs(math.sin(angle)) + 0.2 * math.sin(2 * angle)

    def left_of(self, A: Triple, B: Triple) -> Triple:
        """The unit vector in the page at a right angle to AB, to its left."""
        x, y = self.project(sub3(B, A))
        size = math.hypot(x, y)
        return self.offset((0, 0, 0), -y / size, x / size) if size else self.up

    def tilted(self, axis: Triple) -> Triple:
        """The axis; or a direction near it, if a circle about it is seen nearly edge-on."""
        d = self.depth(axis)
        if abs(d) >= 0.3:  # the circle's axes are as 3 to 10
            return axis
        return unit3(moved(axis, math.copysign(0.3, d if abs(d) > 1e-9 else 1), self.eye))

    def perpendiculars(self, axis: Triple) -> tuple[Triple, Triple]:
        """Two unit vectors, right-handed with ``axis``, the first towards the eye."""
        e1 = perpendicular_towards(axis, self.eye)
        return e1, cross3(axis, e1)


def space_view(azimuth: float, elevation: float, up: str) -> View:
    """The view from the direction (azimuth, elevation), in degrees, with the axis ``up`` upwards.
    Azimuth 0 looks from the axis after ``up``, and grows towards the next.
    """
    azimuth, elevation = real(azimuth, "the azimuth"), real(elevation, "the elevation")
    a, h = math.radians(azimuth), math.radians(elevation)
    right = -math.sin(a), math.cos(a), 0.0
    upwards = -math.sin(h) * math.cos(a), -math.sin(h) * math.sin(a), math.cos(h)
    n = 2 - "xyz".index(up)  # these are along the two axes after ``up``, and along it
    return View(right[n:] + right[:n], upwards[n:] + upwards[:n])


def plane_view(plane: str) -> View:
    """The view at a right angle to a plane; "xz" has x to the right and z up."""
    if not isinstance(plane, str) or len(plane) != 2 or len(set(plane) & set("xyz")) != 2:
        raise FrameError(f"a plane is two axes, as in plane='xz', the second up; got {plane!r}")
    return View(*(tuple(float(axis == name) for axis in "xyz") for name in plane))


def norm3(v: Triple) -> float:
    """The magnitude of v, a float."""
    return math.sqrt(dot3(v, v))


def unit3(v: Triple) -> Triple:
    """The unit vector along v."""
    return scale3(1 / norm3(v), v)


def moved(P: Triple, s: float, v: Triple) -> Triple:
    """The place P + s v."""
    return add3(P, scale3(s, v))


def on_plane(P: Triple, s: float, a: Triple, t: float, b: Triple) -> Triple:
    """The place P + s a + t b."""
    return add3(P, moved(scale3(s, a), t, b))


def between(A: Triple, B: Triple, t: float) -> Triple:
    """The place at the fraction t of the way from A to B."""
    return moved(A, t, sub3(B, A))


def mean(points: Sequence[Triple]) -> Triple:
    """The mean of several places."""
    return tuple(sum(c) / len(points) for c in zip(*points, strict=True))


def perpendicular_towards(axis: Triple, target: Triple) -> Triple:
    """The unit vector at a right angle to ``axis`` that is nearest to ``target``."""
    v = moved(target, -dot3(axis, target), axis)
    return perpendiculars(axis)[0] if norm3(v) < 1e-6 else unit3(v)


def perpendiculars(axis: Triple) -> tuple[Triple, Triple]:
    """Two unit vectors that form a right-handed triple with ``axis``."""
    # the ground axis farthest from parallel gives the first
    least = min(range(3), key=lambda n: abs(axis[n]))
    e1 = perpendicular_towards(axis, tuple(float(n == least) for n in range(3)))
    return e1, cross3(axis, e1)


def on_circle(C: Triple, e1: Triple, e2: Triple, radius: float, angle: float) -> Triple:
    """The place on a circle about C at an angle from e1 towards e2."""
    return on_plane(C, radius * math.cos(angle), e1, radius * math.sin(angle), e2)


def circle(
    C: Triple, normal: Triple, radius: float, count: int = 60, closed: bool = False
) -> list[Triple]:
    """Places on a circle, right-handed about ``normal``; ``closed`` repeats the first."""
    e1, e2 = perpendiculars(normal)
    return [on_circle(C, e1, e2, radius, 2 * math.pi * n / count) for n in range(count + closed)]


def normal_of(corners: list[Triple]) -> Triple:
    """The normal of a plane polygon, of twice its area, by Newell's sum of cross products."""
    total = (0.0, 0.0, 0.0)
    for p, q in zip(corners, corners[1:] + corners[:1], strict=True):
        total = add3(total, cross3(p, q))
    return total


def convex_hull(view: View, points: Sequence[Triple]) -> list[Triple]:
    """The points on the convex hull as seen on the page, counter-clockwise, by Andrew's monotone
    chain (1979) on a fine grid of whole numbers, so that points above each other are that exactly.
    """
    if not points:
        return []
    seen = [view.project(p) for p in points]
    grid = 1e-9 * max(max(column) - min(column) for column in zip(*seen, strict=True)) or 1.0
    pairs = zip(seen, points, strict=True)
    ordered = sorted((round(x / grid), round(y / grid), p) for (x, y), p in pairs)

    def half(points):
        out = []
        for p in points:
            while out[1:] and not _turns_left(*out[-2:], p):
                out.pop()
            out.append(p)
        return out[:-1]

    return [p for _, _, p in half(ordered) + half(ordered[::-1])]


def _turns_left(a, b, c):
    return (b[0] - a[0]) * (c[1] - b[1]) > (b[1] - a[1]) * (c[0] - b[0])


def silhouette(view: View, apex: Triple, rim: Sequence[Triple]) -> Sequence[Triple]:
    """The places of the rim where lines from the apex look tangent; none if it is seen inside."""
    outline = convex_hull(view, [apex, *rim])
    if apex not in outline:
        return ()
    n = outline.index(apex)
    return outline[n - 1], outline[(n + 1) % len(outline)]
