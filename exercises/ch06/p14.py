"""6/14: a sphere on two wires, before and just after one of them is cut."""

from exercises.tools import Sketch, minus, mp, mpf, rate, second_rate, size
from newton_euler import Frame, pi, sin, solve_linear


def wires(g):
    """Axes with x to the right and z up; frames with x along the wires, from the sphere upward."""
    axes = Frame("x, y, z")
    AB = axes.rotate("wire AB", "y", g.psi - pi(g.psi))
    return axes, AB, axes.rotate("wire CD", "-y", g.alpha)


def before(g):
    """Equilibrium under both wires and the weight."""
    axes, AB, CD = wires(g)
    return solve_linear(lambda T_AB, T_CD: T_AB * AB.i + T_CD * CD.i - g.W * axes.k)


def after(g):
    """Newton's second law for the sphere, whose acceleration is eta g across CD."""
    axes, _, CD = wires(g)
    return solve_linear(lambda T_CD, eta: T_CD * CD.i - g.W * axes.k - g.W * eta * CD.k)


def solve(g):
    return {"T_before": before(g).T_CD, "T_after": after(g).T_CD}


def steps(g):
    return {"T_AB": before(g).T_AB}


def prove(g):
    """Virtual work before; after, the motion that conserves energy; unit wire length and g."""
    C = [mp.cos(g.alpha), 0, mp.sin(g.alpha)]
    with_AB = lambda u: [mp.cos(g.psi + u) - mp.cos(g.psi), 0, mp.sin(g.psi) - mp.sin(g.psi + u)]
    with_CD = lambda u: minus(C, [mp.cos(g.alpha + u), 0, mp.sin(g.alpha + u)])
    height, second = rate(with_AB)[2], -rate(with_CD)[2]
    a = second_rate(lambda t: with_CD(second * t**2 / 2))
    return {
        "T_before": -g.W * height / rate(lambda u: size(minus(with_AB(u), C))),
        "T_after": g.W * size(minus(a, [0, 0, -mpf(1)])),
    }


def mistakes(g):
    quarter = pi(g.psi) / 2
    return {
        "vertical_balance": {"T_after": g.W / sin(g.alpha)},
        "as_before": {"T_after": solve(g)["T_before"]},
        "from_the_vertical": solve(g.but(psi=quarter - g.psi, alpha=quarter - g.alpha)),
        "other_wire": {"T_before": before(g).T_AB},
    }


def draw(g, ax):
    axes, AB, CD = wires(g)
    s = Sketch(ax, axes, plane="xz")
    O, high = (0, 0, 0), 1.0
    A = (AB.i * (high / sin(g.psi))).components(axes)
    C = (CD.i * (high / sin(g.alpha))).components(axes)
    s.road([(C[0] + 0.3, 0, high), (A[0] - 0.3, 0, high)])
    for end, side in ((A, -0.7), (C, 0.7)):
        s.line(O, (side, 0, 0))
        s.line(O, end, style="solid")
        s.hinge(end)
    s.sphere(O, 0.08)
    s.arc(O, -axes.i, A, label=r"$\psi$")
    s.arc(O, axes.i, C, label=r"$\alpha$")
    s.vector(O, -axes.k, "W", kind="force")
    s.label(A, "A", offset=(-14, -12))
    s.label(C, "C", offset=(14, -12))
    s.label((-0.06, 0, -0.06), "B", offset=(-10, -8))
    s.label((0.06, 0, -0.06), "D", offset=(10, -8))
