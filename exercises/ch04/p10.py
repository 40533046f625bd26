"""4/10: the bevel-gear differential of a car."""

from itertools import pairwise

from exercises.devices.differential import meshing_rates, rolled, section, spin_against, train
from exercises.tools import Sketch, angular_velocity, minus, times, transposed

AXIS = "x"  # the gear of BB is the first, that of CC the second
follows = {"omega_A": lambda g, Omega: spin_against(g, AXIS, Omega, g.omega_1, 1)}


def solve(g):
    Omega, omega_A = meshing_rates(g, AXIS, g.omega_1, g.omega_2)
    return {"Omega": Omega, "omega_A": omega_A}


def steps(g):
    ground, *_ = train(AXIS, 0, 0)
    rates = ground.rotate("1", AXIS, rate=g.omega_1), ground.rotate("2", AXIS, rate=g.omega_2)
    places = zip(rates, (g.r, -g.r), strict=True)
    v_1, v_2 = (gear.point("tooth", x, g.R, 0).velocity(ground).z for gear, x in places)
    return {"v_1": v_1, "v_2": v_2}


def prove(g):
    cage, pinion = rolled(g, AXIS, g.omega_1, g.omega_2)
    in_cage = minus(angular_velocity(pinion), angular_velocity(cage))
    omega_A = times(transposed(cage(0)), in_cage)[1]
    return {"Omega": angular_velocity(cage)[0], "omega_A": omega_A}


def mistakes(g):
    right = solve(g)
    return {
        "no_half": {"Omega": 2 * right["Omega"]},
        "radii_exchanged": {"omega_A": solve(g.but(R=g.r, r=g.R))["omega_A"]},
        "omega_A_reversed": {"omega_A": -right["omega_A"]},
        "cage_at_rest": {"omega_A": spin_against(g, AXIS, 0, g.omega_1, 1)},
        "CC_the_other_way": solve(g.but(omega_2=-g.omega_2)),
    }


def draw(g, ax):
    ground, *_ = train(AXIS, 0, 0)
    end, out, side = g.r + 0.9 * g.R, 1.4 * g.R, -g.r - 0.4 * g.R
    s = Sketch(ax, ground, plane="xy")
    for sign in (1, -1):
        s.shaft((sign * g.r, 0, 0), (sign * end, 0, 0))
        cage = (0, 0.8 * g.R), (0, out), (side, out), (side, 0.05 * g.R)
        for a, b in pairwise([(x, sign * y, 0) for x, y in cage]):
            s.rod(a, b)
    s.hinge((side, 0, 0), axis=ground.i)  # the cage turns on CC
    section(s, g, AXIS, pinion_sides=(1, -1))
    s.axes((0, 0, 0), ground, length=0.5 * g.r, labels=["x", "y", ""])
    s.turn((g.r + 0.6 * g.R, 0, 0), ground.i, label=r"$\omega_1$")
    s.turn((-g.r - 0.7 * g.R, 0, 0), ground.i, label=r"$\omega_2$")
    s.turn((side, 0, 0), ground.i, label=r"$\Omega$", radius=0.4 * g.R)
    s.turn((0, 1.2 * g.R, 0), ground.j, label=r"$\omega_A$")
    s.dimension((g.r, 0, 0), (g.r, -g.R, 0), label="R", offset=0.3 * g.R)
    s.dimension((0, -g.R, 0), (g.r, -g.R, 0), label="r", offset=-0.2 * g.R)
    for name, x in zip("BBCC", (g.r + 0.2 * g.R, end, -end, -g.r - 0.2 * g.R), strict=True):
        s.label((x, 0, 0), name, offset=(0, 12))
