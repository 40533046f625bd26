"""Motions that end in a singular place, or pass close to one.

Unstable equilibria and separatrices.
"""

import math

from newton_euler import Model, cos, sin, sqrt, tan
from newton_euler.motion import second_order
from tests.honesty import closed_forms
from tests.honesty.cases import Case, decades, either, family


def _power(rng):
    a, x = decades(rng, 1e-2, 1e2), decades(rng, 1e-2, 1e2)
    model = Model("x' = a x^2", {"a": a}, ("x",), lambda s, p, t: (p.a * s.x * s.x,))
    return model, x, 1 / (a * x)


@family("singular", "no answer")
def blow_up_on_the_way(rng):
    """x' = a x^2 grows beyond all bounds before the end."""
    model, x, end = _power(rng)
    return Case(model, end * rng.choice((1.001, 1.3, 2.0, 10.0)), (x,), singular_at=end)


@family("near-singular")
def blow_up_later(rng):
    """The same, until shortly before that."""
    model, x, end = _power(rng)
    return Case(
        model,
        end * (1 - decades(rng, 1e-6, 0.3)),
        (x,),
        exact=lambda mp, s, p, t: (s.x / (1 - p.a * s.x * t),),
    )


@family("near-singular")
def tangent(rng):
    """x' = 1 + x^2, to one side of its pole."""
    w = decades(rng, 1e-2, 1e2)
    model = Model("tangent", {"w": w}, ("x",), lambda s, p, t: (p.w * (1 + s.x * s.x),))
    end = (math.pi / 2 - math.atan(x := rng.uniform(-3.0, 1.0))) / w
    return Case(
        model,
        end * (1 - decades(rng, 1e-5, 0.3)),
        (x,),
        exact=lambda mp, s, p, t: (mp.tan(mp.atan(s.x) + p.w * t),),
    )


@family("singular", "no answer")
def fall_into_the_centre(rng):
    """Straight into a centre of attraction, and beyond."""
    r = decades(rng, 1e-2, 1e2)
    model = second_order(
        "fall into the centre", {"GM": 1.0}, ("r",), lambda s, p, t: (-p.GM / (s.r * s.r),)
    )
    return Case(
        model,
        (end := math.pi / 2 * math.sqrt(r**3 / 2)) * rng.choice((1.0001, 1.2, 3.0)),
        (r, 0.0),
        singular_at=end,
    )


@family("near-singular")
def fall_towards_the_centre(rng):
    """The same, until shortly before."""
    r = decades(rng, 1e-2, 1e2)
    model = second_order(
        "fall towards the centre", {"GM": 1.0}, ("r",), lambda s, p, t: (-p.GM / (s.r * s.r),)
    )
    return Case(model, math.pi / 2 * math.sqrt(r**3 / 2) * (1 - decades(rng, 1e-4, 0.3)), (r, 0.0))


@family("near-singular")
def past_the_pole(rng):
    """A spherical pendulum in angles, which passes close to the lowest place, where its azimuth
    races.
    """
    near = decades(rng, 1e-3, 0.3)

    def rates(s, p, t):
        k, c = sin(s.theta), cos(s.theta)
        return s.w, p.h / (k * k), p.h * p.h * c / (k * k * k) - p.g * k

    model = Model(
        "spherical pendulum in angles",
        {"h": near * rng.uniform(0.5, 1.5), "g": rng.uniform(1.0, 10.0)},
        ("theta", "phi", "w"),
        rates,
    )
    return Case(model, rng.uniform(1.0, 5.0), (rng.uniform(0.7, 1.5), 0.0, 0.0))


@family("near-singular")
def close_approach(rng):
    """A comet on an ellipse of eccentricity 0.9 to 0.9999, past its sun."""
    e = 1 - decades(rng, 1e-4, 0.1)

    def accelerations(s, p, t):
        r2 = s.x * s.x + s.y * s.y
        return -p.GM * s.x / (r2 * sqrt(r2)), -p.GM * s.y / (r2 * sqrt(r2))

    def exact(mp, s, p, t):
        return closed_forms.kepler(mp, p.GM, (s.x, s.y), (s.dx, s.dy), t)

    gm, a = decades(rng, 0.1, 10.0), decades(rng, 0.1, 10.0)
    model = second_order("comet", {"GM": gm}, ("x", "y"), accelerations)
    start = a * (1 + e), 0.0, 0.0, math.sqrt(gm / a * (1 - e) / (1 + e))
    return Case(
        model, 2 * math.pi * math.sqrt(a**3 / gm) * rng.uniform(0.3, 2.4), start, exact=exact
    )


@family("near-singular", "separatrix")
def upright_top(rng):
    """The nutation of a top that starts next to the upright position, just too slow to sleep, or
    just fast enough.
    """
    parameters = {"w": 2.0 * rng.choice((0.9, 0.99, 1.01, 1.1)), "g": 1.0, "one": 1.0}

    # equal angular momenta about the vertical and the axis: theta = 0 is no singular place
    def rates(s, p, t):
        k = tan(s.theta / 2)
        return s.rate, p.g * sin(s.theta) - p.w * p.w / 4 * k * (p.one + k * k)

    model = Model("top beside the upright", parameters, ("theta", "rate"), rates)
    return Case(model, rng.uniform(5.0, 30.0), (decades(rng, 1e-6, 1e-2), 0.0))


@family("near-singular", "separatrix")
def pendulum_beside_the_upright(rng):
    """It starts next to its highest place, or comes there with hardly any speed left."""
    model = Model(
        "pendulum", {"k": 1.0}, ("theta", "omega"), lambda s, p, t: (s.omega, -p.k * sin(s.theta))
    )
    near = decades(rng, 1e-7, 1e-2)

    def exact(mp, s, p, t):
        return closed_forms.pendulum(mp, p.k, s.theta, s.omega, t)

    start = (
        (math.pi - near, 0.0) if rng.random() < 0.5 else (0.0, 2.0 * (1 + either(rng, near * near)))
    )
    return Case(model, rng.uniform(0.5, 4.0) * math.log(8 / near), start, exact=exact)


@family("near-singular", "separatrix")
def double_well(rng):
    """A potential with two valleys, with nearly the energy of the pass between them."""
    model = second_order(
        "double well", {"a": 1.0}, ("x",), lambda s, p, t: (p.a * s.x - s.x * s.x * s.x,)
    )
    near = either(rng, decades(rng, 1e-8, 1e-2))
    return Case(model, rng.uniform(5.0, 30.0), (1.0, math.sqrt(0.5 + near)))


@family("near-singular", "equilibrium")
def steady_precession(rng):
    """A top in Euler angles that precesses steadily.

    The rate of its nutation is zero all the time.
    """
    theta, I0, Iz, precession = (
        rng.uniform(0.3, 1.2),
        1.0,
        rng.uniform(0.5, 1.8),
        decades(rng, 0.1, 10.0),
    )
    spin = rng.uniform(2.0, 30.0)
    mgr = precession * (
        Iz * (spin + precession * math.cos(theta)) - I0 * precession * math.cos(theta)
    )
    parameters = {"I0": I0, "I": Iz, "mgr": mgr}

    def rates(s, p, t):
        k, c = sin(s.theta), cos(s.theta)
        along = p.I * (s.spin + s.psi_rate * c)
        nutation = (p.mgr + s.psi_rate * (p.I0 * s.psi_rate * c - along)) * k / p.I0
        turning = s.theta_rate * (along - 2 * p.I0 * s.psi_rate * c) / (p.I0 * k)
        return (
            s.theta_rate,
            s.psi_rate,
            nutation,
            turning,
            -turning * c + s.psi_rate * s.theta_rate * k,
        )

    model = Model(
        "top in Euler angles", parameters, ("theta", "psi", "theta_rate", "psi_rate", "spin"), rates
    )
    return Case(model, rng.uniform(1.0, 10.0), (theta, 0.0, 0.0, precession, spin))


@family("near-singular", "separatrix")
def intermediate_axis(rng):
    """A free body that spins nearly about its middle axis, and turns over again and again."""

    def rates(s, p, t):
        return (
            (p.B - p.C) / p.A * s.y * s.z,
            (p.C - p.A) / p.B * s.z * s.x,
            (p.A - p.B) / p.C * s.x * s.y,
        )

    def exact(mp, s, p, t):
        return closed_forms.free_body(mp, (p.A, p.B, p.C), (s.x, s.y, s.z), t)

    model = Model(
        "free body", {"A": 1.0, "B": rng.uniform(1.3, 1.7), "C": 2.0}, ("x", "y", "z"), rates
    )
    tilt = decades(rng, 1e-6, 1e-1)
    return Case(
        model, rng.uniform(10.0, 60.0), (tilt, 1.0, tilt * rng.uniform(0.2, 3.0)), exact=exact
    )
