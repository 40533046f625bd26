"""3/13: the largest acceleration of a point on an element that turns and oscillates axially."""

from exercises.tools import mp, on_ground, proofs
from newton_euler import Frame, cylindrical, moving, pi, sin


def at_the_top(g):
    """The acceleration of A at the end of the stroke, where the axial component is largest."""
    z = g.z0 * sin(moving(pi(g.one) / 2, rate=2 * pi(g.one) * g.n))
    A = cylindrical(Frame("ground"), "A", g.r, moving(0 * g.one, rate=g.omega), z)
    return A.acceleration(A.ground)


def solve(g):
    return {"a_max": at_the_top(g).norm()}


def steps(g):
    a = at_the_top(g)
    return {"a_r": abs(a.x), "a_z": abs(a.z)}


def prove(g):
    """The maximum of the acceleration over time, where its rate vanishes."""
    up = lambda t: g.z0 * mp.sin(2 * mp.pi * g.n * t)
    place = lambda t: proofs.at_angle(g.r, g.omega * t, up(t))
    a = lambda t: proofs.size(proofs.second_rate(place, t))
    period = 1 / g.n
    little = period / 50
    early, late = period * mp.mpf("0.13"), period * mp.mpf("0.36")
    instant = proofs.root(lambda t: a(t + little) - a(t - little), early, late)
    return {"a_max": a(instant)}


def mistakes(g):
    a = at_the_top(g)
    return {
        "added_as_scalars": {"a_max": abs(a.x) + abs(a.z)},
        "n_as_rad_per_s": solve(g.but(n=g.n / (2 * pi(g.one)))),
        "no_centripetal": {"a_max": abs(a.z)},
    }


def draw(g, ax):
    ground, s = on_ground(ax, azimuth=35, elevation=20)
    O, z = (0, 0, 0), 0.7 * g.z0
    C, A = (0, 0, z), (0, g.r, z)
    low, high = (0, 0, -1.6 * g.z0), (0, 0, 2.2 * g.z0)
    s.shaft(low, high)
    s.disk(C, ground.k, g.r, spoke=A, thickness=0.15 * g.z0)
    s.line((0, -1.6 * g.r, 0), O)
    s.line((0, -1.6 * g.r, z), (0, -g.r, z))
    s.dimension((0, -1.5 * g.r, 0), (0, -1.5 * g.r, z), label="z", offset=0)
    s.dimension(C, A, label="r", offset=0.6 * g.z0)
    s.turn((0, 0, 1.6 * g.z0), ground.k, label=r"$\omega$")
    s.dot((0, g.r, z + 0.075 * g.z0), "A")
