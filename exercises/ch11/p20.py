"""11/20: the kinetic energy of a disk on an arm, rolling round the inside of a cylinder."""

from exercises.devices.disk_on_shaft import carried, contact, rolling, spinning, unrolled
from exercises.tools import Sketch, angular_velocity, mp, plus, proofs, rate, rot, size, times
from newton_euler import Body, asin, atan, cos, kinetic_energy, pi, sin, sqrt


def turning(g):
    """Rate of the vertical plane of the arm."""
    return 2 * pi(g.f) * g.f


def leaning(g):
    """The angle of OA to the vertical."""
    return asin(g.R / sqrt(g.L**2 + g.r**2)) - atan(g.r / g.L)


def rise(g):
    """The angle of OA above the level."""
    return pi(g.f) / 2 - leaning(g)


def rolls(g):
    return rolling(turning(g), g.r, g.L, rise(g))


def axial(d):
    """The axial angular velocity; the spin opposes the rotation of the arm and exceeds it."""
    return -d.body.angular_velocity(d.ground).expressed_in(d.shaft).x


def energy(g, d):
    G = d.body.point("G", g.c - g.L, 0, 0)
    return kinetic_energy(Body("disk and arm", g.M, G, (g.I_a, g.I_t, g.I_t)), d.ground)


def solve(g):
    d = rolls(g)
    return {"theta": leaning(g), "omega_axial": axial(d), "T": energy(g, d).value}


def energy_by(g, theta, omega_axial):
    across = turning(g) * sin(theta)
    return (g.I_a * omega_axial**2 + (g.I_t + g.M * g.c**2) * across**2) / 2


follows = {"omega_axial": lambda g, theta: turning(g) * (g.R / g.r - cos(theta)), "T": energy_by}


def steps(g):
    d = rolls(g)
    return {
        "OP": sqrt(g.L**2 + g.r**2),
        "psi_dot": turning(g),
        "omega_s": -d.body.angular_velocity(d.shaft).expressed_in(d.shaft).x,
        "omega_t": d.body.angular_velocity(d.ground).expressed_in(d.shaft).z,
        "v_G": d.shaft.point("G", g.c, 0, 0).velocity(d.ground).norm(),
    }


def prove(g):
    """By the rim rolling along the wall, and mass points of the same inertia."""
    Omega = 2 * mp.pi * g.f
    gap = lambda theta: g.R - times(rot("y", theta - mp.pi / 2), [g.L, 0, -g.r])[0]
    theta = proofs.root(gap, 0, mp.pi / 4)
    up = mp.pi / 2 - theta
    spin = unrolled(Omega, g.r, g.R)

    # four points around OA, two on OA, and the rest of the mass at G
    one, round_it, on_it = g.L, g.I_a / (4 * g.L**2), (g.I_t - g.I_a / 2) / (2 * g.L**2)
    around = [(round_it, [0, y * one, z * one]) for y, z in ((1, 0), (-1, 0), (0, 1), (0, -1))]
    along = [(on_it, [x * one, 0, 0]) for x in (1, -1)]
    rest = [(g.M - 4 * round_it - 2 * on_it, [0, 0, 0])]
    points = [(m, plus([g.c - g.L, 0, 0], p)) for m, p in around + along + rest]
    turned = lambda t: times(rot("z", Omega * t), rot("y", -up), rot("x", spin * t))
    omega = angular_velocity(turned)
    along_arm = [mp.sin(theta), 0, mp.cos(theta)]
    part = sum(x * e for x, e in zip(omega, along_arm, strict=True))
    return {
        "theta": theta,
        "omega_axial": abs(part),
        "T": proofs.kinetic_energy(1, carried(points, Omega, spin, g.L, up)),
        "omega_s": abs(spin),
        "omega_t": mp.sqrt(size(omega) ** 2 - part**2),
        "v_G": size(rate(lambda t: times(rot("z", Omega * t), rot("y", -up), [g.c, 0, 0]))),
    }


def mistakes(g):
    right = rolls(g)
    spin, Omega = right.body.angular_velocity(right.shaft).norm(), turning(g)

    def with_axial(omega):
        """The spin on the arm that gives the body this component along OA."""
        along = right.shaft.angular_velocity(right.ground).expressed_in(right.shaft).x
        d = spinning(Omega, -omega - along, g.L, rise(g))
        return {"omega_axial": axial(d), "T": energy(g, d).value}

    slow = solve(g.but(f=g.f / (2 * pi(g.f))))
    return {
        "relative_spin": with_axial(spin),
        "no_translation": {"T": energy(g, right).reweighted(translation=0)},
        "spin_added": with_axial(spin + Omega * cos(leaning(g))),
        "turns_for_radians": {key: slow[key] for key in ("omega_axial", "T")},
    }


def draw(g, ax):
    d = spinning(0, 0, g.L, rise(g))
    ground = d.ground
    s = Sketch(ax, ground, plane="xz")
    O, A, P = ground.point("O", 0, 0, 0), d.C, contact(d, g.r)
    top, R = 1.75 * g.L, g.R
    low = -0.35 * g.L
    s.road([(R, 0, low), (R, 0, top)])
    s.road([(-R, 0, top), (-R, 0, low)])
    s.line((0, 0, low), (0, 0, top), style="centre")
    s.ground(O, normal=ground.k)
    s.turn((0, 0, 0.9 * top), ground.k, label="f")
    s.rod(O, A)
    s.disk(A, d.shaft.i, g.r, thickness=0.05 * g.r)
    s.ball_joint(O)
    s.arc(O, ground.k, A, label=r"$\theta$", radius=0.35 * g.L)
    G = d.shaft.point("G", g.c, 0, 0)
    s.dimension((0, 0, low), (-R, 0, low), label="R", offset=0)
    s.dimension(O, A, label="L", offset=-0.5 * g.L)
    s.dimension(O, G, label="c", offset=-0.2 * g.L)
    s.dimension(A, contact(d, -g.r), label="r", offset=-0.2 * g.L)
    s.label(O, "O", offset=(-14, 6))
    s.label(A, "A", offset=(12, 5))
    s.dot(P, "P", offset=(12, 0))
    s.dot(G, "G", offset=(-12, 8))
