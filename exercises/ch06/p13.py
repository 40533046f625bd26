"""6/13: a block hanging from a free cart, both released from rest."""

from exercises.tools import Sketch, minus, mp, rate, second_rate, size
from newton_euler import Frame, cos, moving, sin, solve_linear
from newton_euler.dynamics import resultant_force

follows = {"T": lambda g, a_A: g.m_A * a_A / sin(g.theta)}


def hung(g, a_A, alpha):
    """Ground with x to the right and z up, the cord, and the block at the instant of release."""
    ground = Frame("ground")
    A = ground.point("A", moving(0, acceleration=a_A), 0, 0)
    cord = ground.rotate("cord", "-y", angle=g.theta, acceleration=alpha, origin=A)
    return ground, cord, cord.point("B", 0, 0, -g.L)


def let_go(g, cart_moves=1):
    """Newton's second law for cart and block; in mistakes the block hangs from a fixed cart."""

    def laws(a_A, alpha, T):
        ground, cord, B = hung(g, cart_moves * a_A, alpha)
        up = cord.k  # from B to A
        return {
            "cart": g.m_A * a_A + T * up.dot(ground.i),
            "block": resultant_force(g.m_B, B.acceleration(ground))
            - (T * up - g.m_B * g.g * ground.k),
        }

    return solve_linear(laws)


def solve(g):
    s = let_go(g)
    return {"a_A": s.a_A, "T": s.T}


def steps(g):
    return {"W_t": g.m_B * g.g * cos(g.theta)}


def prove(g):
    """The centre of mass keeps its horizontal position and the energy is conserved: these give the
    second rate of the angle at rest, then the explicit motion.
    """
    A = lambda theta: [-g.m_B * g.L * mp.sin(theta) / (g.m_A + g.m_B), 0, 0]
    B = lambda theta: [A(theta)[0] + g.L * mp.sin(theta), 0, -g.L * mp.cos(theta)]
    inertia = lambda m, place: m * size(rate(place, g.theta)) ** 2
    slope = g.m_B * g.g * rate(B, g.theta)[2]
    alpha = -slope / (inertia(g.m_A, A) + inertia(g.m_B, B))
    angle = lambda t: g.theta + alpha * t**2 / 2
    a_A, a_B = (second_rate(lambda t, P=P: P(angle(t))) for P in (A, B))
    return {"a_A": a_A[0], "T": g.m_B * size(minus(a_B, [0, 0, -g.g]))}


def mistakes(g):
    T = let_go(g, cart_moves=0).T
    hanging = g.m_B * g.g / cos(g.theta)
    return {
        "cart_held": {"a_A": T * sin(g.theta) / g.m_A, "T": T},
        "no_vertical_acceleration": {"a_A": hanging * sin(g.theta) / g.m_A, "T": hanging},
        "whole_mass": {"a_A": T * sin(g.theta) / (g.m_A + g.m_B)},
        "cosine_for_the_cart": {"a_A": T * cos(g.theta) / g.m_A},
    }


def draw(g, ax):
    ground, cord, B = hung(g, g.g, g.g / g.L)  # any accelerations
    A = cord.origin
    s = Sketch(ax, ground, plane="xz")
    wide, high, r = 0.5 * g.L, 0.2 * g.L, 0.06 * g.L
    level = -2 * r
    s.line((-1.2 * g.L, 0, level), (1.2 * g.L, 0, level), style="solid")
    s.line(A, (0, 0, -1.1 * g.L))
    s.box((0, 0, high / 2), ground, (wide, wide, high))
    for x in (-0.35 * wide, 0.35 * wide):
        s.disk((x, 0, level + r), ground.j, r)
    s.line(A, B, style="solid")
    s.hinge(A)
    s.box(B, ground, (0.25 * g.L,) * 3)
    s.arc(A, -ground.k, B, label=r"$\theta$")
    s.dimension(A, B, label="L", offset=0.2 * g.L)
    s.label((-wide / 2, 0, high), "A")
    s.label(B, "B", offset=(-5, -5))
