"""10/13: the moment of a rotor in a turning bracket on the shaft below it."""

from exercises.tools import Sketch, cross, in_frame, minus, moment_needed, proofs, rot, times
from newton_euler import Frame, bodies, dynamics
from newton_euler.applications import normal_moment


def rotor(g):
    """Ground with z up, the bracket with origin G, and the cylinder, of arbitrary length."""
    ground = Frame("ground")
    bracket = ground.rotate("bracket", "z", rate=g.Omega)
    spinning = bracket.rotate("cylinder", "x", rate=g.P)
    mass = dynamics.mass_from_weight(g.W, g.g)
    return ground, bracket, bodies.cylinder(g.r, 3 * g.r, spinning, "x", mass=mass)


def on_the_rotor(g, share=1):
    """The moment that the cylinder needs (10.38), with this share of its moment of inertia."""
    ground, bracket, body = rotor(g)
    I = share * body.inertia.moment("x")
    spin = body.frame.angular_velocity(bracket).expressed_in(bracket)
    return in_frame(bracket, normal_moment(bracket.angular_velocity(ground), spin, I))


def solve(g):
    return {"M_C": -on_the_rotor(g)}


def steps(g):
    _, _, body = rotor(g)
    I = body.inertia.moment("x")
    return {"I": I, "H_spin": g.P * I}


def prove(g):
    """The moment that a cylinder of another length needs about C, minus that of its weight."""
    m, length = g.W / g.g, g.r
    C = [0, 0, -2 * g.r]
    points = proofs.along_x(proofs.raised(proofs.disk(g.r, order=2), length))
    own = lambda t: rot("x", g.P * t)
    turned = proofs.carried(points, lambda t: times(rot("z", g.Omega * t), own(t)))
    of_weight = cross(minus(proofs.mean(lambda p: p, points), C), [0, 0, -g.W])
    return {
        "M_C": minus(of_weight, moment_needed(m, turned, about=C)),
        "I": m * proofs.mean(lambda p: p[1] ** 2 + p[2] ** 2, points),
        "H_spin": proofs.angular_momentum(m, proofs.carried(points, own))[0],
    }


def mistakes(g):
    right = on_the_rotor(g)
    return {
        "on_the_assembly": {"M_C": right},
        "diameter": {"M_C": -on_the_rotor(g, g.one / 2)},
        "inches": {"M_C": -right * 144},
        "no_half": {"M_C": -right * 2},
    }


def draw(g, ax):
    ground, bracket, _ = rotor(g)
    s = Sketch(ax, ground, azimuth=-60, elevation=16)
    r = g.r
    half, out, low = 1.5 * r, 2.1 * r, -1.6 * r
    foot, C = (0, 0, -3.6 * r), (0, 0, -2.4 * r)
    s.ground(foot, normal=ground.k)
    s.shaft(foot, (0, 0, low))
    s.rod((-out, 0, low), (out, 0, low))
    for x in (-out, out):
        s.rod((x, 0, low), (x, 0, 0))
        s.rod((x / out * half, 0, 0), (x * 1.1, 0, 0))
        s.hinge((x, 0, 0), axis=ground.i)
    s.cylinder((-half, 0, 0), (half, 0, 0), r)
    s.line((0, 0, 0), (0, 0, 1.8 * r), style="centre")
    s.dot((0, 0, 0), "G", offset=(-12, 4))
    s.dot(C, "C", offset=(12, 0))
    s.label((-out, 0, 0), "A", offset=(-4, 14))
    s.label((out, 0, 0), "B", offset=(4, 14))
    s.turn((0, 0, -3 * r), ground.k, label=r"$\Omega$")
    s.turn((1.2 * out, 0, 0), ground.i, label="P")
    s.dimension((half, 0, 0), (half, 0, r), label="r", offset=0)
    s.axes((-2 * out, 0, low), bracket, length=1.3 * r)
