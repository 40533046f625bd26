"""11/21: the kinetic energy of a disk on an inclined shaft, rolling in a circle."""

import math

from exercises.devices.disk_on_shaft import contact, energy_of_disk, rolling, spinning, unrolled
from exercises.tools import Sketch, angular_velocity, mp, rot, size, times
from newton_euler import Body, atan, kinetic_energy, solve_rates
from newton_euler.bodies import disk


def shaft(g):
    """The disk on its shaft; the triangle D, C, P has its right angle at C."""
    return spinning(g.n, 0 * g.n, g.b, atan(g.a / g.b))


def rate(g, d):
    """The rate of the disk about the line from the contact to D, by the velocity of C."""
    unlike = lambda rate: (rate * -d.ground.i - g.n * d.ground.k).cross(d.C.position(d.ground)).y
    return solve_rates(unlike, 1)[0]


def turning(g, d):
    """The angular velocity of the disk."""
    return (rate(g, d) * -d.ground.i).expressed_in(d.shaft)


def about_D(body, d):
    """The inertia of the body, along the shaft and across."""
    return body.about(d.shaft.point("D", 0, 0, 0), d.shaft)


def inertia(g, d):
    return about_D(disk(g.a, d.body, "x", mass=g.M), d)


def energy(I, omega):
    return omega.dot(I.times(omega)) / 2


def solve(g):
    d = shaft(g)
    return {"T": energy(inertia(g, d), turning(g, d))}


def steps(g):
    d = shaft(g)
    omega, I = turning(g, d), inertia(g, d)
    moments = {"I_a": I.moment("x"), "I_t": I.moment("y")}
    return {"omega": rate(g, d), "omega_a": -omega.x, "omega_t": omega.z, **moments}


def prove(g):
    """By the rim rolling along the circle of contact, of radius DP."""
    up = mp.acos(g.b / mp.hypot(g.a, g.b))
    spin = unrolled(g.n, g.a, g.b * mp.cos(up) + g.a * mp.sin(up))
    omega = angular_velocity(lambda t: times(rot("z", g.n * t), rot("y", -up), rot("x", spin * t)))
    along, _, across = times(rot("y", up), omega)
    T = energy_of_disk(g.M, g.a, g.n, spin, g.b, up)
    return {"T": T, "omega": size(omega), "omega_a": -along, "omega_t": across}


def mistakes(g):
    d = shaft(g)
    body = disk(g.a, d.body, "x", mass=g.M)
    axial = body.inertia.moment("x")
    alike = Body("disk", g.M, d.body, (axial, axial, axial))
    level = rolling(g.n, g.a, g.b)
    upright = disk(g.a, level.body, "x", mass=g.M)
    return {
        "level_shaft": {"T": kinetic_energy(upright, level.ground).value},
        "precession_alone": {"T": kinetic_energy(body, d.ground).value},
        "axial_for_diameter": {"T": energy(about_D(alike, d), turning(g, d))},
        "no_translation": {"T": energy(body.inertia.expressed_in(d.shaft), turning(g, d))},
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
    around = [(reach * math.cos(t / 20), reach * math.sin(t / 20), 0) for t in range(-14, 17)]
    s.path(around, style="dashed")
    s.turn((0, 0, 0.65), d.ground.k, label="n")
    s.dimension(D, C, label="b", offset=0.25)
    s.dimension(C, P, label="a", offset=0)
    s.label(D, "D", offset=(-12, -10))
    s.dot(C, "C", offset=(10, 8))
