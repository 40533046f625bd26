"""5/28: two particles on a string through the tip of a cone. Angle and length are only drawn."""

from exercises.tools import freedom, mp, mpf, on_ground
from newton_euler import cos, sin, sqrt
from newton_euler.dynamics import degrees_of_freedom

TWO = {"P1": "particle", "P2": "particle"}
follows = {"dof_vertical": lambda g, dof_swinging: dof_swinging - 2}

# the cone is about z, with the half angle of 45 deg; its tip is the origin
cone = lambda P1: P1[0] ** 2 + P1[1] ** 2 - P1[2] ** 2
length = lambda P: sqrt(sum(x * x for x in P))
# straight on both sides of the hole, 3 units long
string = lambda P1, P2: length(P1) + length(P2) - 3


def answers(**constraints):
    """When P2 may swing, and when it may not."""
    hangs = {**constraints, "vertical": lambda P2: P2[:2]}
    dofs = (degrees_of_freedom(TWO, given) for given in (constraints, hangs))
    return dict(zip(("dof_swinging", "dof_vertical"), dofs, strict=True))


def solve(g):
    return answers(cone=cone, string=string)


def steps(g):
    return {"coordinates": degrees_of_freedom(TWO).unknowns, "constraints": 2, "more": 2}


def prove(g):
    """By the string's length on the cone, its azimuth, and two angles of the hanging part."""
    on_cone = lambda r, turn: [r * mp.cos(turn), r * mp.sin(turn), r]

    def below(r, turn, to_x, to_y):
        hanging = 3 - r * mp.sqrt(2)
        x, y = mp.sin(to_x), mp.cos(to_x) * mp.sin(to_y)
        return [hanging * c for c in (x, y, -mp.cos(to_x) * mp.cos(to_y))] + on_cone(r, turn)

    start = mpf(1), mpf("0.5")
    return {
        "dof_swinging": freedom(below, *start, mpf("0.2"), mpf("-0.3")),
        "dof_vertical": freedom(lambda *q: below(*q, 0, 0), *start),
    }


def mistakes(g):
    return {
        "no_string": answers(cone=cone),
        "no_swing": {"dof_swinging": solve(g)["dof_vertical"]},
        "no_cone": answers(string=string),
        "fixed_length": answers(cone=cone, string=string, length=lambda P2: length(P2) - 1),
    }


def draw(g, ax):
    ground, s = on_ground(ax, azimuth=0, elevation=18)
    r, h = 0.75 * g.L * sin(g.gamma), 0.75 * g.L * cos(g.gamma)
    tip, rim, left, right = (0, 0, 0), (0, 0, h), (0, -r, h), (0, r, h)
    P1, P2 = (-0.6 * r, 0.48 * r, 0.768 * h), (0, 0, 0.768 * 0.75 * g.L - g.L)
    s.ring(rim, ground.k, r)  # an outline, so that nothing is hidden
    s.line(tip, left, style="solid")
    s.line(tip, right, style="solid")
    s.line(tip, (0, 0, 1.3 * h), style="centre")
    s.path([P1, tip, P2])
    s.arc(tip, left, rim, label=r"$\gamma$")
    for P, name in ((P1, "$P_1$"), (P2, "$P_2$")):
        s.dot(P)
        s.label(P, name, offset=(-14, 4), bold=False)
    s.label((0, 0, P2[2] / 2), "string of length L", offset=(52, 0), bold=False)
