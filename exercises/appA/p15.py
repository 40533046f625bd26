"""A/15: the handedness of three vectors, a word that a function returns."""

from exercises.tools import Sketch, mp
from newton_euler import Frame

follows = {"right_handed": lambda g, triple: answers(triple)["right_handed"]}


def vectors(g):
    axes = Frame("axes")
    A = axes.vector(g.A_1, g.A_2, g.A_3)
    return axes, A, axes.vector(g.B_1, g.B_2, g.B_3), axes.vector(g.G_1, g.G_2, g.G_3)


def answers(triple):
    return {"triple": triple, "right_handed": lambda: "yes" if triple > 0 else "no"}


def solve(g):
    _, A, B, G = vectors(g)
    return answers(A.dot(B.cross(G)))


def steps(g):
    _, _, B, G = vectors(g)
    return {"w": B.cross(G)}


def prove(g):
    rows = [[g.A_1, g.A_2, g.A_3], [g.B_1, g.B_2, g.B_3], [g.G_1, g.G_2, g.G_3]]
    return answers(mp.det(mp.matrix(rows)))


def mistakes(g):
    _, A, B, G = vectors(g)
    (a, b, c), (x, y, z) = A.components(), B.cross(G).components()
    middle = a * x - b * y + c * z
    return {"G_x_B": answers(A.dot(G.cross(B))), "plus_in_the_middle": {"triple": middle}}


def draw(g, ax):
    axes, A, B, G = vectors(g)
    s = Sketch(ax, axes, azimuth=35, elevation=22)
    s.axes((0, 0, 0), axes, length=1.5, labels=["i", "j", "k"])
    for name, v in zip("ABG", (A, B, G), strict=True):
        s.arrow((0, 0, 0), v.components())
        s.label(v.components(), name)
