"""A/13: the projection of a vector on another, and the foot of a perpendicular."""

from exercises.tools import Sketch, minus, plus, proofs, scaled
from newton_euler import Frame

AXES = Frame("axes")


def vectors(g):
    return AXES.vector(g.A_x, g.A_y, g.A_z), AXES.vector(g.B_x, g.B_y, g.B_z)


def projected(B, A):
    """B onto A."""
    e = A.direction()
    return B.dot(e) * e


def solve(g):
    A, B = vectors(g)
    return {"proj": projected(B, A)}


def steps(g):
    A, B = vectors(g)
    e = A.direction()
    return {"size_A": A.norm(), "e_A": e, "B_e": B.dot(e)}


def prove(g):
    """The foot s A is equally far from the tips of B + A and B - A."""
    A, B = [g.A_x, g.A_y, g.A_z], [g.B_x, g.B_y, g.B_z]

    def gap(s):
        ahead, behind = (minus(scaled(s, A), tip) for tip in (plus(B, A), minus(B, A)))
        return sum(x * x - y * y for x, y in zip(ahead, behind, strict=True))

    return {"proj": scaled(proofs.root(gap, -100, 100), A)}


def mistakes(g):
    A, B = vectors(g)
    right = projected(B, A)
    return {
        "size_once": {"proj": right * A.norm()},
        "A_onto_B": {"proj": projected(A, B)},
        "perpendicular": {"proj": B - right},
    }


def draw(g, ax):
    """Seen at right angles to the plane of A and B, A rising a little to the right."""
    A, B = vectors(g)
    s = Sketch(ax, AXES, plane="xy")
    sheet = AXES.rotate("sheet", "z", angle=0.3)
    along, away = B.dot(A) / A.norm(), A.cross(B).norm() / A.norm()
    at = lambda x, y=0: sheet.vector(x, y, 0).components(AXES)
    O, a, b, foot = at(0), at(A.norm()), at(along, away), at(along)
    ends = at(min(0, along) - 0.3 * A.norm()), at(max(A.norm(), along) + 0.3 * A.norm())
    s.line(*ends, style="centre")
    s.line(b, foot)
    s.arrow(O, a)
    s.arrow(O, b)
    s.label(a, "A", offset=(0, -14))
    s.label(b, "B")
