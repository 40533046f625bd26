"""Frames given by their axes: unit vectors that follow a path or a coordinate system, and where
they cease to exist.

A :class:`Triad` is a :class:`~newton_euler.kinematics.frames.Frame` made from its three axes
instead of a turn about one; vectors can be expressed in it like in any other. Where a direction is
only rounding noise, :class:`SingularError` says so instead of normalising the noise.
"""

from ..algebra.jets import Moving, as_moving
from ..algebra.scalars import anywhere, epsilon, is_numeric, plain, scalar, sqrt
from ..algebra.vectors import ZERO3, FrameError, add3, dot3, scale3
from .frames import Frame


class Triad(Frame):
    """The frame with these axes, at this instant.

    axes : three triples, the components in ``parent`` of three orthonormal vectors, right-handed;
        they are not checked
    turning : where known, a function without arguments that returns angular velocity and
        acceleration in ``parent``, each three components along the axes themselves (rad/s,
        rad/s^2), or None where unknown; asking for an unknown one raises :class:`FrameError`

    >>> ground = Frame("ground")
    >>> tilted = Triad("tilted", ground, ((0.6, 0.8, 0), (-0.8, 0.6, 0), (0, 0, 1)))
    >>> ground.vector(5.0, 0, 0).components(tilted)
    (3.0, -4.0, 0)
    """

    def __init__(self, name, parent, axes, turning=None, origin=None):
        super().__init__(name, parent, origin=origin)
        self._axes = tuple(tuple(scalar(x) for x in axis) for axis in axes)
        self.axis, self.angle = "axes", _Turning(self, turning)

    def _turn(self, c, sense):
        """Between this frame and its parent: sense 1 from here up to the parent, -1 down."""
        if c is ZERO3:
            return c
        if sense < 0:
            return tuple(dot3(axis, c) for axis in self._axes)
        first, second, third = (scale3(x, axis) for x, axis in zip(c, self._axes, strict=True))
        return add3(add3(first, second), third)

    def _along_axis(self, c):
        return c


class _Turning:
    """What a :class:`Triad` has in place of an angle: its angular velocity and acceleration,
    computed when they are asked for.
    """

    def __init__(self, frame, turning):
        self.frame, self.turning = frame, turning or (lambda: (None, None))

    rate = property(lambda self: self._known(0, "angular velocity"))
    acceleration = property(lambda self: self._known(1, "angular acceleration"))

    def _known(self, n, what):
        value = self.turning()[n]
        if value is None:
            raise FrameError(
                f"the {what} of {self.frame.name} is not known: its axes are known at this "
                "instant only, without enough of their rates; "
                "express the vector in the ground before differentiating it, or give the "
                "motion with one more rate"
            )
        return value


def turning_of(axes):
    """Angular velocity and acceleration, each along the axes, of axes whose components are
    :class:`Moving`: omega_1 = e_2' . e_3, and so on.
    """
    # the second rate of the last is not needed
    moved = [tuple(Moving(x.rate, x.acceleration) for x in axis) for axis in axes]
    omega = [as_moving(dot3(moved[(n + 1) % 3], axes[(n + 2) % 3])) for n in range(3)]
    return tuple(x.value for x in omega), tuple(x.rate for x in omega)


# -- directions and rounding


def norm3(c):
    """The length of a triple."""
    return sqrt(dot3(c, c))


def numeric3(c):
    """True if the three components have values that can be compared."""
    return all(is_numeric(x) for x in c)


def below_roundoff(value, noise):
    """True if a numeric ``value`` >= 0 does not stand out of ``noise`` >= 0 (arrays: at any
    instant).
    """
    return anywhere(plain(value) <= plain(noise))


def roundoff_sensitivity(f, q):
    """How far each of the triples f(*q) moves, as lengths, while each of the numbers ``q`` moves by
    up to 41 units in its last place.

    It measures rounding inside f, and how sharply q determines f: a direction taken from a vector
    no longer than this is arbitrary.
    """
    middle = f(*q)
    totals = [0.0] * len(middle)
    for n, x in enumerate(q):
        for units in (-29, -3, 7, 41):
            others = f(*q[:n], x * (1 + units * epsilon(x)), *q[n + 1 :])
            moved = (
                norm3(tuple(a - b for a, b in zip(c, d, strict=True)))
                for c, d in zip(others, middle, strict=True)
            )
            totals = [total + length for total, length in zip(totals, moved, strict=True)]
    return totals
