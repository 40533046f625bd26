"""A/17: the derivative of a cross product, of vectors whose components are moving numbers."""

from exercises.tools import proofs
from newton_euler import Frame, moving

AXES = Frame("axes")


def vectors(g):
    """w and R; t runs at the rate 1."""
    t = moving(g.t, rate=g.one)
    return AXES.vector(t, t**2, g.c), AXES.vector(g.d * t, t**2, t**3)


def solve(g):
    w, R = vectors(g)
    return {"dudt": w.cross(R).rate(AXES)}


def parts(g):
    """dw/dt x R and w x dR/dt."""
    w, R = vectors(g)
    return w.rate(AXES).cross(R), w.cross(R.rate(AXES))


def steps(g):
    w, R = vectors(g)
    part_w, part_R = parts(g)
    return {"w_dot": w.rate(AXES), "R_dot": R.rate(AXES), "part_w": part_w, "part_R": part_R}


def prove(g):
    """By the product rule, from w and R differentiated by hand."""
    t = g.t
    dw, dR = [1, 2 * t, 0], [g.d, 2 * t, 3 * t**2]
    part_w = proofs.cross(dw, [g.d * t, t**2, t**3])
    part_R = proofs.cross([t, t**2, g.c], dR)
    dudt = proofs.plus(part_w, part_R)
    return {"dudt": dudt, "w_dot": dw, "R_dot": dR, "part_w": part_w, "part_R": part_R}


def mistakes(g):
    w, R = vectors(g)
    part_w, part_R = parts(g)
    return {
        "product_of_derivatives": {"dudt": w.rate(AXES).cross(R.rate(AXES))},
        "no_dw": {"dudt": part_R},
        "no_dR": {"dudt": part_w},
        "order": {"dudt": part_w - part_R},
    }
