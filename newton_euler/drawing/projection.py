"""The orthographic projection of a figure, and the geometry of triples, circles and outlines."""

import math

from ..algebra.vectors import FrameError, add3, cross3, dot3, scale3, sub3


class View:
    """An orthographic projection, given by unit vectors to the right, up, and to the eye, in the
    ground.
    """

    def __init__(self, right, up):
        self.right, self.up, self.eye = right, up, cross3(right, up)

    def project(self, p):
        """The coordinates on the page, to the right and up, of the place p."""
        return dot3(p, self.right), dot3(p, self.up)

    def depth(self, p):
        """The coordinate of p towards the eye."""
        return dot3(p, self.eye)

    def offset(self, p, x, y):
        """The place that is seen at (x, y) from p, at the depth of p."""
        return add3(p, add3(scale3(x, self.right), scale3(y, self.up)))

    def is_seen(self, v):
        """False if v points so nearly at the eye that it looks like a dot."""
        return math.hypot(*self.project(v)) > 0.1 * norm3(v)

    def slant(self, v):
        """A measure of how well a direction serves for hatching: steep, and to the right rather
        than to the left.
        """
        angle = math.atan2(*reversed(self.project(v)))
        return abs(math.sin(angle)) + 0.2 * math.sin(2 * angle)

    def left_of(self, A, B):
        """The unit vector that is seen at a right angle to AB, to the left."""
        x, y = self.project(sub3(B, A))
        size = math.hypot(x, y)
        return self.offset((0, 0, 0), -y / size, x / size) if size else self.up

    def tilted(self, axis):
        """The axis, or if a circle about it is nearly seen edge-on, a direction near it about which
        a circle looks like an ellipse.
        """
        d = self.depth(axis)
        if abs(d) >= 0.3:
            return axis
        return unit3(add3(axis, scale3(math.copysign(0.3, d if abs(d) > 1e-9 else 1), self.eye)))

    def perpendiculars(self, axis):
        """Two unit vectors that form a right-handed triple with ``axis``, the first towards the
        eye.
        """
        e1 = perpendicular_towards(axis, self.eye)
        return e1, cross3(axis, e1)


def space_view(azimuth, elevation, up):
    """The view from the azimuth and elevation, in degrees, with the axis ``up`` upwards."""
    if up not in ("x", "y", "z"):
        raise FrameError(
            "up is 'x', 'y' or 'z', the axis of the ground that is vertical in the figure; "
            f"got {up!r}"
        )
    a, h = math.radians(azimuth), math.radians(elevation)
    n = "xyz".index(up)

    def turned(first, second, vertical):
        out = [0.0, 0.0, 0.0]
        out[(n + 1) % 3], out[(n + 2) % 3], out[n] = first, second, vertical
        return tuple(out)

    eye_up = turned(-math.sin(h) * math.cos(a), -math.sin(h) * math.sin(a), math.cos(h))
    return View(turned(-math.sin(a), math.cos(a), 0.0), eye_up)


def plane_view(plane):
    """The view at a right angle to a plane, "xz" for x to the right and z up."""
    if not isinstance(plane, str) or len(plane) != 2 or len(set(plane) & set("xyz")) != 2:
        raise FrameError(
            f"a plane is two axes, as in plane='xz' for x to the right and z up; got {plane!r}"
        )
    return View(*(tuple(float(axis == name) for axis in "xyz") for name in plane))


# -- geometry of triples


def norm3(v):
    """The magnitude of v, a float."""
    return math.sqrt(dot3(v, v))


def unit3(v):
    """The unit vector along v."""
    return scale3(1 / norm3(v), v)


def between(A, B, t):
    """The place at the fraction t of the way from A to B."""
    return add3(A, scale3(t, sub3(B, A)))


def mean(points):
    """The mean of many places."""
    return tuple(sum(c) / len(points) for c in zip(*points, strict=True))


def perpendicular_towards(axis, target):
    """The unit vector at right angles to ``axis`` that is nearest to ``target``."""
    v = sub3(target, scale3(dot3(axis, target), axis))
    return perpendiculars(axis)[0] if norm3(v) < 1e-6 else unit3(v)


def perpendiculars(axis):
    """Two unit vectors that form a right-handed triple with ``axis``."""
    least = min(range(3), key=lambda n: abs(axis[n]))
    e1 = perpendicular_towards(axis, tuple(float(n == least) for n in range(3)))
    return e1, cross3(axis, e1)


def on_circle(C, e1, e2, radius, angle):
    """The place on a circle about C at an angle from e1 towards e2."""
    return add3(C, add3(scale3(radius * math.cos(angle), e1), scale3(radius * math.sin(angle), e2)))


def circle(C, normal, radius, count=60, closed=False):
    """Places on a circle, right-handed about ``normal``; ``closed`` repeats the first."""
    e1, e2 = perpendiculars(normal)
    return [on_circle(C, e1, e2, radius, 2 * math.pi * n / count) for n in range(count + closed)]


def normal_of(corners):
    """The normal of a plane polygon, by Newell's sum."""
    total = (0.0, 0.0, 0.0)
    for p, q in zip(corners, corners[1:] + corners[:1], strict=True):
        total = add3(total, cross3(p, q))
    return total


def convex_hull(view, points):
    """The points on the convex hull as seen on the page, counter-clockwise.

    By Andrew's monotone chain: points sorted from left to right, from which turns to the right are
    removed, give the lower half; back, the upper half. This is the outline of a convex body.
    """
    ordered = sorted(points, key=view.project)

    def half(points):
        out = []
        for p in points:
            while (
                len(out) > 1
                and dot3(cross3(sub3(out[-1], out[-2]), sub3(p, out[-1])), view.eye) <= 0
            ):
                out.pop()
            out.append(p)
        return out[:-1]

    return half(ordered) + half(ordered[::-1])


def silhouette(view, apex, rim):
    """The two places of the rim where lines from the apex are seen to be tangent; none if the apex
    is seen inside.
    """
    outline = convex_hull(view, [apex, *rim])
    if apex not in outline:
        return ()
    n = outline.index(apex)
    return outline[n - 1], outline[(n + 1) % len(outline)]
