"""4/5: a bevel gear that rolls on a fixed gear and is driven by an equal one above it."""

from exercises.devices.differential import meshing_rates, rolled, section, spin_against, train
from exercises.tools import Sketch, angular_velocity, in_frame, rate, rot, terms, times
from newton_euler import Frame
from newton_euler.algebra import ZERO

AXIS = "z"  # A is the first gear, above, B the second; C is the pinion
NAMES = "OC", "C"


def gear_C(cage_rate, spin):
    ground, _, C = train(AXIS, cage_rate, spin, NAMES)
    return in_frame(ground, {"omega_C": C.angular_velocity(ground)})


def solve(g):
    return gear_C(*meshing_rates(g, AXIS, g.omega, ZERO))


def steps(g):
    OC_rate, spin = meshing_rates(g, AXIS, g.omega, ZERO)
    ground = Frame("ground")
    v_A = ground.rotate("A", AXIS, rate=g.omega).point("tooth", g.R, 0, g.r).velocity(ground)
    yield "v_A", v_A.expressed_in(ground)
    yield "omega_OC", OC_rate
    yield "omega_spin", spin
    yield from terms(solve(g)["omega_C"], "omega_C", "rad/s", "4.9")


def prove(g):
    OC, C = rolled(g, AXIS, g.omega, 0)
    omega = angular_velocity(C)
    return {
        "omega_C": omega,
        "omega_spin": omega[0],  # OC, along x, turns about z
        "omega_OC": angular_velocity(OC)[2],
        "v_A": rate(lambda t: times(rot("z", g.omega * t), [g.R, 0, g.r])),
    }


def mistakes(g):
    right = solve(g)["omega_C"]
    return {
        "spin_only": {"omega_C": right.without("OC")},
        "axis_as_fast_as_A": gear_C(g.omega, spin_against(g, AXIS, g.omega, 0, -1)),
        "axis_at_rest": gear_C(0, spin_against(g, AXIS, 0, g.omega, 1)),
        "along_contact_with_A": {"omega_C": right.reweighted(C=-1)},
    }


def draw(g, ax):
    ground, *_ = train(AXIS, g.omega, 0)
    O, top, bottom = (0, 0, 0), (0, 0, g.r + 0.5 * g.R), (0, 0, -g.r - 0.35 * g.R)
    s = Sketch(ax, ground, plane="xz")
    s.line(bottom, top, style="centre")  # AB, with the apex O on it
    s.shaft((0, 0, g.r), top)
    s.shaft((0, 0, -g.r), bottom)
    s.ground(bottom, normal=ground.k)
    s.rod(O, (0.97 * g.R, 0, 0))
    section(s, g, AXIS, pinion_sides=(1,))
    s.ball_joint(O)
    s.axes((-1.4 * g.R, 0, 0), ground, length=0.3 * g.R, labels=["x", "", "z"])
    s.turn((0, 0, g.r + 0.3 * g.R), ground.k, label=r"$\omega$")
    s.dimension((0, 0, -g.r), (g.R, 0, -g.r), label="R", offset=-0.25 * g.R)
    s.dimension((g.R, 0, 0), (g.R, 0, g.r), label="r")
    s.label(O, "O")
    s.label((-0.5 * g.R, 0, g.r), "A", offset=ground.k)
    s.label((-0.5 * g.R, 0, -g.r), "B", offset=-ground.k)
    s.label((g.R, 0, -0.4 * g.r), "C", offset=ground.i)
