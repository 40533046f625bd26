"""A sphere, or another round body, that rolls down an incline without slipping (11.15). One that slides first: :mod:`.sliding_sphere`.

``k`` is the moment of inertia about the centre over m R^2: 2/5 for a solid sphere (the default), 2/3 for a shell, 1/2 for a cylinder.
"""

from ..energy import speed_after
from ..models import Model
from ..scalars import plain, scalar, sin, tan, whole
from ..work import summed


def rolling_energy(m, R, speed, pivoting=0, k=None):
    """T of the rolling body with terms ``translation``, ``rolling`` and ``pivoting`` (11.45): 7/10 m v^2 for a sphere that does not pivot.

    pivoting : the component of omega along the normal of the plane, rad/s, which the book takes to be zero. Rolling leaves it free, and it stays
        what it is: for a sphere it only adds a constant.

    >>> round(rolling_energy(2.0, 0.5, 3.0).value, 9)
    12.6
    """
    k, translation = _ratio(m, k), scalar(m) * speed * speed / 2
    spun = k * (scalar(m) * R * R) * (scalar(pivoting) * pivoting) / 2
    return summed({"translation": translation, "rolling": k * translation, "pivoting": spun}, "kinetic energy", "11.45")


def rolling_speed(drop, g, v0=0, k=None):
    """The speed of the centre after it has come down by ``drop``: sqrt(v0^2 + 2 g h/(1 + k)), from rest sqrt(10 g h/7) for a sphere (11.49).

    The contact is at rest, so its force does no work; without rolling it would be sqrt(2 g h), on any incline.

    >>> round(rolling_speed(0.7, 10.0), 9)
    3.16227766
    """
    return speed_after(v0, scalar(g) * drop, 1 + _ratio(g, k))


def rolling_down(slope, g, k=None):
    """The motion straight down a plane of inclination ``slope``: a Model with the states x (down the plane) and v, and the energy over mass kept.

    It rolls if the friction can be :func:`friction_needed` times the normal force; as the slope nears the vertical, that has no bound.

    >>> rolling_down(0.5235987755982988, 9.8).derivative((0.0, 0.0))[1]
    3.5
    """
    return Model(
        "sphere on an incline", {"slope": slope, "g": g, "k": _ratio(g, k)}, ("x", "v"),
        lambda s, p, t: (s.v, _acceleration(p)),
        invariants={"energy over mass": lambda s, p, t: (1 + p.k) * s.v * s.v / 2 - p.g * sin(p.slope) * s.x},
        exact=lambda s, p, t: (s.x + s.v * t + _acceleration(p) * t * t / 2, s.v + _acceleration(p) * t),
    )  # fmt: skip


def friction_needed(slope, k=None):
    """Friction over normal force of the rolling body: k tan(slope)/(1 + k); with less, it slips.

    >>> round(friction_needed(0.7853981633974483), 6)
    0.285714
    """
    k = _ratio(slope, k)
    return plain(k * tan(slope) / (1 + k))


def _acceleration(p):
    return p.g * sin(p.slope) / (1 + p.k)


def _ratio(like, k):
    return whole(2, like) / 5 if k is None else k
