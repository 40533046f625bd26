"""3/4: constant speed on a helix, in cylindrical components."""

from exercises.devices.helix import figure, helix, on_helix, unrolled
from exercises.tools import mp, rate, second_rate, terms
from newton_euler import kinematics, moving, pi


def rise(g):
    """The rise per radian."""
    return g.p / (2 * pi(g.p))


def angle(g):
    """theta = 0, with its rates."""
    return kinematics.at_speed(helix(g.a, rise(g)), 0 * g.one, g.nu)


def motion(g, theta):
    P = on_helix(g.a, rise(g), theta)
    return {"v": P.velocity(P.ground), "acc": P.acceleration(P.ground)}


def solve(g):
    return motion(g, angle(g))


def steps(g):
    yield "theta_dot", angle(g).rate
    yield from terms(solve(g)["v"], "v", "m/s", "3.5")


def prove(g):
    """At theta = 0, where e_r, e_theta, k are i, j, k."""
    place = unrolled(g.a, g.p / (2 * mp.pi), g.nu)
    return {"v": rate(place), "acc": second_rate(place)}


def mistakes(g):
    return {
        "axial_part_forgotten": motion(g, moving(0 * g.one, rate=g.nu / g.a)),
        "pitch_per_radian": solve(g.but(p=2 * pi(g.p) * g.p)),
        "no_acceleration": {"acc": 0 * solve(g)["acc"]},
    }


def draw(g, ax):
    theta = 2.4
    local = on_helix(g.a, rise(g), theta).local
    s, _, _, P = figure(ax, local.parent, g.a, rise(g), theta, "a")
    s.axes(P, local, length=0.9 * g.a, labels=["$e_r$", r"$e_\theta$", "k"])
    low, high = (helix(g.a, rise(g))(0.4 + 2 * pi() * n) for n in range(2))
    s.dimension(low, high, label="p")
