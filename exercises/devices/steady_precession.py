"""A body of revolution in steady precession about the vertical through a point O of its axis (10/1
to 10/5; free of moments, 10/6): Euler's angles, the moment of the weight, and the proof.

theta is the angle from the upward vertical K to the axis k; the line of nodes is along K x k. The
proofs find the moment that mass points need in the explicit motion, without moments of inertia or
equations of a gyroscope.
"""

from typing import cast

from exercises.annotations import Answers, Number, Orientation, Points, Scalar
from exercises.tools import carried, mean, moment_needed, mp, mpf, plus, ring, root, rot, times
from newton_euler import Frame, dynamics, euler_frame


def frames(theta: Scalar, psi: Scalar = 0, name: str = "top") -> tuple[Frame, Frame]:
    """The ground with z up, and axes {i, j, k} at O that precess without spinning."""
    ground = Frame("ground")
    return ground, cast(Frame, euler_frame(ground, name, psi, theta, 0).parent)


def weight_moment(m: Scalar, g: Scalar, ground: Frame, axes: Frame, r: Scalar) -> Scalar:
    """The moment of the weight of m at r k, about O and the line of nodes (10.30)."""
    G = axes.point("G", 0, 0, r)
    return (G - axes.origin).cross(dynamics.weight(m, ground.k, g)).expressed_in(axes).x


# -- proof


def orientation(theta: Number, psi_dot: Number, phi_dot: Number) -> Orientation:
    """Orientation as a function of time; at t = 0 the line of nodes is x."""
    tilted = rot("x", theta)
    return lambda t: times(rot("z", psi_dot * t), tilted, rot("z", phi_dot * t))


def needed(m: Number, points: Points, theta: Number, psi_dot: Number, phi_dot: Number) -> Number:
    """The moment about O, along the line of nodes, that mass points need in this precession."""
    return moment_needed(m, carried(points, orientation(theta, psi_dot, phi_dot)))[0]


def of_weights(m: Number, g: Number, points: Points, theta: Number) -> Number:
    """The moment of their weights, about the same line."""
    return m * mean(lambda r: -g * times(rot("x", theta), r)[1], points)


def two_rings(k_z: Number, k_x: Number, c: Number = 0) -> Points:
    """Mass points with these radii of gyration about O and the centre of mass at distance c."""
    h = mp.sqrt(k_x**2 - c**2 - k_z**2 / 2)
    rim = ring(k_z, order=2)
    return [(u / 2, plus(r, [0, 0, c + side * h])) for side in (1, -1) for u, r in rim]


def needed_by_rates(m: Number, points: Points, theta: Number) -> tuple[Number, Number]:
    """Factors of psi_dot^2 and psi_dot phi_dot in the needed moment, by two motions."""
    ahead, back = (needed(m, points, theta, psi_dot, 1) for psi_dot in (1, -1))
    return (ahead + back) / 2, (ahead - back) / 2


def both_rates(
    m: Number, points: Points, theta: Number, phi_dot: Number, moment: Number
) -> tuple[Number, Number]:
    """The slow and the fast rate at which mass points need this moment, for a small positive moment
    and an axial moment of inertia that is the smaller one. Time is in units of 1 rad of spin: the
    rate is x, and the spin 1.
    """
    square, product = needed_by_rates(m, points, theta)
    surplus = lambda x: square * x * x + product * x - moment / phi_dot**2
    middle = -product / (2 * square)
    high = middle
    while surplus(high / 2) > 0:  # the slow rate may be smaller by orders of magnitude
        high /= 2
    return phi_dot * root(surplus, 0, high), phi_dot * root(surplus, middle, 2 * middle)


def leading(m: Number, points: Points, theta: Number, phi_dot: Number, moment: Number) -> Answers:
    """Leading terms of both rates and the correction of the slow one, from much larger spins."""
    faster, fastest = mpf(10) ** 10, mpf(10) ** 20
    slow, fast = both_rates(m, points, theta, fastest * phi_dot, moment)
    psi_slow = fastest * slow
    less = faster * both_rates(m, points, theta, faster * phi_dot, moment)[0]
    eps = faster**2 * (less / psi_slow - 1)
    return {"psi_slow": psi_slow, "psi_fast": fast / fastest, "eps_slow": eps}
