"""Integrals and roots as problems need them: one formula on floats, arrays, fifty digits, dimensions
and traced, against solutions by hand and mpmath's root finder.
"""

import numpy as np
import pytest
from mpmath import mp, mpf

from newton_euler import compiled, cos, exp, integral, root, sin, sinh, sqrt, work_along
from newton_euler.algebra.scalars import pi
from newton_euler.algebra.units import unit
from newton_euler.kinematics import from_speed

zero = mp.findroot


def cone_centre(r, h):
    def slice_(z):
        return pi(r) * (r * z / h) ** 2

    return integral(lambda z: z * slice_(z), 0, h) / integral(slice_, 0, h)


def half_disk_centre(R):
    """By strips, whose length has a vertical tangent at both ends."""
    width = integral(lambda x: 2 * sqrt(R * R - x * x), 0, R)
    return integral(lambda x: R * R - x * x, 0, R) / width


def work_round_a_rectangle(a, b, c):
    legs = (
        lambda s: (a * s, 0, 0),
        lambda s: (a, b * s, 0),
        lambda s: (a * (1 - s), b, 0),
        lambda s: (0, b * (1 - s), 0),
    )
    return sum(work_along(lambda x, y, z: (c * y, -c * x, 0), leg, 0.0, 1.0).value for leg in legs)


# by name: the formula, numbers, their units and that of the result, the solution
CASES = {
    "cone": (cone_centre, (0.5, 2.0), ("m", "m"), "m", lambda r, h: 3 * h / 4),
    "half disk": (half_disk_centre, (2.0,), ("m",), "m", lambda R: 4 * R / (3 * mp.pi)),
    "area swept": (
        lambda a, k: integral(lambda t: (a * (1 + k * t)) ** 2 / 2, 0, 2 * pi(a)),
        (2.0, 0.3), ("m", "1"), "m^2",
        lambda a, k: a * a * ((1 + 2 * mp.pi * k) ** 3 - 1) / (6 * k),
    ),
    "drag": (
        lambda v0, k: from_speed(lambda v: -k * v * v, v0 / 3, v0)[1],
        (5.0, 0.3), ("m/s", "1/m"), "m",
        lambda v0, k: mp.log(3) / k,
    ),
    "work": (
        work_round_a_rectangle,
        (2.0, 3.0, 4.0), ("m", "m", "N/m"), "J",
        lambda a, b, c: -2 * a * b * c,
    ),
    "slider crank": (
        lambda r, l, a: root(lambda b: l * sin(b) - r * sin(a), -1.5, 1.5),
        (1.0, 3.0, 0.7), ("m", "m", "rad"), "rad",
        lambda r, l, a: mp.asin(r * mp.sin(a) / l),
    ),
    "flight in drag": (
        lambda v, g, k: root(lambda t: (v + g / k) * (1 - exp(-k * t)) - g * t, v / g, 3 * v / g),
        (20.0, 9.81, 0.2), ("m/s", "m/s^2", "1/s"), "s",
        lambda v, g, k: zero(lambda t: (v + g / k) * (1 - mp.exp(-k * t)) - g * t, 1.5 * v / g),
    ),
    "Kepler": (
        lambda M, e: root(lambda E: E - e * sin(E) - M, 0, 2 * pi(M)),
        (1.3, 0.4), ("rad", "1"), "rad",
        lambda M, e: zero(lambda E: E - e * mp.sin(E) - M, M),
    ),
    "catenary": (
        lambda L, s: root(lambda c: c * sinh(L / (2 * c)) - s / 2, L / 20, 20 * L),
        (2.0, 2.5), ("m", "m"), "m",
        lambda L, s: zero(lambda c: c * mp.sinh(L / (2 * c)) - s / 2, L / 2),
    ),
    "steepest release": (
        lambda h, r: root(lambda a: h * cos(a) - r * sin(a) * a, 0, pi(h) / 2),
        (2.0, 1.5), ("m", "m"), "rad",
        lambda h, r: zero(lambda a: h * mp.cos(a) - r * mp.sin(a) * a, 1),
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_solved_on_every_kind_as_proved(case):
    solve, given, units, asked, prove = CASES[case]
    with mp.workdps(50):
        precise = [mpf(repr(x)) for x in given]
        proved = prove(*precise)
        assert abs(solve(*precise) - proved) < mpf(10) ** -46 * abs(proved)
    expected = pytest.approx(float(proved), rel=1e-13)
    assert solve(*given) == expected
    assert compiled(solve)(*given) == expected
    many = [np.array([x, x]) for x in given]
    assert list(solve(*many)) == [expected] * 2
    assert list(compiled(solve)(*many)) == [expected] * 2
    assert solve(*(unit(u).dimension for u in units)) == unit(asked).dimension
