"""5/6: the centre of mass of half a disk by integration."""

from mpmath import mp

from exercises import proofs
from exercises.steps import Step
from newton_euler import Frame, integral, pi, sin
from newton_euler.drawing import Sketch

DISK = Frame("disk")


def moments(g, element=lambda r: r):
    """Area and first moment in polar coordinates: integrals over r, times those over theta;
    ``element`` is the area per dr dtheta.
    """
    over_r = integral(lambda r: (element(r), r * element(r)), 0, g.R)
    over_theta = integral(lambda theta: (g.one, sin(theta)), 0, pi(g.one))
    return over_r[0] * over_theta[0], over_r[1] * over_theta[1]


def centre(area, first_y):
    return {"d": DISK.vector(0, first_y / area, 0)}


def solve(g):
    return centre(*moments(g))


def steps(g):
    area, first_y = moments(g)
    yield Step("area", area, "m^2", "area of the half disk, the integral of r dr d(theta)", "5.4")
    yield Step("Q_y", first_y, "m^3", "integral of r sin(theta) r dr d(theta)", "5.4", "5.13")


def prove(g):
    """By strips along y, which end at the circle."""

    def strip(x):
        top = mp.sqrt(g.R**2 - x**2)
        return [top, top**2 / 2]

    area, first_y = proofs.integral(strip, -g.R, g.R)
    return {"d": [0, first_y / area, 0], "area": area, "Q_y": first_y}


def mistakes(g):
    return {
        "wire": {"d": DISK.vector(0, 2 * g.R / pi(g.one), 0)},
        "half_radius": {"d": DISK.vector(0, g.R / 2, 0)},
        "no_factor_r": centre(*moments(g, element=lambda r: g.one)),
    }


def draw(g, ax):
    s = Sketch(ax, DISK, plane="xy")
    O, end = (0, 0, 0), (g.R, 0, 0)
    s.axes(O, DISK, length=1.35 * g.R, labels=["x", "y", ""])
    s.plate(s.around(O, end, DISK.k, 3.14159265))
    s.dimension(O, end, label="R")
    s.label(O, "O")
