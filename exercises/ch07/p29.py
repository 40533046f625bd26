"""7/29: the length of a spacecraft with two panels for a stable spin."""

from exercises.tools import Sketch, mp, proofs
from newton_euler import Frame, composite, root, sqrt
from newton_euler.bodies import cylinder, cylindrical_shell, plate

CRAFT = Frame("craft")


def parts(g, l_r, shell_mass=None, panel_mass=None):
    """The shell and two panels, for unit radius and unit mass per area, or with these masses."""
    matter = lambda mass: {"density": g.one} if mass is None else {"mass": mass}
    shell = cylindrical_shell(g.one, l_r, CRAFT, "x", **matter(shell_mass))
    middle = g.one + g.c / 2
    panels = [
        plate(g.q * l_r, g.c, CRAFT.point(name, 0, y, 0), "z", name=name, **matter(panel_mass))
        for name, y in (("left", -middle), ("right", middle))
    ]
    return shell, panels


def excess(bodies):
    """I_yy - I_xx."""
    I = composite("craft", bodies).about(CRAFT)
    return I.moment("y") - I.moment("x")


def solve(g):
    """I_yy = I_xx, where I_yy is 1/2 plus a multiple of (l/r)^2."""
    *_, I_x, slope = steps(g).values()
    return {"l_r": sqrt((I_x - g.one / 2) / slope)}


def steps(g):
    shell, (panel, _) = parts(g, g.one)
    share = panel.mass / shell.mass
    k2 = panel.about(CRAFT).moment("x") / panel.mass
    I_x, slope = 1 + 2 * share * k2, (1 + 2 * share * g.q**2) / 12
    return {"share": share, "panel_x": k2, "I_x": I_x, "slope": slope}


def prove(g):
    """By mass points on the shell and the panels, of unit length, then stretched."""

    def points(body, along):
        for share, place in body:
            for w, (x, _, _) in along:
                yield share * w, [x, *place]

    along = proofs.box(1, 0, 0, order=2)
    round_x = [(w, [y, z]) for w, (y, z, _) in proofs.ring(1, order=2)]
    across = [(w, [1 + g.c / 2 + y, 0]) for w, (y, _, _) in proofs.box(g.c, 0, 0, order=2)]
    shell, panel = (list(points(body, along)) for body in (round_x, across))
    means = lambda body: proofs.mean(lambda p: [p[0] ** 2, p[1] ** 2, p[2] ** 2], body)
    (xx, yy, zz), (XX, YY, ZZ) = means(shell), means(panel)
    m, M = 2 * mp.pi, 2 * g.c * g.q  # shell, both panels
    x2 = m * xx + M * XX * g.q**2
    lacking = lambda l_r: m * zz + M * ZZ + x2 * l_r**2 - m * (yy + zz) - M * (YY + ZZ)
    return {
        "l_r": proofs.root(lacking, 0, 100),
        "share": M / 2 / m,
        "panel_x": YY + ZZ,
        "I_x": yy + zz + M / m * (YY + ZZ),
        "slope": x2 / m,
    }


def mistakes(g):
    def no_transfer(l_r):
        shell, panels = parts(g, l_r)
        transfers = (part.about(CRAFT).moment("x") - part.inertia.moment("x") for part in panels)
        return excess([shell, *panels]) + sum(transfers)

    def solid(l_r):
        shell, panels = parts(g, l_r)
        return excess([cylinder(g.one, l_r, CRAFT, "x", mass=shell.mass), *panels])

    def equal_masses(l_r):
        shell, panels = parts(g, l_r, g.one, g.one)
        return excess([shell, *panels])

    models = {
        "no_transfer": no_transfer,
        "solid": solid,
        "equal_masses": equal_masses,
        "no_panels": lambda l_r: excess([parts(g, l_r)[0]]),
    }
    return {n: {"l_r": root(of, g.one / 10, 100 * g.one)} for n, of in models.items()}


def draw(g, ax):
    l = 2.2  # l/r, not that of the answer
    s = Sketch(ax, CRAFT, azimuth=-60, elevation=30)
    ends, half = ((-l / 2, 0, 0), (l / 2, 0, 0)), g.q * l / 2
    for y in (1, -1):
        edge = y * (1 + g.c)
        s.plate([(-half, y, 0), (half, y, 0), (half, edge, 0), (-half, edge, 0)])
    s.cylinder(*ends, 1, bore=0.97)
    s.arrow(ends[1], (l / 2 + 1.4, 0, 0), "x")
    s.arrow(ends[1], (l / 2, -0.6, 0.8), "r")
    s.arrow((0, 1 + g.c, 0), (0, 1.8 + g.c, 0), "y")
    s.dimension((half, 1, 0), (half, 1 + g.c, 0), label="$c\\,r$")
    s.dimension((-l / 2, 0, 1), (l / 2, 0, 1), label="l", offset=0.2)
    s.dimension((-half, -1 - g.c, 0), (half, -1 - g.c, 0), label="$q\\,l$")
