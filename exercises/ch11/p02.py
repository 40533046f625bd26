"""11/2: a block on a rail between a cable and a spring."""

from exercises.tools import Sketch, minus, size, until
from newton_euler import Frame
from newton_euler.algebra.ledger import summed
from newton_euler.dynamics import speed_after, spring_potential


def scene(g):
    """The ground with x along the rail and y up, A, B and C."""
    ground = Frame("ground")
    places = {"A": (0, 0), "B": (g.d, 0), "C": (g.d, g.h)}
    return ground, *(ground.point(name, x, y, 0) for name, (x, y) in places.items())


def cable(g):
    """The length of the cable from the block to C, at the start and at the end."""
    _, A, B, C = scene(g)
    return (C - A).norm(), (C - B).norm()


def work(g):
    """The works of cable and spring; the pulled end moves as far as the block's part shortens."""
    start, end = cable(g)
    taken = spring_potential(g.k, g.x_1 + g.d) - spring_potential(g.k, g.x_1)
    return summed({"cable": g.F * (start - end), "spring": -taken})


def speed(g, U):
    return {"v_B": speed_after(0, U, g.m)}


def solve(g):
    return speed(g, work(g))


def steps(g):
    (start, _), U = cable(g), work(g).terms
    return {"l_AC": start, "U_c": U["cable"], "x_2": g.x_1 + g.d, "U_s": U["spring"]}


def prove(g):
    """The motion over time, from the forces along the rail, with their work."""
    C = [g.d, g.h]

    def rates(state):
        x, v, *_ = state
        to_C = minus(C, [x, 0])
        pull, back = g.F * to_C[0] / size(to_C), -g.k * (g.x_1 + x)
        return [v, (pull + back) / g.m, pull * v, back * v]

    _, (x, v, U_c, U_s) = until(rates, [0 * g.d] * 4, lambda s: s[0] - g.d, 0.1 * g.d / g.d)
    return {"v_B": v, "l_AC": size(C), "x_2": g.x_1 + x, "U_c": U_c, "U_s": U_s}


def mistakes(g):
    right, (start, _) = work(g), cable(g)
    horizontal = summed({**right.terms, "cable": g.F * g.d})
    constant = summed({**right.terms, "cable": g.F * g.d * g.d / start})
    unstretched = summed({**right.terms, "spring": -spring_potential(g.k, g.d)})
    return {
        "horizontal_cable": speed(g, horizontal),
        "unstretched_at_A": speed(g, unstretched),
        "constant_direction": speed(g, constant),
        "spring_drives": speed(g, right.reweighted(spring=-1)),
    }


def draw(g, ax):
    ground, A, B, C = scene(g)
    s = Sketch(ax, ground, plane="xy")
    size, wall = 0.12 * g.d, -0.5 * g.d
    s.road([(wall, -size / 2, 0), (1.3 * g.d, -size / 2, 0)])
    s.ground((wall, 0, 0), ground.i, size=0.3 * g.d)
    s.spring((wall, 0, 0), (-size / 2, 0, 0))
    end, along = (1.3 * g.d, 1.12 * g.h, 0), (0.3 * g.d, 0.08 * g.h, 0)
    s.cable(A, s.pulley(C, ground.k, 0.04 * g.d), end)
    s.box(A, ground, (size, size, size))
    s.vector(end, along, "F", kind="force")
    s.line(B, C, style="centre")
    s.dimension(A, B, label="d", offset=-0.2 * g.d)
    s.dimension(B, C, label="h", offset=-0.15 * g.d)
    s.label(A, "A", offset=(0, 16))
    s.dot(B, "B", offset=(-12, 8))
    s.label(C, "C", offset=(0, 14))
    s.label((wall / 2, 0, 0), "k", offset=(0, 14), bold=False)
