"""11/21: the kinetic energy of a disk on a slanting shaft that rolls in a circle."""

import math

from mpmath import mp

from exercises.devices.disk_on_shaft import (
    contact,
    energy_of_disk,
    rolling,
    spinning,
    unrolled,
)
from exercises.proofs import angular_velocity, rot, size, times
from exercises.steps import Step
from newton_euler import Body, atan2, kinetic_energy, solve_rates
from newton_euler.bodies import disk
from newton_euler.drawing import Sketch
from newton_euler.dynamics import kinetic_energy_about


def rise(g):
    """The angle of the shaft above the plane: in the triangle D, C, P the right angle is at C."""
    return atan2(g.a, g.b)


def rolls(g):
    """The joint D and the point of contact are at rest, and so is the line through both: the disk
    turns about it, and its angular velocity is level.
    """

    def upward(spin):
        d = spinning(g.n, spin, g.b, rise(g))
        return g.n + d.body.angular_velocity(d.shaft).expressed_in(d.ground).z

    (spin,) = solve_rates(upward, 1)
    return spinning(g.n, spin, g.b, rise(g))


def joint(d):
    return d.shaft.point("D", 0, 0, 0)


def energy(g, d):
    """About D, which is at rest."""
    body = disk(g.a, d.body, "x", mass=g.M)
    return kinetic_energy_about(body, joint(d), d.ground).value


def solve(g):
    return {"T": energy(g, rolls(g))}


def steps(g):
    d = rolls(g)
    body = disk(g.a, d.body, "x", mass=g.M)
    about_D = body.about(joint(d))
    omega = d.body.angular_velocity(d.ground).expressed_in(d.shaft)
    yield Step("beta", rise(g), "rad", "angle of the shaft above the plane, tan(beta) = a/b", "4.4")
    yield Step("omega_s", d.body.angular_velocity(d.shaft).norm(), "rad/s",
               "rate of the disk relative to the vertical plane of the shaft, so that its "
               "angular velocity is level", "4.9",
               "4.22")  # fmt: skip
    yield Step("omega", omega.norm(), "rad/s", "angular speed of the disk, about the level line "
               "from D to the point of contact, both of which are at rest", "4.4",
               "4.11")  # fmt: skip
    yield Step("I_a", about_D.moment("x"), "kg*m^2", "moment of inertia about the shaft", "7.4",
               "7.10")  # fmt: skip
    yield Step("I_t", about_D.moment("y"), "kg*m^2", "moment of inertia about an axis through D "
               "at right angles to the shaft", "7.10", "7.26")  # fmt: skip


def prove(g):
    """The rim unrolls along the circle of the points of contact, whose radius is DP."""
    up = mp.acos(g.b / mp.hypot(g.a, g.b))
    spin = unrolled(g.n, g.a, g.b * mp.cos(up) + g.a * mp.sin(up))
    turning = angular_velocity(
        lambda t: times(rot("z", g.n * t), rot("y", -up), rot("x", spin * t))
    )
    return {
        "T": energy_of_disk(g.M, g.a, g.n, spin, g.b, up),
        "omega_s": abs(spin),
        "omega": size(turning),
    }


def mistakes(g):
    d = rolls(g)
    body = disk(g.a, d.body, "x", mass=g.M)
    axial = body.inertia.moment("x")
    alike = kinetic_energy(Body("disk", g.M, d.body, (axial, axial, axial)), d.ground)
    return {
        "level_shaft": {"T": energy(g, rolling(g.n, g.a, g.b))},
        "precession_alone": {"T": energy(g, spinning(g.n, 0 * g.n, g.b, rise(g)))},
        "axial_for_diameter": {"T": alike.value},
        "no_translation": {"T": kinetic_energy(body, d.ground).reweighted(translation=0)},
    }


def draw(g, ax):
    a, b = 0.6, 1.3
    d = spinning(1.0, 1.0, b, math.atan2(a, b))
    s = Sketch(ax, d.ground, azimuth=-60, elevation=20)
    D, C, P = d.ground.point("D", 0, 0, 0), d.C, contact(d, a)
    s.axes(D, d.ground, length=0.9)
    s.rod(D, C)
    s.disk(C, d.shaft.i, a)
    s.ball_joint(D)
    s.line(D, P)
    reach = math.hypot(a, b)
    s.path(
        [(reach * math.cos(t / 20), reach * math.sin(t / 20), 0) for t in range(-14, 17)],
        style="dashed",
    )
    s.dot(C)
    s.turn((0, 0, 0.65), d.ground.k, label="n")
    s.dimension(D, C, label="b", offset=0.25)
    s.dimension(C, P, label="a", offset=0)
    s.label(D, "D", offset=(-12, -10))
    s.label(C, "C", offset=(10, 8))
