"""7/28: the cone that has the same moment of inertia about all axes through its centre of mass."""

from exercises.tools import Sketch, mp, proofs
from newton_euler import Frame, bodies, root, tan

CONE = Frame("cone")  # its origin is the apex, z points to the base


def of_height_1(g, radius):
    return bodies.cone(radius, g.one, CONE, "z", mass=g.one)


def angle(g, excess):
    """The alpha at which ``excess``, a function of the cone, vanishes."""
    return root(lambda a: excess(of_height_1(g, tan(a))), g.one / 10, 14 * g.one / 10)


def difference(body):
    I = body.inertia
    return I.moment("z") - I.moment("x")


def solve(g):
    return {"alpha": angle(g, difference)}


def steps(g):
    body = of_height_1(g, g.one)  # as wide as high
    own = body.inertia.moment("z")
    tall = body.inertia.moment("x") - own / 2
    return {"d": body.centre.position(CONE).z, "own": own, "tall": tall}


def prove(g):
    """Disks that grow from the apex; a wider cone is the same one, stretched across."""
    body = [
        (3 * up**2 * share * w, [y * up, up])
        for share, (x, _, _) in proofs.box(2, 0, 0, order=3)
        for up in [(x + 1) / 2]
        for w, (y, _, _) in proofs.disk(mp.mpf(1), order=2)
    ]
    d = proofs.mean(lambda p: p[1], body)
    across, along = proofs.mean(lambda p: [p[0] ** 2, (p[1] - d) ** 2], body)
    radius = proofs.root(lambda r: 2 * across * r**2 - (across * r**2 + along), mp.mpf(1) / 10, 5)
    return {"alpha": mp.atan2(radius, 1), "d": d, "own": 2 * across, "tall": along}


def mistakes(g):
    at_apex = lambda body: body.inertia.moment("z") - body.about(CONE).moment("x")
    wrong_centre = lambda body: at_apex(body) + body.mass * (body.centre.position(CONE).z / 3) ** 2
    return {
        "at_the_apex": {"alpha": angle(g, at_apex)},
        "full_angle": {"alpha": 2 * solve(g)["alpha"]},
        "quarter_from_the_apex": {"alpha": angle(g, wrong_centre)},
    }


def draw(g, ax):
    s = Sketch(ax, CONE, plane="xz")
    r, h = 0.36, 1  # not of the asked shape
    apex, left, right = (0, 0, 0), (-r, 0, -h), (r, 0, -h)
    s.plate([apex, left, right])
    s.line((0, 0, 0.25), (0, 0, -1.2), style="centre")
    s.line((-0.6, 0, -0.75), (0.6, 0, -0.75), style="centre")
    s.arc(apex, (0, 0, -h), right, label=r"$\alpha$")
    s.label((0, 0, 0.25), "A", offset=(9, -4))
    s.label((0, 0, -1.2), "A'", offset=(9, 4))
    s.label((-0.6, 0, -0.75), "B", offset=(0, 9))
    s.label((0.6, 0, -0.75), "B'", offset=(0, 9))
