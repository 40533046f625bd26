"""11/1: a cart sliding down a rough chute."""

from exercises.tools import Sketch, minus, mp, proofs, rate, root, scaled, size, vanishing
from newton_euler import Frame, pi, sqrt
from newton_euler.algebra.ledger import summed, value_of
from newton_euler.dynamics import constant_force_work, weight


def scene(g):
    """The ground with y up, the chute with x down the slope, A and B."""
    ground = Frame("ground")
    chute = ground.rotate("chute", "z", angle=-g.theta)
    return ground, chute, chute.point("A", 0, 0, 0), chute.point("B", g.L, 0, 0)


def normal_force(g):
    """The normal force of the chute, across which the cart does not move."""
    ground, chute, *_ = scene(g)
    return -weight(g.m, ground.j, g.g).dot(chute.j)


def work(g, N=None):
    """The work of the weight and the friction; N: a wrong normal force."""
    ground, chute, A, B = scene(g)
    N = normal_force(g) if N is None else N
    forces = {"weight": weight(g.m, ground.j, g.g), "friction": -g.mu * N * chute.i}
    return summed({name: constant_force_work(F, A, B) for name, F in forces.items()})


def speed(g, U):
    return {"v_B": sqrt(2 * (g.m * g.v_A**2 / 2 + value_of(U)) / g.m)}


def solve(g):
    return speed(g, work(g))


def steps(g):
    N, U = normal_force(g), work(g).terms
    forces, T_A = {"N": N, "F_f": g.mu * N}, g.m * g.v_A**2 / 2
    return {**forces, "U_w": U["weight"], "U_f": U["friction"], "T_A": T_A}


def prove(g):
    """The motion over time, under the weight and the chute's force by the friction law."""
    down = [mp.cos(g.theta), -mp.sin(g.theta)]
    across = [mp.sin(g.theta), mp.cos(g.theta)]
    place = lambda a: lambda t: scaled(g.v_A * t + a * t**2 / 2, down)

    def parts(a):
        """The components of the chute's force, up it and across it."""
        F = scaled(g.m, minus(proofs.second_rate(place(a)), [0, -g.g]))
        return tuple(sum(f * e for f, e in zip(F, line, strict=True)) for line in (down, across))

    a = vanishing(lambda a: parts(a)[0] + g.mu * parts(a)[1], 0, g.g)
    # the first time at the distance L: the cart stops beyond B, if at all
    far = 2 * g.L / g.v_A if a >= 0 else min(2 * g.L / g.v_A, -g.v_A / a)
    end = root(lambda t: size(place(a)(t)) - g.L, 0, far)
    along, N = parts(a)
    return {"v_B": size(rate(place(a), end)), "N": N, "F_f": -along, "U_f": along * g.L}


def mistakes(g):
    right = work(g)
    return {
        "friction_by_weight": speed(g, work(g, g.m * g.g)),
        "L_as_drop": speed(g, summed({**right.terms, "weight": g.m * g.g * g.L})),
        "friction_drives": speed(g, right.reweighted(friction=-1)),
        "sine_for_cosine": solve(g.but(theta=pi(g.theta) / 2 - g.theta)),
    }


def draw(g, ax):
    ground, chute, A, B = scene(g)
    s = Sketch(ax, ground, plane="xy")
    long, high = 0.14 * g.L, 0.08 * g.L
    end = chute.point("end", 1.45 * g.L, 0, 0)
    s.road([chute.point("start", -0.14 * g.L, 0, 0), end])
    s.box(chute.point("cart", 0, high / 2, 0), chute, (long, high, high))
    s.vector(chute.point("front", long / 2, high / 2, 0), chute.i, "$v_A$")
    s.dimension(A, B, label="L", offset=-0.2 * g.L)
    x, y, _ = end.position(ground).components()
    foot = (x - 0.4 * g.L, y, 0)
    s.line(end, foot)
    s.arc(end, foot, A, label=r"$\theta$")
    s.dot(A, "A", offset=(9, -16))
    s.dot(B, "B", offset=(0, 12))
