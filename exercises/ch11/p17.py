"""11/17: the kinetic energy of a rolling disk."""

from exercises.tools import mp, on_ground, plus, proofs, rot, times
from newton_euler import Frame, dynamics, kinetic_energy, moving, solve_rates
from newton_euler.bodies import disk, ring


def rolling(g, body):
    """The ground with x along the line and y up, the point of contact, and the body, rolling."""
    ground = Frame("ground")
    P = ground.point("P", 0, -g.r, 0)

    def wheel(omega):
        C = ground.point("C", moving(0 * g.r, rate=g.u), 0, 0)
        return ground.rotate("wheel", "z", rate=omega, origin=C)

    slip = lambda omega: wheel(omega).point("contact", 0, -g.r, 0).velocity(ground).x
    return ground, P, body(g.r, wheel(*solve_rates(slip, 1)), "z", mass=g.m)


def energy(g, body):
    ground, _, rolled = rolling(g, body)
    return kinetic_energy(rolled, ground)


def solve(g):
    return {"T": energy(g, disk).value}


def steps(g):
    ground, _, body = rolling(g, disk)
    T = energy(g, disk)
    return {
        "omega": body.frame.angular_velocity(ground).norm(),
        "I_C": body.inertia.moment("z"),
        "T_trans": T.terms["translation"],
        "T_rot": T.terms["rotation"],
    }


def prove(g):
    """Mass points on cycloids: the disk advances by its circumference per turn."""
    omega = 2 * mp.pi / (2 * mp.pi * g.r / g.u)
    points = proofs.disk(g.r, order=2)

    def motion(t):
        return [(u, plus([g.u * t, 0, 0], times(rot("z", -omega * t), p))) for u, p in points]

    return {"T": proofs.kinetic_energy(g.m, motion), "omega": omega}


def mistakes(g):
    T = energy(g, disk)
    ground, P, body = rolling(g, disk)
    about_contact = dynamics.kinetic_energy_about(body, P, ground)
    return {
        "no_rotation": {"T": T.reweighted(rotation=0)},
        "hoop": {"T": energy(g, ring).value},
        "translation_twice": {"T": about_contact.value + T.terms["translation"]},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    C, r = (0, 0, 0), 1.0
    s.road([(-1.8 * r, -r, 0), (2.2 * r, -r, 0)])
    s.disk(C, ground.k, r)
    s.dimension(C, (-0.8 * r, 0.6 * r, 0), label="r", offset=0)
    s.dot(C)
    s.vector(C, 1.7 * r * ground.i, "u")
