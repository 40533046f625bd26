"""Ladders for tests: random questions to each, over wide ranges, and what the state of each rung
must hold.

A draw is a function of a ``random.Random`` that returns a Ladder and a tolerance, such that each
rung is the right choice now and then.
"""

import math
from typing import NamedTuple

from newton_euler.applications.earth import EARTH_GM, EARTH_RATE
from newton_euler.applications.gyroscopes import GyroError, steady_precession
from newton_euler.scenes import ladder
from newton_euler.scenes.particles.orbit import EARTH_OBLATENESS
from tests.newton_euler.scenes.draws import later_chapters
from tests.newton_euler.scenes.draws.later_chapters import any_size, either


def projectile(r):
    g, speed, azimuth, elevation = (
        r.uniform(1.6, 25),
        any_size(r, 5, 3000),
        r.uniform(-3.1, 3.1),
        r.uniform(0.1, 1.5),
    )
    level = speed * math.cos(elevation)
    start = (
        0.0,
        0.0,
        r.choice((0.0, 100.0)),
        level * math.cos(azimuth),
        level * math.sin(azimuth),
        speed * math.sin(elevation),
    )
    t = any_size(r, 0.003, 1.9) * speed * math.sin(elevation) / g
    radius = any_size(r, 2e6, 7e7)
    # of what would make all weightless on the equator
    rate = math.sqrt(g / radius) * any_size(r, 0.003, 0.5)
    given = {
        "latitude": r.uniform(-1.5, 1.5),
        "rate": rate,
        "radius": radius,
        "drag": r.choice((0.0, any_size(r, 1e-9, 1e-3))),
    }
    return ladder("projectile", g=g, **given, start=start, t=t), any_size(r, 1e-4, 1e3)


def physical_pendulum(r):
    l, g = any_size(r, 0.2, 5), r.uniform(1.6, 25)
    n = math.sqrt(g / l)
    start = either(r) * any_size(r, 1e-3, 2.5), r.choice((0.0, r.uniform(-1, 1) * n))
    given = {
        "m": 1.0,
        "I": l * l * any_size(r, 1e-6, 0.5),
        "l": l,
        "g": g,
        "t": any_size(r, 1, 25) / n,
    }
    return ladder("physical pendulum", **given, start=start), any_size(r, 1e-6, 1.0)


def top(r):
    I0, mgr = any_size(r, 0.005, 0.05), any_size(r, 0.05, 2.0)
    I = I0 * r.uniform(0.3, 1.8)
    omega_z = either(r) * 2 * math.sqrt(I0 * mgr) / I * any_size(r, 0.7, 20)
    upright = r.random() < 0.2
    theta = 0.0 if upright else r.uniform(0.1, 2.5)
    try:
        rate = steady_precession(I0, I, theta, omega_z=omega_z, mgr=mgr).slow
    except GyroError:
        rate = mgr / (I * omega_z)
    nods = (
        either(r) * any_size(r, 1e-3, 1.0) if upright else r.choice((0.0, any_size(r, 1e-6, 1.0)))
    )
    given = {
        "theta": theta,
        "theta_rate": nods,
        "precession": 0.0 if upright else rate * (1 + either(r) * any_size(r, 1e-6, 1.0)),
    }
    t = 2 * math.pi * I0 / abs(I * omega_z) * any_size(r, 0.3, 8)
    return ladder(
        "top", I0=I0, I=I, mgr=mgr, omega_z=omega_z, **given, asymmetry=any_size(r, 1e-6, 0.1), t=t
    ), any_size(r, 1e-7, 0.3)


def satellite(r):
    distance = any_size(r, 6.6e6, 5e7)
    speed, azimuth, climb = (
        math.sqrt(EARTH_GM / distance),
        r.uniform(-3.1, 3.1),
        r.choice((0.0, either(r) * any_size(r, 1e-6, 0.3))),
    )
    fast, ahead = (
        speed * (1 + either(r) * any_size(r, 1e-7, 0.3)),
        azimuth + either(r) * (math.pi / 2 - climb),
    )
    start = (
        distance * math.cos(azimuth),
        distance * math.sin(azimuth),
        fast * math.cos(ahead),
        fast * math.sin(ahead),
    )
    oblateness = EARTH_OBLATENESS * any_size(r, 1e-4, 3)
    t = 2 * math.pi * distance / speed * any_size(r, 0.05, 3)
    return ladder("satellite", oblateness=oblateness, start=start, t=t), distance * any_size(
        r, 1e-8, 0.3
    )


def in_plan(r, length, n, least):
    """The amplitude of a swing, and its start x, y, dx, dy."""
    size = length * any_size(r, least, 0.6)
    turn, across = r.uniform(-3.1, 3.1), r.choice((0.0, r.uniform(-1, 1)))
    c, s = size * math.cos(turn), size * math.sin(turn)
    return size, (c, s, -n * across * s, n * across * c)


def foucault(r):
    length, g = any_size(r, 0.5, 100), r.uniform(9.78, 9.84)
    n = math.sqrt(g / length)
    size, start = in_plan(r, length, n, 1e-4)
    given = {
        "length": length,
        "g": g,
        "latitude": r.uniform(-1.5, 1.5),
        "rate": EARTH_RATE * any_size(r, 0.3, 300),
    }
    return ladder(
        "Foucault's pendulum", **given, start=start, t=any_size(r, 1, 25) / n
    ), size * any_size(r, 1e-6, 0.3)


def spherical_pendulum(r):
    length, g = any_size(r, 0.2, 5), r.uniform(1.6, 25)
    n = math.sqrt(1.5 * g / length)
    size, start = in_plan(r, length, n, 1e-3)
    given = {"length": length, "g": g, "friction": n * any_size(r, 1e-6, 0.5)}
    return ladder(
        "spherical pendulum", **given, start=start, t=any_size(r, 1, 25) / n
    ), size * any_size(r, 1e-6, 0.3)


def free_body(r):
    spin, turn = either(r) * any_size(r, 0.1, 20), r.uniform(-3.1, 3.1)
    wobble = abs(spin) * any_size(r, 1e-4, 1.0)
    given = {"I_x": 1.0, "I_y": 1 + either(r) * any_size(r, 1e-6, 0.4), "I_z": r.uniform(0.5, 1.6)}
    start = wobble * math.cos(turn), wobble * math.sin(turn), spin
    return ladder("free body", **given, start=start, t=any_size(r, 1, 60) / abs(spin)), abs(
        spin
    ) * any_size(r, 1e-8, 0.3)


DRAWS = {
    "projectile": projectile,
    "physical pendulum": physical_pendulum,
    "top": top,
    "satellite": satellite,
    "Foucault's pendulum": foucault,
    "spherical pendulum": spherical_pendulum,
    "free body": free_body,
    **later_chapters.DRAWS,
}


class State(NamedTuple):
    """What the state of a rung holds: 2 numbers for each degree of freedom; less those left out,
    which are coordinates that are not asked for, or constants of the motion (as the momenta of
    cyclic coordinates) and so parameters; and ``spare`` ones that a constraint takes back.
    """

    freedom: int
    left_out: int
    why: str
    spare: int = 0


POINT = State(3, 0, "a particle in space, whose place is asked for")
SWING = State(1, 0, "one angle")
IN_PLAN = State(2, 0, "a point on a sphere")
TURNING = State(1, 1, "one angle, at a constant rate")

FREEDOM = {
    "projectile": {
        "projectile, flat": POINT,
        "projectile, Coriolis to first order": POINT,
        "projectile, Coriolis and effective gravity": POINT,
        "projectile, flat in air": POINT,
        "projectile, full": POINT,
        "projectile, full in air": POINT,
    },
    "physical pendulum": {
        "pendulum, small swings": SWING,
        "pendulum, a particle": SWING,
        "physical pendulum": SWING,
    },
    "top": {
        "top, slow precession": TURNING,
        "top, steady precession": TURNING,
        "top, nutation and precession": State(
            3, 3, "phi is not asked for; omega_z and p_psi are constant"
        ),
        "top of unequal moments, Euler's angles": State(
            3, 0, "a body about a point; phi matters now"
        ),
        "top of unequal moments, quaternion": State(
            3, 0, "a body about a point, without a singular place", spare=1
        ),
    },
    "satellite": {
        "satellite, circle": TURNING,
        "satellite, ellipse": State(
            2, 0, "a point in a plane; exact, so that no state costs anything"
        ),
        "satellite, over an oblate Earth": State(
            2, 1, "a point in a plane; the angular momentum is constant"
        ),
    },
    "Foucault's pendulum": {
        "Foucault's pendulum, small swings, Earth at rest": IN_PLAN,
        "Foucault's pendulum, small swings": IN_PLAN,
        "Foucault's pendulum, any swing, Earth at rest": IN_PLAN,
        "Foucault's pendulum": IN_PLAN,
    },
    "spherical pendulum": {
        "bar, small swings": IN_PLAN,
        "bar, small swings with friction": IN_PLAN,
        "bar, any swing": IN_PLAN,
        "bar, any swing with friction": IN_PLAN,
    },
    "free body": {
        "wobble of a symmetric body": State(
            3, 4, "rates alone are asked for, not the attitude; w_z is constant"
        ),
        "small wobble": State(3, 4, "rates alone are asked for, not the attitude; w_z is constant"),
        "free body": State(3, 3, "rates alone are asked for, not the attitude"),
    },
    **{
        name: {rung: State(*held) for rung, held in rungs.items()}
        for name, rungs in later_chapters.FREEDOM.items()
    },
}
