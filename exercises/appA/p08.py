"""A/8: the derivatives of a unit vector that turns: velocity and acceleration of its tip."""

from exercises.tools import Sketch, at_angle, in_frame, mp, rate, second_rate
from newton_euler import Frame, cos, moving, sin

follows = {"f": lambda g, eddot: eddot.dot(eddot.frame.vector(cos(g.theta), sin(g.theta), 0))}


def turning(g):
    """The fixed axes, a frame whose first axis is e, and the tip of e."""
    axes = Frame("axes")
    turned = axes.rotate("turned", "z", angle=moving(g.theta, rate=g.omega))
    return axes, turned, turned.point("tip", 1, 0, 0)


def solve(g):
    axes, turned, tip = turning(g)
    first, second = tip.velocity(axes), tip.acceleration(axes)
    return in_frame(axes, {"edot": first, "eddot": second}) | {"f": second.dot(turned.i)}


def steps(g):
    axes, turned, tip = turning(g)
    e_theta = turned.j.expressed_in(axes)
    return {"e_theta": e_theta, "transverse": tip.velocity(axes).dot(turned.j)}


def prove(g):
    """Components differentiated; f from e.e = 1, whose second derivative is e.e'' + e'.e' = 0."""
    e = lambda t: at_angle(1, g.theta + g.omega * t)
    first = rate(e)
    square = sum(x * x for x in first)
    return {"edot": first, "eddot": second_rate(e), "f": -square, "transverse": mp.sqrt(square)}


def mistakes(g):
    edot, eddot, f = solve(g).values()
    once = g.omega**2 - g.omega  # unlike quantities, as in the student's mistake
    return {
        "no_change": {"edot": 0 * edot, "eddot": 0 * eddot, "f": 0 * f},
        "no_chain_rule": solve(g.but(omega=g.omega / g.omega)),
        "chain_rule_once": {"eddot": eddot - once / g.omega**2 * eddot, "f": f + once},
        "plus": {"eddot": -eddot, "f": -f},
    }


def draw(g, ax):
    axes, _, tip = turning(g)
    s = Sketch(ax, axes, plane="xy")
    O, e = (0, 0, 0), tip.position(axes).components(axes)
    s.axes(O, axes, length=1, labels=["i", "j", ""])
    s.arrow(O, e)
    s.label(e, "e")
    s.arc(O, axes.i, e, label=r"$\theta$")
    s.swing(O, e, axes.k, r"$\omega$")
