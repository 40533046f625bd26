"""11/6: two arms, joined by a spring, that fall open."""

from exercises.tools import Sketch, mp, until
from newton_euler import Frame, dynamics, pi, sin
from newton_euler.algebra.ledger import summed


def scene(g, theta):
    """The ground with y up; body and end of the spring for the left and the right arm."""
    ground = Frame("ground")
    sides = []
    for name, turn in (("left", theta), ("right", -theta)):
        arm = ground.rotate(f"{name} arm", "z", angle=turn)
        sides.append((arm.point(f"{name} body", 0, g.b, 0), arm.point(f"{name} end", 0, g.c, 0)))
    return ground, sides


def span(g, theta):
    """The length of the spring."""
    _, ((_, left), (_, right)) = scene(g, theta)
    return (right - left).norm()


def level(g):
    """The angle of an arm that is horizontal."""
    return pi(g.theta_0) / 2


def mass(g):
    return dynamics.mass_from_weight(g.W, g.g)


def potentials(g, theta):
    """The potentials of the two weights together, and of the spring."""
    ground, ((P, left), (Q, right)) = scene(g, theta)
    heights = (X.position(ground).y for X in (P, Q))
    weights = sum(dynamics.weight_potential(mass(g), y, g.g) for y in heights)
    return weights, dynamics.spring_between(g.k, span(g, level(g)), left, right)


def work(g):
    start, end = potentials(g, g.theta_0), potentials(g, level(g))
    return summed({"weights": start[0] - end[0], "spring": start[1] - end[1]})


def speed(g, U, m=None):
    return {"v": dynamics.speed_after(0, U, 2 * mass(g) if m is None else m)}


def solve(g):
    return speed(g, work(g))


def steps(g):
    U, x_0 = work(g).terms, span(g, level(g)) - span(g, g.theta_0)
    return {"m": mass(g), "x_0": x_0, "U_w": U["weights"], "U_s": U["spring"]}


def prove(g):
    """The right arm over time: moments of weight and spring about O, works for both arms."""
    free = 2 * g.c  # each end is then c to the side

    def rates(state):
        theta, u, *_ = state
        across, up = mp.sin(theta), mp.cos(theta)
        push = g.k * (free - 2 * g.c * across)  # to the right, on the right arm
        by_weight, by_spring = g.W * g.b * across, push * g.c * up  # moments clockwise
        needed = (by_weight + by_spring) / (g.W / g.g * g.b**2)
        return [u, needed, 2 * by_weight * u, 2 * by_spring * u]

    start = [g.theta_0, *[0 * g.theta_0] * 3]
    step = mp.sqrt(g.b / g.g) / 8
    _, (_, u, U_w, U_s) = until(rates, start, lambda s: s[0] - mp.pi / 2, step)
    return {"v": g.b * u, "U_w": U_w, "U_s": U_s}


def mistakes(g):
    right = work(g)
    one_side = dynamics.spring_potential(g.k, g.c * sin(g.theta_0))
    return {
        "one_body": speed(g, right.reweighted(weights=g.one / 2), mass(g)),
        "weight_for_mass": speed(g, right, 2 * mass(g) * g.stated("g")),
        "one_side": speed(g, summed({**right.terms, "spring": one_side})),
        "inches": speed(g, right.reweighted(spring=144)),
    }


def draw(g, ax):
    ground, sides = scene(g, g.theta_0)
    s = Sketch(ax, ground, plane="xy")
    O, top, small = ground.origin, (0, 1.15 * g.b, 0), 0.06 * g.b
    s.ground((0, -0.1 * g.b, 0), ground.j)
    for x in (-0.04, 0.04):
        s.line((x * g.b, -0.1 * g.b, 0), O, style="solid")
    s.line(O, top)
    (P, left), (Q, right) = sides
    for body, _ in sides:
        s.rod(O, body)
        s.sphere(body, small)
    s.spring(left, right)
    s.hinge(O)
    s.arc(O, top, Q, label=r"$\theta_0$")
    s.dimension(O, Q, label="b", offset=-0.4 * g.b)
    s.dimension(O, right, label="c", offset=-0.15 * g.b)
    s.label(O, "O", offset=(-14, 0))
    s.label(P, "W", offset=(-24, 6), bold=False)
    s.label(Q, "W", offset=(24, 6), bold=False)
    s.label((0, left.position(ground).y, 0), "k", offset=(-12, 14), bold=False)
