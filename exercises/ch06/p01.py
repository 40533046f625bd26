"""6/1: the resultant of three forces on a particle."""

from exercises.tools import Sketch, mp, root
from newton_euler import ForceSystem, Frame, atan, atan2, cos, pi, sin, where

AXES = Frame("axes")
P = AXES.point("P", 0, 0, 0)
follows = {"R_mag": lambda g, R: R.norm(), "dir_R": lambda g, R: direction(R)}


def pulls(g, along=cos, across=sin):
    pairs = (g.F_1, g.theta_1), (g.F_2, g.theta_2), (g.F_3, g.theta_3)
    return [AXES.vector(F * along(theta), F * across(theta), 0) for F, theta in pairs]


def direction(R):
    """Counterclockwise from x, from 0 to a full turn."""
    angle = atan2(R.y, R.x)
    return where(R.y < 0, angle + 2 * pi(angle), angle)


def answers(forces):
    R = ForceSystem({f"F_{n}": (F, P) for n, F in enumerate(forces, 1)}).force
    return {"R": R, "R_mag": R.norm(), "dir_R": direction(R)}


def solve(g):
    return answers(pulls(g))


def prove(g):
    """By the line across which the three forces have no resultant, in the second quadrant."""
    pairs = (g.F_1, g.theta_1), (g.F_2, g.theta_2), (g.F_3, g.theta_3)
    line = root(lambda line: sum(F * mp.sin(theta - line) for F, theta in pairs), mp.pi / 2, mp.pi)
    size = sum(F * mp.cos(theta - line) for F, theta in pairs)
    x, y = size * mp.cos(line), size * mp.sin(line)
    return {"R": [x, y, 0], "R_mag": size, "dir_R": line}


def mistakes(g):
    R = solve(g)["R"]
    first, second, third = pulls(g)
    swapped = answers(pulls(g, sin, cos))
    return {
        "magnitudes": {"R_mag": g.F_1 + g.F_2 + g.F_3},
        "sine_for_cosine": {"R": swapped["R"], "dir_R": swapped["dir_R"]},  # as long as R
        "quadrant": {"dir_R": atan(R.y / R.x)},
        "F_3_upward": answers([first, second, AXES.vector(third.x, g.F_3, 0)]),
    }


def draw(g, ax):
    s = Sketch(ax, AXES, plane="xy")
    s.axes(P, AXES, length=0.55 * g.F_2, labels=["x", "y", ""])
    radii, angles = (0.17, 0.27, 0.09), (g.theta_1, g.theta_2, g.theta_3)
    for n, (F, radius, angle) in enumerate(zip(pulls(g), radii, angles, strict=True), 1):
        tip = (F * (0.75 + 0.25 * g.F_2 / F.norm())).components()  # the longer the larger, no scale
        s.arrow(P, tip, kind="force")
        s.label(tip, f"$F_{n}$", offset=F, bold=False)
        arc = s.around(P, (radius * g.F_2, 0, 0), AXES.k, angle)
        s.path(arc)  # the third arc exceeds half a turn
        at = arc[3 * len(arc) // 4 if n == 3 else len(arc) // 2]
        s.label(at, rf"$\theta_{n}$", offset=at, bold=False)
    s.dot(P, "P", offset=(9, -10))
