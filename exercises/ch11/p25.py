"""11/25: a particle attracted to the origin, in a tube along a space curve."""

from math import degrees

from exercises.tools import Sketch, in_frame, mp, proofs
from newton_euler import Frame, cos, cylindrical, moving, sin, sqrt
from newton_euler.dynamics import gravitational_potential, speed_after

follows = {"v": lambda g, speed: velocity(g, speed)}


def tube(g, theta):
    """The particle in the tube, for theta increasing at unit rate."""
    theta = moving(theta, rate=1)
    return cylindrical(Frame("ground"), "P", g.R_0 + g.q * theta, theta, g.p * theta)


def potential(g, distance):
    return gravitational_potential(g.m, 1, distance, K=g.K)


def from_origin(g, theta):
    R, _, z = tube(g, theta).coordinates
    return sqrt(R.value**2 + z.value**2)


def speed_from(g, V):
    """The speed at theta = 0, for the potential energy V at release."""
    return speed_after(0, V - potential(g, g.R_0), g.m)


def velocity(g, speed, radial=1):
    """The velocity down the tube; ``radial`` multiplies the radial part of its direction."""
    P = tube(g, 0 * g.z_0 / g.p)
    along = P.velocity(P.local.parent).reweighted(radial=radial)
    return -along.direction() * speed


def answers(g, speed):
    v = velocity(g, speed)
    return {"speed": speed, **in_frame(v.frame, {"v": v})}


def solve(g):
    return answers(g, speed_from(g, potential(g, from_origin(g, g.z_0 / g.p))))


def steps(g):
    theta = g.z_0 / g.p
    R, _, _ = tube(g, theta).coordinates
    r = from_origin(g, theta)
    return {
        "theta_0": theta,
        "R_start": R.value,
        "r_start": r,
        "V_start": potential(g, r),
        "V_end": potential(g, g.R_0),
        "direction": -velocity(g, 1),
    }


def prove(g):
    """The attraction integrated along the tube, in rectangular coordinates."""
    place = lambda theta: proofs.at_angle(g.R_0 + g.q * theta, theta, g.p * theta)
    force = lambda r: proofs.scaled(-g.K * g.m / proofs.size(r) ** 3, r)
    start = proofs.root(lambda theta: place(theta)[2] - g.z_0, 0, 2 * g.z_0 / g.p)
    speed = proofs.speed_along(g.m, force, place, start, 0)
    ahead = proofs.rate(place)
    along = proofs.times(proofs.cylindrical_axes(place(0)), ahead)
    along = proofs.scaled(1 / proofs.size(ahead), along)
    return {
        "speed": speed,
        "v": proofs.scaled(-speed, along),
        "theta_0": start,
        "R_start": mp.hypot(*place(start)[:2]),
        "r_start": proofs.size(place(start)),
        "direction": along,
    }


def mistakes(g):
    speed, start = solve(g)["speed"], g.z_0 / g.p
    R, _, _ = tube(g, start).coordinates
    no_radial = velocity(g, speed, radial=0)
    return {
        "distance_from_axis": answers(g, speed_from(g, potential(g, R.value))),
        "from_infinity": answers(g, speed_from(g, 0)),
        "upward": {"v": velocity(g, -speed)},
        "no_radial_part": in_frame(no_radial.frame, {"v": no_radial}),
    }


def draw(g, ax):
    """The view is from halfway between x and the particle."""
    ground, start = Frame("ground"), g.z_0 / g.p
    s = Sketch(ax, ground, azimuth=degrees(start / 2), elevation=24)
    R = lambda theta: g.R_0 + g.q * theta
    place = lambda theta: ground.vector(R(theta) * cos(theta), R(theta) * sin(theta), g.p * theta)
    O, P = (0, 0, 0), place(start)
    foot, top = ground.vector(P.x, P.y, 0), (0, 0, 1.2 * g.z_0)
    s.wire([place(start * (n / 100 - 0.15)) for n in range(136)])
    s.line(O, P, style="dotted")
    s.label(P * 0.45, "r", offset=(9, 0), bold=False)
    s.line(O, (3 * g.R_0, 0, 0), style="solid")
    s.label((3 * g.R_0, 0, 0), "x", offset=(-10, 0), bold=False)
    s.line(O, top, style="centre")
    s.label(top, "z", offset=(10, 0), bold=False)
    s.dot(P)
    s.vector(P, -P.direction() * (0.3 * g.z_0), "F", kind="force")
    s.path(s.around(O, (0.7 * g.R_0, 0, 0), ground.k, start))
    middle = ground.vector(cos(start / 2), sin(start / 2), 0)
    s.label(middle * (0.7 * g.R_0), r"$\theta$", offset=(0, -14), bold=False)
    s.dimension(O, foot, label="R", offset=0)
    s.dimension(foot, P, label="z", offset=0)
    s.label(P, "m", offset=(16, 4), bold=False)
    s.label(O, "O")
