"""3/7: constant speed on a helix, in rectangular components."""

from exercises.devices.helix import figure, helix, unrolled
from exercises.tools import rate, second_rate
from newton_euler import Frame, moving
from newton_euler.kinematics import at_speed

GROUND = Frame("ground")


def motion(g, theta):
    P = GROUND.point("P", *helix(g.b, g.p)(theta))
    return {"v": P.velocity(GROUND), "a": P.acceleration(GROUND)}


def angle(g):
    """theta with its rates, constant along the helix."""
    q = at_speed(helix(g.b, g.p), 0 * g.one, g.nu)
    return moving(g.theta, rate=q.rate, acceleration=q.acceleration)


def solve(g):
    return motion(g, angle(g))


def steps(g):
    return {"theta_dot": angle(g).rate}


def prove(g):
    place = unrolled(g.b, g.p, g.nu, g.theta)
    return {"v": rate(place), "a": second_rate(place)}


def mistakes(g):
    return {
        "axial_part_forgotten": motion(g, moving(g.theta, rate=g.nu / g.b)),
        "no_acceleration": {"a": 0 * solve(g)["a"]},
        "by_the_angle": motion(g, moving(g.theta, rate=g.one)),
    }


def draw(g, ax):
    s, O, Q, P = figure(ax, GROUND, g.b, g.p, 1.1, "b", turns=1.1)
    s.line(O, Q)
    s.line(Q, P)
    s.arc(O, (g.b, 0, 0), Q, label=r"$\theta$")
    s.dimension(Q, P, label=r"$p\theta$")
