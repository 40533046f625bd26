"""3/16: the acceleration of a point in spherical components."""

from exercises.devices.spherical_point import figure, place_in_time
from exercises.tools import mp, rate, scaled, second_rate, spherical_axes, times
from newton_euler import Frame, cos, moving, pi, spherical

KEYS = "d_radial", "d_theta", "d_phi"
PRODUCTS = dict.fromkeys(("coriolis_theta", "coriolis_phi", "coriolis_theta_phi"), 0.5)


def point(g):
    """Ground, and the point, at any azimuth."""
    ground = Frame("ground")
    R, phi = moving(g.R, g.R_dot, g.R_ddot), moving(g.phi, g.phi_dot, g.phi_ddot)
    return ground, spherical(ground, "P", R, moving(0, g.theta_dot, g.theta_ddot), phi)


def solve(g):
    ground, P = point(g)
    return {"a": P.acceleration(ground)}


def steps(g):
    """The velocity, and the rates of its three terms, which add up to the acceleration."""
    ground, P = point(g)
    R, _, phi = P.coordinates
    about = R * cos(phi) * moving(g.theta_dot, g.theta_ddot)
    parts = moving(g.R_dot, g.R_ddot), about, R * moving(g.phi_dot, g.phi_ddot)
    e = P.local.i, P.local.j, P.local.k
    rates = ((part * axis).rate(ground) for part, axis in zip(parts, e, strict=True))
    return {"v": P.velocity(ground)} | dict(zip(KEYS, rates, strict=True))


def prove(g):
    motion = lambda *rates: lambda t: rates[0] + rates[1] * t + rates[2] * t**2 / 2
    R, phi = motion(g.R, g.R_dot, g.R_ddot), motion(g.phi, g.phi_dot, g.phi_ddot)
    place = place_in_time(R, motion(0, g.theta_dot, g.theta_ddot), phi)
    here = spherical_axes(place(mp.mpf(0)))

    def part(n):
        """The n-th term of the velocity over time, along axes of the ground."""
        e = lambda t: spherical_axes(place(t))
        return lambda t: scaled(times(e(t), rate(place, t))[n], e(t)[n])

    found = {key: times(here, rate(part(n))) for n, key in enumerate(KEYS)}
    return {"a": times(here, second_rate(place)), "v": times(here, rate(place))} | found


def mistakes(g):
    a = solve(g)["a"]
    # e_phi points down if phi is from the vertical
    down = solve(g.but(phi=pi(g.phi) / 2 - g.phi, phi_dot=-g.phi_dot, phi_ddot=-g.phi_ddot))["a"]
    constant = a.reweighted(centripetal_theta=0, centripetal_phi=0, **PRODUCTS)
    return {
        "constant_unit_vectors": {"a": constant},
        "single_products": {"a": a.reweighted(**PRODUCTS)},
        "phi_from_the_vertical": {"a": a.frame.vector(down.x, down.y, -down.z)},
    }


def draw(g, ax):
    figure(g, ax, "R")
