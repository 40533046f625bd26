"""7/18: the moments of inertia of a triangular plate."""

from exercises.tools import Sketch, proofs
from newton_euler import Frame, integral
from newton_euler.bodies import plate

PLATE = Frame("plate")  # its origin is the centre of mass
follows = {"I_zz": lambda g, I_xx, I_yy: I_xx + I_yy}


def about_base(g):
    """By strips of the mass 2 m (1 - u/h) du/h at the height u above the base."""
    return integral(lambda u: 2 * g.m / g.h * (1 - u / g.h) * u**2, 0, g.h)


def solve(g):
    """I_yy by the same strips, of width b (1 - u/h)."""
    I_xx = about_base(g) - g.m * (g.h / 3) ** 2
    I_yy = integral(lambda u: g.m / g.h * (1 - u / g.h) * (g.b * (1 - u / g.h)) ** 2 / 6, 0, g.h)
    return {"I_xx": I_xx, "I_yy": I_yy, "I_zz": I_xx + I_yy}


def steps(g):
    return {"d": g.h / 3, "I_b": about_base(g), "transfer": g.m * (g.h / 3) ** 2}


# a plate: the moment about the normal is the sum of the two in it
def prove(g):
    """A square plate and its mass, mapped to the triangle by narrowing it upward."""

    def pressed(share, place):
        x, up = place[0], (place[1] + 1) / 2  # from 0 to 1
        return 2 * share * (1 - up), (g.b * x * (1 - up) / 2, g.h * up)

    points = [pressed(*point) for point in proofs.box(2, 2, 0)]
    G = proofs.mean(lambda p: p[1], points)
    moment = lambda f: g.m * proofs.mean(lambda p: f(p[0], p[1]), points)
    return {
        "I_xx": moment(lambda x, y: (y - G) ** 2),
        "I_yy": moment(lambda x, y: x**2),
        "I_zz": moment(lambda x, y: x**2 + (y - G) ** 2),
        "d": G,
        "I_b": moment(lambda x, y: y**2),
    }


def mistakes(g):
    right, at_base = solve(g), about_base(g)
    with_xx = lambda I_xx: {"I_xx": I_xx, "I_zz": I_xx + right["I_yy"]}
    I_yy = plate(g.b, g.h, PLATE, "z", mass=g.m).inertia.moment("y")
    return {
        "about_the_base": with_xx(at_base),
        "about_the_apex": with_xx(right["I_xx"] + g.m * (2 * g.h / 3) ** 2),
        "rectangle": {"I_yy": I_yy, "I_zz": right["I_xx"] + I_yy},
        "adds_the_transfer": with_xx(2 * at_base - right["I_xx"]),
    }


def draw(g, ax):
    s = Sketch(ax, PLATE, plane="xy")
    A, B = (-g.b / 2, -g.h / 3, 0), (g.b / 2, -g.h / 3, 0)
    s.plate([A, B, (0, 2 * g.h / 3, 0)])
    s.axes((0, 0, 0), PLATE, length=0.45 * max(g.b, g.h), labels=["x", "y", ""])
    s.dimension(A, B, label="b", offset=-0.1 * max(g.b, g.h))
    s.dimension((g.b / 2, 2 * g.h / 3, 0), (g.b / 2, -g.h / 3, 0), label="h")
    s.label((0, 0, 0), "G", offset=(-12, -10))
