"""7/17: the moments of inertia of a flat ring."""

from exercises.tools import Sketch, proofs
from newton_euler import Frame, composite
from newton_euler.bodies import annulus, disk, ring

PLATE = Frame("plate")
follows = {"I_yy": lambda g, I_xx: I_xx, "I_zz": lambda g, I_xx, I_yy: I_xx + I_yy}


def of(body):
    normal = body.inertia.moment("z")
    return {"I_xx": normal / 2, "I_yy": normal / 2, "I_zz": normal}


def sheet(g):
    """The mass per area."""
    return g.m / annulus(g.r1, g.r2, PLATE, "z", density=1).mass


def full(g, r):
    return disk(r, PLATE, "z", density=sheet(g))


def solve(g):
    return of(composite("ring", [full(g, g.r2)], removed=[full(g, g.r1)]))


def steps(g):
    moment = lambda r: full(g, r).inertia.moment("z")
    return {"sigma": sheet(g), "J_2": moment(g.r2), "J_1": moment(g.r1)}


# all diameters are equal; for a plate the moment about the normal is the sum of the two in it
def prove(g):
    """Thin rings, each with the share 2 u du/(r2^2 - r1^2) of the mass."""
    squares = lambda p: [p[1] ** 2, p[0] ** 2, p[0] ** 2 + p[1] ** 2]
    ring_of = lambda u: proofs.scaled(2 * u, proofs.mean(squares, proofs.ring(u, order=2)))
    share = g.m / (g.r2**2 - g.r1**2)
    I_xx, I_yy, I_zz = proofs.scaled(share, proofs.integral(ring_of, g.r1, g.r2))
    return {"I_xx": I_xx, "I_yy": I_yy, "I_zz": I_zz}


def mistakes(g):
    I_zz = solve(g)["I_zz"]
    outer, inner = (of(disk(r, PLATE, "z", mass=g.m)) for r in (g.r2, g.r1))
    return {
        "equal_disks": {key: outer[key] - inner[key] for key in outer},
        "normal_for_diameter": {"I_xx": I_zz, "I_yy": I_zz},
        "mean_radius": of(ring((g.r1 + g.r2) / 2, PLATE, "z", mass=g.m)),
    }


def draw(g, ax):
    s = Sketch(ax, PLATE, plane="xy")
    O = (0, 0, 0)
    s.plate(s.around(O, (g.r2, 0, 0), PLATE.k), [s.around(O, (g.r1, 0, 0), PLATE.k)])
    s.axes(O, PLATE, length=1.35 * g.r2, labels=["x", "y", ""])
    s.arrow(O, (-0.6 * g.r1, -0.8 * g.r1, 0), "$r_1$")
    s.arrow(O, (-0.8 * g.r2, 0.6 * g.r2, 0), "$r_2$")
