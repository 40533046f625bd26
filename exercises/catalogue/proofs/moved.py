"""Energy and angular momentum of a body of mass points in an explicit motion, and the force and
moment that the motion needs.

A motion is a function of time that returns a list of pairs (share of the mass, place), as in
``mass_points``, with places in inertial axes. Moments of inertia, centre of mass and angular
velocity are not used.
"""

from collections.abc import Callable

from mpmath import mp, mpf

from .digits import DIGITS, Motion, Number, Orientation, Place, Points, Triple, weighted
from .motions import rate, second_rate
from .roots import vanishing
from .vectors import cross, minus, times


def carried(points: Points, orientation: Orientation) -> Motion:
    """The motion of mass points, given along the axes of a body that turns about the origin."""

    def motion(t):
        R = orientation(t)
        return [(share, times(R, place)) for share, place in points]

    return motion


def kinetic_energy(m: Number, motion: Motion, t: Number = 0) -> Number:
    """The sum of dm v^2/2 at the time t.

    >>> from exercises.catalogue.proofs import rot
    >>> turning = carried([(mpf(1), [mpf(2), 0, 0])], lambda t: rot("z", 3 * t))
    >>> print(mp.nstr(kinetic_energy(5, turning), 10))  # 5*(3*2)^2/2
    90.0
    """
    with mp.workdps(DIGITS):
        speeds = rate(lambda t: _places(motion(t)), t)
        return m * weighted(_shares(motion), [sum(x * x for x in v) / 2 for v in speeds])


def angular_momentum(m: Number, motion: Motion, about: Place = (0, 0, 0), t: Number = 0) -> Triple:
    """The sum of d x dm v, d from the place ``about``, which is at rest.

    >>> def circling(t):  # at 3 m/s on a circle of radius 1
    ...     return [(mpf(1), [mp.cos(3 * t), mp.sin(3 * t), 0])]
    >>> print([mp.nstr(x, 10) for x in angular_momentum(2, circling)])
    ['0.0', '0.0', '6.0']
    """
    with mp.workdps(DIGITS):
        t = mpf(t)
        velocities = rate(lambda t: _places(motion(t)), t)
        pairs = zip(_places(motion(t)), velocities, strict=True)
        moments = [cross(minus(place, about), v) for place, v in pairs]
        return [m * x for x in weighted(_shares(motion), moments)]


def force_needed(m: Number, motion: Motion, t: Number = 0) -> Triple:
    """The sum of dm a: the resultant of all external forces, gravity included."""
    with mp.workdps(DIGITS):
        shares = _shares(motion)
        a = second_rate(lambda t: weighted(shares, _places(motion(t))), t)
        return [m * x for x in a]


def moment_needed(m: Number, motion: Motion, about: Place = (0, 0, 0), t: Number = 0) -> Triple:
    """The sum of d x dm a, d from the place ``about``: the moment of all external forces there."""
    with mp.workdps(DIGITS):
        accelerations = second_rate(lambda t: _places(motion(t)), t)
        pairs = zip(_places(motion(mpf(t))), accelerations, strict=True)
        moments = [cross(minus(place, about), a) for place, a in pairs]
        return [m * x for x in weighted(_shares(motion), moments)]


def let_go(energy: Callable[[Callable, Number], Number], size: Number = 1) -> Number:
    """The second rate a of a coordinate q when a system is released from rest: with q = a t^2/2 its
    energy stays constant to leading order.

    energy : the conserved energy of the system, as a function of a path q(t) and a time
    size : any trial value of a; the energy gained with it and with its double gives a, since the
        gain is a multiple of a^2 (kinetic) plus a multiple of a

    >>> def dropped(q, t):  # 4 kg in free fall, q downward, g = 10
    ...     return 4 * rate(q, t) ** 2 / 2 - 4 * 10 * q(t)
    >>> print(mp.nstr(let_go(dropped), 10))
    10.0
    """
    with mp.workdps(DIGITS):

        def gain(a):
            return second_rate(lambda t: energy(lambda s: a * s * s / 2, t)) / a

        return vanishing(gain, mpf(size), 2 * mpf(size))


def _shares(motion):
    return [share for share, _ in motion(mpf(0))]


def _places(points):
    return [place for _, place in points]
