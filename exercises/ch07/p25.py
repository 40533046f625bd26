"""7/25: a tube about a line in its outer surface."""

from exercises.tools import Sketch, mp, proofs
from newton_euler import Frame
from newton_euler.bodies import cylinder, tube

TUBE = Frame("tube")  # its origin is the centre of mass


def body(g):
    return tube(g.ri, g.ro, g.lc, TUBE, "x", density=g.rho)


def about(part, below):
    """The moment about a parallel to the axis, this far below it."""
    return part.about(TUBE.point("P", 0, 0, -below)).moment("x")


def solve(g):
    return {"I_xx": about(body(g), g.ro)}


def steps(g):
    part = body(g)
    return {"m": part.mass, "own": part.inertia.moment("x"), "transfer": part.mass * g.ro**2}


def prove(g):
    """By thin tubes about the axis, with the mean square distance from the line for each."""
    # the ring is about z: its x is the height here
    squares = lambda p: [(p[0] + g.ro) ** 2 + p[1] ** 2, 1, p[0] ** 2 + p[1] ** 2]
    mass = lambda r: 2 * mp.pi * r * g.rho * g.lc
    thin = lambda r: proofs.scaled(mass(r), proofs.mean(squares, proofs.ring(r, order=2)))
    I_xx, m, own = proofs.integral(thin, g.ri, g.ro)
    return {"I_xx": I_xx, "m": m, "own": own}


def mistakes(g):
    part = body(g)
    return {
        "inner_radius": {"I_xx": about(part, g.ri)},
        "wall": {"I_xx": about(part, g.ro - g.ri)},
        "no_hole": {"I_xx": about(cylinder(g.ro, g.lc, TUBE, "x", density=g.rho), g.ro)},
        "no_transfer": {"I_xx": part.inertia.moment("x")},
        "inches": solve(g.but(ro=12 * g.ro, ri=12 * g.ri, lc=12 * g.lc)),  # 12 in = 1 ft
    }


def draw(g, ax):
    s = Sketch(ax, TUBE, azimuth=-60, elevation=20)
    left, right = (-g.lc / 2, 0, 0), (g.lc / 2, 0, 0)
    s.cylinder(left, right, g.ro, bore=g.ri)
    s.line((-0.5 * g.lc - 0.5 * g.ro, 0, -g.ro), (0.5 * g.lc, 0, -g.ro), style="centre")
    s.arrow((0.5 * g.lc, 0, -g.ro), (0.5 * g.lc + 1.2 * g.ro, 0, -g.ro), "x")
    s.arrow(right, (g.lc / 2, 0.6 * g.ro, 0.8 * g.ro), "$r_o$")
    s.arrow(right, (g.lc / 2, -0.8 * g.ri, 0.6 * g.ri), "$r_i$")
    s.dimension((-g.lc / 2, 0, g.ro), (g.lc / 2, 0, g.ro), label="$l_c$", offset=0.2 * g.ro)
