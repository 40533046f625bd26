"""10/7: a fan whose precession needs the moment of a shifted counterweight."""

from exercises.tools import Sketch, mean, moment_needed, plus, ring, rot, times, vanishing
from newton_euler import ForceSystem, Frame, cos, sin, solve_linear
from newton_euler.applications.gyroscopes import normal_moment
from newton_euler.dynamics import weight


def frames(g):
    """Ground with Y up, the head, turning about the post with Z towards the fan, and the rotor."""
    ground = Frame("ground")
    head = ground.rotate("head", "y", rate=g.Omega)
    return ground, head, head.rotate("rotor", "-z", rate=g.p)


def gyroscopic_moment(g):
    """The moment needed in steady precession, by the spinning parts only."""
    ground, head, rotor = frames(g)
    precession, spin = head.angular_velocity(ground), rotor.angular_velocity(head)
    return normal_moment(precession, spin, g.m * g.k**2).expressed_in(head).x


def moment_of_block(g, b):
    ground, head, _ = frames(g)
    A = head.point("A", 0, 0, -b)
    return ForceSystem({"A": (weight(g.m_A, ground.j, g.g), A)}).moment(head).expressed_in(head).x


def distance(g, M, b_0):
    """The distance at which the weights have the moment M, if they balance at b_0."""
    return solve_linear(lambda b: moment_of_block(g, b) - moment_of_block(g, b_0) - M).b


def solve(g):
    return {"b": distance(g, gyroscopic_moment(g), g.b_0)}


def steps(g):
    return {
        "I": g.m * g.k**2,
        "M_X": gyroscopic_moment(g),
        "M_fan": -moment_of_block(g, g.b_0),
        "M_block": gyroscopic_moment(g) + moment_of_block(g, g.b_0),
    }


def prove(g):
    """The moment that mass points of ring and block need; balance at rest locates the fan."""
    of_weights = lambda *points: sum(m * g.g * place[2] for m, place in points)
    block = lambda b: (g.m_A, [0, 0, -b])
    ahead = vanishing(lambda d: of_weights((g.m, [0, 0, d]), block(g.b_0)), 0, g.b_0)
    points = ring(g.k, order=2)

    def lacking(b):
        def motion(t):
            turned, spun = rot("y", g.Omega * t), rot("z", -g.p * t)
            places = [(g.m * u, plus([0, 0, ahead], times(spun, r))) for u, r in points]
            return [(m, times(turned, r)) for m, r in (*places, block(b))]

        return moment_needed(1, motion)[0] - of_weights(*motion(0))

    b = vanishing(lacking, 0, g.b_0)
    fan = of_weights((g.m, [0, 0, ahead]))
    return {
        "b": b,
        "I": g.m * mean(lambda r: r[0] ** 2 + r[1] ** 2, points),
        "M_X": fan + of_weights(block(b)),
        "M_fan": fan,
        "M_block": of_weights(block(b)),
    }


def mistakes(g):
    M = gyroscopic_moment(g)
    return {
        "wrong_way": {"b": distance(g, -M, g.b_0)},
        "no_balance": {"b": distance(g, M, 0)},
        "rpm": solve(g.but(p=g.stated("p"))),
        "disk": {"b": distance(g, M / 2, g.b_0)},
    }


def draw(g, ax):
    """The block at any distance, the fan in front of the post at about the same one."""
    ground, _, _ = frames(g)
    d = g.b_0
    s = Sketch(ax, ground, up="y", azimuth=-62, elevation=16)
    O, A, F = (0, 0, 0), (0, 0, -1.3 * d), (0, 0, 0.8 * d)
    foot = (0, -1.5 * d, 0)
    s.ground(foot, ground.j, size=0.9 * d)
    s.shaft(foot, O)
    s.rod((0, 0, -1.18 * d), O, F)
    s.box(A, ground, (0.24 * d, 0.24 * d, 0.24 * d))
    s.cylinder((0, 0, 0.25 * d), (0, 0, 0.6 * d), 0.2 * d)
    s.hinge(O, axis=ground.i)
    s.disk(F, ground.k, 0.15 * d)
    for n in range(4):
        middle = 0.4 + n * 1.5708
        root, tip = 0.12 * d, 0.75 * d
        blade = [(root, -0.3), (tip, -0.4), (tip, 0.4), (root, 0.3)]
        s.plate([(r * cos(middle + t), r * sin(middle + t), 0.8 * d) for r, t in blade])
    s.turn((0, 0, 1.25 * d), -ground.k, label="p")
    s.line(F, (0, 0, 1.4 * d), style="centre")
    s.turn((0, -1.1 * d, 0), ground.j, label=r"$\Omega$")
    s.dimension(A, O, label="b", offset=0.4 * d)
    s.label(A, "A")
