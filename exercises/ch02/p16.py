"""2/16: tape over two pulleys: one speed, one tangential acceleration, two curvatures."""

from exercises.tools import at_angle, mp, on_ground, root, second_rate, size
from newton_euler import Frame, sqrt

follows = {"a_P2": lambda g, v_tape: rim_point(g.r_2, v_tape, g.a_t2).norm()}


def rim_point(r, v, a_t):
    """The acceleration of a point on the rim of a pulley driven by tape: radial, tangential."""
    ground = Frame("ground")
    pulley = ground.rotate("pulley", "z", rate=v / r, acceleration=a_t / r)
    return pulley.point("P", r, 0, 0).acceleration(ground)


def solve(g):
    """The speed from the normal acceleration v^2/r_1 at pulley 1."""
    v = sqrt(g.a_n1 * g.r_1)
    a_P1, a_P2 = (rim_point(r, v, g.a_t2).norm() for r in (g.r_1, g.r_2))
    return {"v_tape": v, "a_P1": a_P1, "a_P2": a_P2}


def steps(g):
    v = sqrt(g.a_n1 * g.r_1)
    return {"a_t1": rim_point(g.r_1, v, g.a_t2).y, "a_n2": -rim_point(g.r_2, v, g.a_t2).x}


def prove(g):
    """The rims over time; the speed gives P1 the given inward acceleration."""
    path = lambda r, v: lambda t: at_angle(r, (v * t + g.a_t2 * t**2 / 2) / r)
    acceleration = lambda r, v: second_rate(path(r, v))
    fast = mp.mpf(100) * mp.sqrt(g.a_n1 * g.r_1 + g.a_t2 * g.r_1)
    v = root(lambda v: -acceleration(g.r_1, v)[0] - g.a_n1, 0, fast)
    first, second = acceleration(g.r_1, v), acceleration(g.r_2, v)
    answers = {"v_tape": v, "a_P1": size(first), "a_P2": size(second)}
    return answers | {"a_t1": first[1], "a_n2": -second[0]}


def mistakes(g):
    right = solve(g)
    second = rim_point(g.r_2, right["v_tape"], g.a_t2)
    return {
        "same_normal": {"a_P2": right["a_P1"]},
        "same_alpha": {"a_P1": rim_point(g.r_1, right["v_tape"], g.a_t2 * g.r_1 / g.r_2).norm()},
        "sum_of_components": {"a_P1": g.a_n1 + g.a_t2, "a_P2": second.y - second.x},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    r, q = g.r_1, g.r_2
    apart, down, k = 3 * (r + q), 2.5 * (r + q), ground.k
    one, two = (0, 0, 0), (apart, 0, 0)
    A = s.pulley((0.1 * apart, -down, 0), k, 0.6 * r)
    B = s.pulley((0.9 * apart, -down, 0), k, 0.6 * r)
    first, second = s.pulley(one, k, r), s.pulley(two, k, q)
    s.cable(A, first, second, B, turns=(-1, -1, -1, -1))
    s.dot((0, r, 0), "P1")
    s.dot((apart + q, 0, 0), "P2")
    s.vector((0, r, 0), -ground.j, r"$a_{n1}$", kind="acceleration")
    s.vector((apart + q, 0, 0), -ground.j, r"$a_{t2}$", kind="acceleration")
    s.dimension(one, (-r * 3**0.5 / 2, r / 2, 0), label="$r_1$", offset=0)
    s.dimension(two, (apart - q * 3**0.5 / 2, q / 2, 0), label="$r_2$", offset=0)
    s.label((0.1 * apart, -down, 0), "A")
    s.label((0.9 * apart, -down, 0), "B")
