"""10/8: a motor on a turntable."""

from exercises.tools import Sketch, moment_needed, proofs, rot, times
from newton_euler import ForceSystem, Frame, solve_linear
from newton_euler.applications import normal_moment

follows = {"F_B": lambda g, F_A: g.m * g.g - F_A}


def motor(g):
    """The ground, the turntable, whose origin is G, and the rotor."""
    ground = Frame("ground")
    table = ground.rotate("turntable", "y", rate=g.Omega)
    return ground, table, table.rotate("rotor", "-x", rate=g.p)


def couple(g):
    """The gyroscopic couple that the supports must exert (10.38)."""
    ground, table, rotor = motor(g)
    spin = rotor.angular_velocity(table).expressed_in(table)
    precession = table.angular_velocity(ground).expressed_in(table)
    return normal_moment(precession, spin, g.m_r * g.k**2)


def supports(g, couple):
    """The forces at A and B that balance the weight and exert the couple."""
    table, j = couple.frame, couple.frame.j
    G, A, B = table.point("G", 0, 0, 0), table.point("A", -g.a, 0, 0), table.point("B", g.b, 0, 0)

    def balance(F_A, F_B):
        forces = ForceSystem({"A": (j * F_A, A), "B": (j * F_B, B), "W": (j * (-g.m * g.g), G)})
        return {"force": forces.force.y, "moment": forces.moment(G).z - couple.z}

    found = solve_linear(balance)
    return {"F_A": found.F_A, "F_B": found.F_B}


def solve(g):
    return supports(g, couple(g))


def steps(g):
    _, table, rotor = motor(g)
    return {
        "I_r": g.m_r * g.k**2,
        "omega_r": rotor.angular_velocity(table).expressed_in(table),
        "M_G": couple(g),
        "W": g.m * g.g,
    }


def prove(g):
    """The moments about each support that the mass points need besides that of gravity."""
    turned = proofs.along_x(proofs.ring(g.k))
    own = lambda t: rot([-1, 0, 0], g.p * t)
    rotor = proofs.carried(turned, lambda t: times(rot("y", g.Omega * t), own(t)))
    # of the supports, about the place x on AB
    moment = lambda x: moment_needed(g.m_r, rotor, about=(x, 0, 0))[2] - x * g.m * g.g
    AB = g.a + g.b
    return {
        "F_A": -moment(g.b) / AB,
        "F_B": moment(-g.a) / AB,
        "I_r": g.m_r * proofs.mean(lambda r: r[1] ** 2 + r[2] ** 2, turned),
        "omega_r": proofs.angular_velocity(own),
        "M_G": moment_needed(g.m_r, rotor),
    }


def mistakes(g):
    right = couple(g)
    return {
        "other_sense": supports(g, -right),
        "total_mass": solve(g.but(m_r=g.m)),
        "no_weight": supports(g.but(g=0 * g.g), right),
        "no_gyroscopic_couple": supports(g, right * 0),
        "rpm": solve(g.but(p=g.stated("p"), Omega=g.stated("Omega"))),
    }


def draw(g, ax):
    ground, *_ = motor(g)
    s = Sketch(ax, ground, plane="xy")
    h = 0.25 * (g.a + g.b)  # height of the motor shaft above the table
    low, thick = -h, 0.12 * h
    left, right = -g.a - 0.6 * h, g.b + 0.6 * h
    A, B, G = (-g.a, low, 0), (g.b, low, 0), (0, 0, 0)
    s.box(((left + right) / 2, low - 1.5 * thick, 0), ground, (right - left, thick, h))
    s.ground((0, low - 2.2 * h, 0), normal=ground.j)
    s.shaft((0, low - 2.2 * h, 0), (0, low - 2 * thick, 0))
    half = 0.6 * min(g.a, g.b)
    s.cylinder((-half, 0, 0), (half, 0, 0), 0.5 * h)
    for x in (-g.a, g.b):
        s.rod((x, low - thick, 0), (x, 0, 0))
    s.shaft((-g.a - 0.4 * h, 0, 0), (g.b + 0.4 * h, 0, 0))
    s.line((0, low - 2.2 * h, 0), (0, 1.4 * h, 0), style="centre")
    s.turn((0, low - 1.2 * h, 0), ground.j, label=r"$\Omega$")
    s.turn((g.b + 0.3 * h, 0, 0), -ground.i, label="p")
    s.label(A, "A", offset=(-10, 8))
    s.label(B, "B", offset=(10, 8))
    s.dot(G, "G", offset=(10, 10))
    top = 0.95 * h
    s.dimension((-g.a, top, 0), (0, top, 0), label="a", offset=0)
    s.dimension((0, top, 0), (g.b, top, 0), label="b", offset=0)
