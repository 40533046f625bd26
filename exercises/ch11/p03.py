"""11/3: a car driving up one slope and coasting up a steeper one."""

from exercises.tools import Sketch, minus, mp, proofs, rate, root, scaled, size, vanishing
from newton_euler import Frame, cos, sin, solve_linear
from newton_euler.algebra.ledger import summed
from newton_euler.dynamics import constant_force_work


def scene(g):
    """The ground with y up, the two slopes with x along them, A and B."""
    ground = Frame("ground")
    first = ground.rotate("first slope", "z", angle=g.theta_1)
    B = first.point("B", g.s_AB, 0, 0)
    start = ground.point("B", g.s_AB * cos(g.theta_1), g.s_AB * sin(g.theta_1), 0)
    second = ground.rotate("second slope", "z", angle=g.theta_2, origin=start)
    return ground, first, second, ground.origin, B


def work_to_B(g):
    ground, first, _, A, B = scene(g)
    forces = {"engine": g.F * first.i, "weight": -g.W * ground.j}
    return summed({name: constant_force_work(F, A, B) for name, F in forces.items()})


def distance(g, U):
    """The distance on the second slope, where the weight does the work -U."""
    ground, _, second, _, _ = scene(g)
    work = lambda P: constant_force_work(-g.W * ground.j, second.origin, P).value
    return solve_linear(lambda s: U + work(second.point("P", s, 0, 0)), "s").s


def solve(g):
    return {"s": distance(g, work_to_B(g).value)}


def steps(g):
    U = work_to_B(g)
    return {"U_e": U.terms["engine"], "U_w": U.terms["weight"], "T_B": U.value}


def prove(g):
    """The motion over time on each slope, with and without the engine's force."""
    gravity = 10  # any value: the distances do not depend on it
    m = g.W / gravity

    def line(angle, v, a):
        return lambda t: scaled(v * t + a * t**2 / 2, [mp.cos(angle), mp.sin(angle)])

    def acceleration(angle, engine):
        def excess(a):
            needed = scaled(m, minus(proofs.second_rate(line(angle, 0, a)), [0, -gravity]))
            return needed[0] * mp.cos(angle) + needed[1] * mp.sin(angle) - engine

        return vanishing(excess, 0, 1)

    a_1, a_2 = acceleration(g.theta_1, g.F), acceleration(g.theta_2, 0)
    up = line(g.theta_1, 0, a_1)
    t_B = root(lambda t: size(up(t)) - g.s_AB, 0, 10 * mp.sqrt(g.s_AB / a_1))
    v = size(rate(up, t_B))
    coasting = line(g.theta_2, v, a_2)
    end = root(lambda t: rate(coasting, t)[0], 0, -2 * v / a_2)
    return {"s": size(coasting(end)), "T_B": m * v**2 / 2}


def mistakes(g):
    right, U = solve(g)["s"], work_to_B(g)
    return {
        "no_climb_to_B": {"s": distance(g, U.terms["engine"])},
        "height_for_distance": {"s": right * sin(g.theta_2)},
        "angle_from_AB": solve(g.but(theta_2=g.theta_1 + g.theta_2)),
        "from_A": {"s": g.s_AB + right},
    }


def draw(g, ax):
    ground, first, second, A, B = scene(g)
    s = Sketch(ax, ground, plane="xy")
    long, high = 0.14 * g.s_AB, 0.06 * g.s_AB
    end = second.point("end", 0.75 * g.s_AB, 0, 0)
    s.road([(-0.2 * g.s_AB, 0, 0), A])
    s.wire([A, B, end])  # without hatching, for the small angles
    s.box(first.point("car", 0, 0.8 * high, 0), first, (long, high, high))
    for x in (-0.3 * long, 0.3 * long):
        s.disk(first.point("wheel", x, 0.3 * high, 0), ground.k, 0.3 * high)
    s.vector(first.point("centre", 0, 0.8 * high, 0), -ground.j, "W", kind="force")
    s.vector(first.point("front", long / 2, 0.8 * high, 0), first.i, "F", kind="force")
    level = second.rotate("level", "z", angle=-g.theta_2)
    for P, name, along, up in (
        (A, "1", ground.point("level at A", 0.7 * g.s_AB, 0, 0), B),
        (B, "2", level.point("level at B", 0.7 * g.s_AB, 0, 0), end),
    ):
        s.line(P, along)
        s.arc(P, along, up, label=rf"$\theta_{name}$", radius=0.6 * g.s_AB)
    s.dimension(A, B, label="$s_{AB}$", offset=0.2 * g.s_AB)
    s.dot(A, "A", offset=(-12, -14))
    s.dot(B, "B", offset=(4, -16))
