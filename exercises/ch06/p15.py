"""6/15: where a collar stays on a hoop that turns about its vertical diameter."""

from itertools import pairwise

from exercises.tools import Sketch, mp, mpf, proofs, rate, times
from newton_euler import Frame, acos, asin, atan, cos, pi, root, sin
from newton_euler.dynamics import reaction

ENDS = ("-0.3", "0.3", "3", "3.3")  # one equilibrium in each interval, for all numbers in `vary`


def collar(g, theta):
    """Ground with z up, the hoop, whose x points to the collar's side, and the collar."""
    ground = Frame("ground")
    hoop = ground.rotate("hoop", "z", rate=g.omega)
    return ground, hoop, hoop.point("C", g.r * sin(theta), 0, -g.r * cos(theta))


def along_hoop(g, theta):
    """The force along the hoop that the collar needs to stay at theta, zero without friction."""
    ground, hoop, C = collar(g, theta)
    a = C.acceleration(ground, via=hoop).expressed_in(hoop)
    N = reaction(g.m, a, weight=-g.m * g.g * ground.k)
    return N.dot(hoop.vector(cos(theta), 0, sin(theta)))


def solve(g):
    pairs = pairwise(float(end) * g.one for end in ENDS)
    places = (root(lambda theta: along_hoop(g, theta), *pair) for pair in pairs)
    return {f"theta_{n}": theta for n, theta in enumerate(places, 1)}


def steps(g):
    ground, _, C = collar(g, pi(g.one) / 2)
    return {"a_level": C.acceleration(ground).norm()}


def prove(g):
    """Where the Lagrangian of the collar, moving with the hoop, is stationary in theta."""

    def place(theta, t=0):
        return times(proofs.rot("z", g.omega * t), [g.r * mp.sin(theta), 0, -g.r * mp.cos(theta)])

    def lagrangian(theta):
        x, y, z = place(theta)
        return g.omega**2 * (x * x + y * y) / 2 - g.g * z

    slope = lambda theta: rate(lagrangian, theta)
    places = (proofs.root(slope, *pair) for pair in pairwise(map(mpf, ENDS)))
    return {f"theta_{n}": theta for n, theta in enumerate(places, 1)}


def mistakes(g):
    right = solve(g)["theta_2"]
    share = g.g / (g.r * g.omega**2)
    return {
        "both_signs": {"theta_1": -right, "theta_2": 0 * right, "theta_3": right},
        "r_for_the_circle": {"theta_2": atan(1 / share)},
        "sine": {"theta_2": asin(share)},
        "from_above": {"theta_2": pi(share) - acos(share)},
    }


def draw(g, ax):
    theta, r = 0.9, g.r  # anywhere
    ground, _, C = collar(g, theta)
    s = Sketch(ax, ground, plane="xz")
    O, A, B = (0, 0, 0), (0, 0, r), (0, 0, -r)
    s.line((0, 0, -1.5 * r), (0, 0, 1.6 * r), style="centre")
    s.ring(O, ground.j, r)
    s.line(O, C)
    s.dot(C)
    s.dot(O)
    for end, side in ((A, 1), (B, -1)):
        s.rod(end, (0, 0, side * 1.3 * r))
        s.hinge((0, 0, side * 1.2 * r), axis=ground.k)
    s.turn((0, 0, 1.45 * r), ground.k, label=r"$\omega$")
    s.arc(O, -ground.k, C, label=r"$\theta$")
    s.arrow(O, (-r * sin(2.2), 0, -r * cos(2.2)), label="r")
    s.label(A, "A", offset=(12, 10))
    s.label(B, "B", offset=(12, -10))
    s.label(C, "m", offset=(14, -6), bold=False)
