"""5/8: the centre of mass of a hemispherical shell."""

from mpmath import mp

from exercises import proofs
from exercises.steps import Step
from newton_euler import Frame, cos, integral, pi, sin
from newton_euler.bodies import half_ring, hemisphere
from newton_euler.drawing import Sketch

SHELL = Frame("shell")


def moments(g, width=lambda g, phi: g.R):
    """Area and first moment, by rings at the angle phi from z; ``width`` per dphi."""

    def rings(f):
        def ring(phi):
            return f(phi) * (2 * pi(g.one) * (g.R * sin(phi)) * width(g, phi))

        return integral(ring, 0, pi(g.one) / 2)

    return rings(lambda phi: g.one), rings(lambda phi: g.R * cos(phi))


def centre(area, first_z):
    return {"d": SHELL.vector(0, 0, first_z / area)}


def solve(g):
    return centre(*moments(g))


def steps(g):
    area, first_z = moments(g)
    yield Step("area", area, "m^2",
               "area, by rings of radius R sin(phi) and width R d(phi) at the angle phi from z",
               "5.4")  # fmt: skip
    yield Step("Q_z", first_z, "m^3", "integral of z dA, with z = R cos(phi)", "5.4", "5.13")


def prove(g):
    """By the shadow of the shell on the plane of its rim: on the circle of radius s the shell is
    steeper than that plane by the factor R/z.
    """

    def shadow(s):
        z = mp.sqrt(g.R**2 - s**2)
        dA = 2 * mp.pi * s * g.R / z
        return [dA, z * dA]

    area, first_z = proofs.integral(shadow, 0, g.R)
    return {"d": [0, 0, first_z / area], "area": area, "Q_z": first_z}


def mistakes(g):
    return {
        "solid": {"d": hemisphere(g.R, SHELL, "z", density=1).centre.position(SHELL)},
        "dz_as_width": centre(*moments(g, width=lambda g, phi: g.R * sin(phi))),
        "wire": {"d": half_ring(g.R, SHELL, "x", "z", density=1).centre.position(SHELL)},
    }


def draw(g, ax):
    s = Sketch(ax, SHELL, azimuth=-60, elevation=20)
    O, end = (0, 0, 0), (-0.6 * g.R, -0.8 * g.R, 0)
    s.hemisphere(O, SHELL.k, g.R, open=True)
    for phi in (0.75, 0.82):
        # a little outside, so that it is seen
        s.ring((0, 0, g.R * cos(phi)), SHELL.k, 1.01 * g.R * sin(phi))
    s.axes(O, SHELL, length=1.5 * g.R)
    s.dimension(O, end, label="R", offset=0)
    s.label(O, "O")
