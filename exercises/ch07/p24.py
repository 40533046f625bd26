"""7/24: the moments of inertia of a wedge of a cylinder."""

from exercises.tools import Sketch, mp, proofs
from newton_euler import Frame, cos, pi, sin
from newton_euler.bodies import arc, wedge

WEDGE = Frame("wedge")  # its origin is on the axis OO', x toward the centre of mass, z along OO'
follows = {"I_GG": lambda g, I_OO: less(g, I_OO, distance(g, full(g)))}


def full(g):
    """The wedge without its hole, a copy scaled by q with q^2 of the mass."""
    # the thickness, along both axes, has no influence
    return wedge(g.r, g.psi / 2, g.r, WEDGE, "z", "x", mass=g.m / (1 - g.q**2))


def distance(g, part):
    """The distance from OO' to GG', for the wedge ``part`` without its hole."""
    return part.centre.position(WEDGE).x * (1 - g.q**3) / (1 - g.q**2)


def solve(g):
    part = full(g)
    I_OO = part.about(WEDGE).moment("z") * (1 - g.q**4)
    return {"I_OO": I_OO, "I_GG": less(g, I_OO, distance(g, part))}


def steps(g):
    d = distance(g, full(g))
    return {"m_full": full(g).mass, "d": d, "transfer": g.m * d**2}


def prove(g):
    """By radial slivers, with mass proportional to the distance from OO'."""
    across = [(share, (x + 1) / 2) for share, (x, _, _) in proofs.box(2, 0, 0, order=2)]
    radii = [(share, g.q + (1 - g.q) * x) for share, x in across]
    sliver = [(2 * share * u / (1 + g.q), g.r * u) for share, u in radii]

    def total(f):
        def at(angle):
            c, s = mp.cos(angle), mp.sin(angle)
            return sum(share * f(u * c, u * s) for share, u in sliver)

        return proofs.integral(at, -g.psi / 2, g.psi / 2) / g.psi

    d = total(lambda x, y: x)
    return {
        "I_OO": g.m * total(lambda x, y: x**2 + y**2),
        "I_GG": g.m * total(lambda x, y: (x - d) ** 2 + y**2),
        "d": d,
    }


def less(g, I_OO, d):
    return I_OO - g.m * d**2


def mistakes(g):
    right, d = solve(g)["I_OO"], distance(g, full(g))
    rim = arc(g.r, g.psi / 2, WEDGE, "z", "x", mass=g.m)
    scaled = right * g.psi / (2 * pi(g.psi))
    return {
        "scaled": {"I_OO": scaled, "I_GG": less(g, scaled, d)},
        "adds_the_transfer": {"I_GG": 2 * right - less(g, right, d)},
        "no_hole": solve(g.but(q=0 * g.q)),
        "arc": {"I_GG": less(g, right, rim.centre.position(WEDGE).x)},
        "thin": {"I_GG": less(g, right, 2 * g.r / 3)},
    }


def draw(g, ax):
    s = Sketch(ax, WEDGE, azimuth=-65, elevation=25)
    thick, d = 0.35 * g.r, distance(g, full(g))
    start = (g.r * cos(g.psi / 2), -g.r * sin(g.psi / 2), 0)
    rim = s.around((0, 0, 0), start, WEDGE.k, g.psi)
    hole = [tuple(g.q * x for x in P) for P in reversed(rim)]
    s.plate([*hole, *rim], thickness=thick)
    for name, x in ("O", 0), ("G", d):
        low, high = (x, 0, -0.8 * g.r), (x, 0, 1.05 * g.r)
        s.line(low, high, style="centre")
        s.label(high, name, offset=(9, 0))
        s.label(low, f"{name}'", offset=(9, 0))
    top = (0, 0, thick / 2)
    s.arc(top, start, rim[-1], label=r"$\psi$")
    x, y, _ = rim[-1]
    s.dimension(top, (x, y, thick / 2), label="r", offset=0.1 * g.r)
