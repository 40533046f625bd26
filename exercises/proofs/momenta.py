"""The angular momentum of mass points that move in any way: no inertia matrix is needed."""

from .motions import cross, minus, plus, rate, scaled


def angular_momentum(masses, places, about=(0, 0, 0)):
    """The angular momentum of mass points about a place at rest, as a function of time: the sum of
    r x m v, the velocities found by differences. Its :func:`rate` is the moment of the forces.

    masses : a list; places : a function of time that returns as many places

    >>> from mpmath import mp
    >>> def circling(t):  # a mass of 2, at 3 m/s on a circle of radius 1
    ...     return [[mp.cos(3 * t), mp.sin(3 * t), 0]]
    >>> [mp.nstr(x, 6) for x in angular_momentum([2], circling)(0)]
    ['0.0', '0.0', '6.0']
    """

    def H(t):
        moving = zip(masses, places(t), rate(places, t), strict=True)
        return plus(*(scaled(m, cross(minus(r, about), v)) for m, r, v in moving))

    return H
