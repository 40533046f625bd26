"""11/24: a pendulum of a rod and a bob, released from rest."""

from exercises.tools import Sketch, mp, mpf, proofs
from newton_euler import Frame, cos, particle, sin
from newton_euler.bodies import rod
from newton_euler.dynamics import speed_after, weight_potential

follows = {"v_bob": lambda g, T: speed(g, T, sum(moments(g)))}


def scene(g, theta):
    """Ground, the hinge, rod and bob at the angle theta from the downward vertical."""
    ground = Frame("ground")
    hanging = ground.rotate("pendulum", "-y", angle=theta)
    bar = rod(g.l, hanging.point("G", 0, 0, -g.l / 2), "z", mass=g.m)
    bob = particle(g.n * g.m, hanging.point("B", 0, 0, -g.l))
    return ground, hanging.origin, bar, bob


def potentials(g, theta):
    """The potentials of rod and bob, zero at the level of the hinge."""
    ground, _, *bodies = scene(g, theta)
    return [weight_potential(b.mass, b.centre.position(ground).z, g.g) for b in bodies]


def losses(g):
    """The losses of potential energy of rod and bob."""
    pairs = zip(potentials(g, g.theta_A), potentials(g, 0), strict=True)
    return [start - end for start, end in pairs]


def moments(g):
    """The moments of inertia of rod and bob about the hinge."""
    _, O, *bodies = scene(g, 0)
    return [b.about(O).moment("y") for b in bodies]


def speed(g, T, I):
    """The speed of the bob for the kinetic energy T and this inertia."""
    return speed_after(0, T, I / g.l**2)


def solve(g):
    T = sum(losses(g))
    return {"T": T, "v_bob": speed(g, T, sum(moments(g)))}


def steps(g):
    rod_lost, bob_lost = losses(g)
    of_rod, of_bob = moments(g)
    return {"Delta_rod": -rod_lost, "Delta_bob": -bob_lost, "I_rod": of_rod, "I_O": of_rod + of_bob}


def prove(g):
    """The motion from release, with mass points that need the moment of their weights."""
    half = [g.l / 2, 0, 0]
    along = [(share, proofs.plus(half, p)) for share, p in proofs.box(g.l, 0, 0, order=2)]
    # x downward; the rod is 1/(1 + n) of the whole mass
    points = [(share / (1 + g.n), p) for share, p in along] + [(g.n / (1 + g.n), [g.l, 0, 0])]
    whole = (1 + g.n) * g.m
    turned = lambda angle: proofs.carried(points, lambda t: proofs.rot("z", angle(t)))

    def moment_of_weights(theta):
        turned_x = proofs.rot("z", theta)[1][0]  # the y of a place on x, for 1 m
        return -whole * g.g * turned_x * sum(share * p[0] for share, p in points)

    needed = proofs.moment_needed(whole, turned(lambda t: t * t / 2))[2]  # for 1 rad/s^2
    start = [g.theta_A, mpf(0)]
    rates = lambda s: [s[1], moment_of_weights(s[0]) / needed]
    _, (_, rate) = proofs.until(rates, start, lambda s: s[0], mp.sqrt(g.l / g.g) / 2)
    return {
        "T": proofs.kinetic_energy(whole, turned(lambda t: rate * t)),
        "v_bob": proofs.size(proofs.rate(lambda t: turned(lambda t: rate * t)(t)[-1][1])),
        "I_O": needed,
        "I_rod": g.m * proofs.mean(lambda p: p[0] ** 2, along),
    }


def mistakes(g):
    right, (of_rod, of_bob) = solve(g)["T"], moments(g)
    both = (1 + g.n) * g.m * g.g * g.l * (1 - cos(g.theta_A))
    _, _, bar, _ = scene(g, 0)
    return {
        "rod_falls_with_bob": {"T": both, "v_bob": speed(g, both, of_rod + of_bob)},
        "rod_at_rest": {"v_bob": speed(g, right, of_bob)},
        "about_centre": {"v_bob": speed(g, right, bar.inertia.moment("y") + of_bob)},
        "bob_alone": {"v_bob": speed(g, losses(g)[1], of_bob)},
    }


def draw(g, ax):
    ground, O, _, bob = scene(g, g.theta_A)
    s = Sketch(ax, ground, plane="xz")
    A, lowest = bob.centre, (0, 0, -g.l)
    s.road([(0.1 * g.l, 0, 0), (-0.3 * g.l, 0, 0)])
    s.line(O, lowest)
    s.ring(lowest, ground.j, 0.05 * g.l)
    s.path(s.around(O, A, ground.j, g.theta_A), style="dashed")
    s.rod(O, A)
    s.hinge(O)
    s.sphere(A, 0.05 * g.l)
    s.arc(O, -ground.k, A, label=r"$\theta_A$")
    s.dimension(O, A, label="l")
    s.label(O, "O", offset=(-12, -14))
    s.label(A, "A", offset=(26, 9))
    s.label(A, "$n\\,m$", offset=(28, -9), bold=False)
    on_rod = (0.4 * g.l * sin(g.theta_A), 0, -0.4 * g.l * cos(g.theta_A))
    s.label(on_rod, "m", offset=(-4, -14), bold=False)
