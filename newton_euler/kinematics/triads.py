"""Frames given by their axes, and whether a direction is determined, or only round-off."""

from collections.abc import Callable, Sequence
from typing import Any

from ..algebra.errors import checked
from ..algebra.jets import Moving, as_moving
from ..algebra.names import guided
from ..algebra.pickles import Computed
from ..algebra.scalars import Scalar, anywhere, clipped, epsilon, hypot, scalar, to_plain
from ..algebra.vectors import ZERO3, FrameError, add3, dot3, scale3, sub3
from .frames import Frame


class Triad(Frame):
    """The frame with given axes, at this instant.

    axes : three triples, components in ``parent`` of orthonormal vectors, right-handed, not checked
    turning : function without arguments that returns angular velocity and acceleration in
        ``parent``, each three components along the axes (rad/s, rad/s^2), or None where unknown

    >>> ground = Frame("ground")
    >>> tilted = Triad("tilted", ground, ((0.6, 0.8, 0), (-0.8, 0.6, 0), (0, 0, 1)))
    >>> ground.vector(5.0, 0, 0).components(tilted)
    (3.0, -4.0, 0)
    """

    @checked
    def __init__(
        self,
        name: str,
        parent: Frame,
        axes: Sequence[Sequence[Scalar]],
        turning: Callable | None = None,
    ):
        super().__init__(name, parent)
        self._axes = tuple(tuple(map(scalar, axis)) for axis in axes)
        if [len(axis) for axis in self._axes] != [3, 3, 3]:
            raise FrameError(f"the axes of {name} are three triples; got {clipped(axes)}")
        self.axis, self.angle = "axes", _Turning(self, turning)

    def _turn(self, c, sense):
        """Components in the parent from those here (sense 1), or back (sense -1)."""
        if c is ZERO3:
            return c
        if sense < 0:
            return tuple(dot3(axis, c) for axis in self._axes)
        first, second, third = (scale3(x, axis) for x, axis in zip(c, self._axes, strict=True))
        return add3(add3(first, second), third)

    def _along_axis(self, c):
        return c


class _Turning:
    """Angular velocity and acceleration of a :class:`Triad`; computed on demand."""

    def __init__(self, frame, turning):
        self.frame, self.turning = frame, turning or (lambda: (None, None))

    def __getstate__(self):
        return {"frame": self.frame, "turning": Computed(self.turning)}

    rate = property(lambda self: self._known(0, "angular velocity"))
    acceleration = property(lambda self: self._known(1, "angular acceleration"))

    @guided
    def _known(self, n, what):
        if (value := self.turning()[n]) is None:
            raise FrameError(
                f"the {what} of {self.frame.name} is not known: its axes are known at this "
                "instant only, without enough of their rates; express the vector in the ground "
                "before differentiating it, or give the motion with one more rate"
            )
        return value


def turning_of(axes: Sequence[Sequence[Any]]) -> tuple[tuple, tuple]:
    """Angular velocity and acceleration, along moving axes: omega_1 = e_2' . e_3, and so on."""
    moved = [tuple(Moving(x.rate, x.acceleration) for x in axis) for axis in axes]
    omega = [as_moving(dot3(moved[(n + 1) % 3], axes[(n + 2) % 3])) for n in range(3)]
    return tuple(x.value for x in omega), tuple(x.rate for x in omega)


def below_roundoff(value: Scalar, noise: Scalar) -> bool:
    """Whether ``value`` >= 0 is at most ``noise`` >= 0, its round-off (arrays: at any instant)."""
    return anywhere(to_plain(value) <= to_plain(noise))


@guided
def roundoff_sensitivity(f: Callable, q: Sequence[Scalar]) -> list:
    """The changes of the triples f(*q), as lengths, when each of the numbers ``q`` changes by up to
    41 units in its last place: the direction of a shorter vector is arbitrary.
    """
    middle = f(*q)
    totals = [0.0] * len(middle)
    for n, x in enumerate(q):
        # small and large changes, of both signs, by odd numbers: what one hides another shows
        for units in (-29, -3, 7, 41):
            others = f(*q[:n], x * (1 + units * epsilon(x)), *q[n + 1 :])
            for k, (c, d) in enumerate(zip(others, middle, strict=True)):
                totals[k] = totals[k] + hypot(*sub3(c, d))
    return totals
