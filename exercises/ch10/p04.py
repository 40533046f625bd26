"""10/4: leading terms of the two rates of steady precession for a fast spin."""

from exercises.devices import steady_precession as device
from exercises.tools import mp
from newton_euler import Inertia, cos, sin, sqrt
from newton_euler.applications.gyroscopes import fast_spin

follows = {"eps_slow": lambda g, psi_slow, psi_fast: psi_slow / psi_fast}


def leading_terms(g, moment):
    """The leading terms: with c/h and h/a for the roots, the correction is a c/h^2."""
    found = fast_spin(g.I0, g.Iz, g.theta, g.phi_dot, moment=moment)
    return {"psi_slow": found.slow, "psi_fast": found.fast, "eps_slow": found.slow / found.fast}


def solve(g):
    return leading_terms(g, g.M)


def steps(g):
    """The moment K psi_dot x H, H of the precession and of the spin."""
    ground, axes = device.frames(g.theta)
    I, K = Inertia(axes.origin, (g.I0, g.I0, g.Iz), frame=axes), ground.k.expressed_in(axes)
    A = -K.cross(I.times(K)).x
    B = g.phi_dot * K.cross(I.times(axes.k)).x
    return {"A": A, "B": B, "s": sqrt(B * B - 4 * A * g.M)}


def prove(g):
    """From the exact rates at which mass points need the moment M, at much larger spins."""
    points = device.two_rings(mp.sqrt(g.Iz), mp.sqrt(g.I0))
    square, product = device.needed_by_rates(1, points, g.theta)
    slow, fast = device.both_rates(1, points, g.theta, g.phi_dot, g.M)
    on_the_way = {"A": -square, "B": product * g.phi_dot, "s": -square * (fast - slow)}
    return device.leading(1, points, g.theta, g.phi_dot, g.M) | on_the_way


def mistakes(g):
    right = solve(g)
    slow, fast, eps = right["psi_slow"], right["psi_fast"], right["eps_slow"]
    no_sine = leading_terms(g, g.M * sin(g.theta))
    return {
        "no_sine": {key: no_sine[key] for key in ("psi_slow", "eps_slow")},
        "sign": {"psi_fast": -fast, "eps_slow": -eps},
        "no_half": {"psi_slow": 2 * slow},
        "no_cosine": {"psi_fast": fast * cos(g.theta), "eps_slow": eps / cos(g.theta)},
    }
