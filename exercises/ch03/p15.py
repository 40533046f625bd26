"""3/15: rotation of the spherical unit vectors."""

from exercises.devices.spherical_point import figure, place_in_time
from exercises.tools import mp, rate, spherical_axes, times
from newton_euler import Frame, moving, pi
from newton_euler.kinematics import spherical_frame

draw = figure
KEYS = "e_R_rate", "e_theta_rate", "e_phi_rate"


def axes(g):
    """Ground, and the frame of the unit vectors, at any azimuth."""
    ground = Frame("ground")
    return ground, spherical_frame(ground, moving(0, g.theta_dot), moving(g.phi, g.phi_dot))


def solve(g):
    ground, local = axes(g)
    return dict(zip(KEYS, (e.rate(ground) for e in (local.i, local.j, local.k)), strict=True))


def steps(g):
    ground, local = axes(g)
    omega = local.angular_velocity(ground)
    return {"k": ground.k.expressed_in(local), "Omega": omega.expressed_in(local)}


def prove(g):
    """The unit vectors at the moving point, differentiated."""
    place = place_in_time(lambda t: 1, lambda t: g.theta_dot * t, lambda t: g.phi + g.phi_dot * t)
    here = spherical_axes(place(mp.mpf(0)))
    rates = [*rate(lambda t: spherical_axes(place(t))), [0, 0, 1]]
    return {key: times(here, v) for key, v in zip((*KEYS, "k"), rates, strict=True)}


def mistakes(g):
    right = solve(g)["e_theta_rate"]
    reversed_phi = solve(g.but(phi_dot=-g.phi_dot))
    return {
        "phi_from_the_vertical": solve(g.but(phi=pi(g.phi) / 2 - g.phi)),
        "e_theta_only_inward": {"e_theta_rate": right.frame.vector(right.x, 0, 0)},
        "phi_about_plus_e_theta": {k: reversed_phi[k] for k in ("e_R_rate", "e_phi_rate")},
    }
