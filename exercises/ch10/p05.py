"""10/5: the precessions of the top of 10/3 by the leading terms for a fast spin."""

from exercises.devices.steady_precession import leading, orientation
from exercises.devices.top_on_its_point import data, data_steps, draw, proof_data, top, two
from exercises.tools import angular_momentum, carried
from newton_euler import cos, sin
from newton_euler.applications.gyroscopes import fast_spin


def solve(g, **wrong):
    return two(fast_spin(**top(g, **wrong)))


def steps(g):
    yield from data_steps(g)
    yield "H_s", data(g)["I"] * g.phi_dot


def prove(g):
    """The exact rates at much larger spins, the slow one as 1/spin, the fast one as the spin."""
    given, found = proof_data(g)
    rates = leading(*given)
    m, points, *_ = given
    found["H_s"] = angular_momentum(m, carried(points, orientation(0, 0, g.phi_dot)))[2]
    return {key: rates[key] for key in ("psi_slow", "psi_fast")} | found


def mistakes(g):
    right, found = solve(g), data(g)
    I0, I = found["I0"], found["I"]
    return {
        "sine_left": {"psi_slow": right["psi_slow"] * sin(g.theta)},
        "no_cosine": {"psi_fast": right["psi_fast"] * cos(g.theta)},
        "sum": {"psi_fast": right["psi_fast"] * (I0 - I) / (I0 + I)},
        "inches": {"psi_slow": solve(g.but(g=g.g / 12))["psi_slow"]},
        "rpm": solve(g.but(phi_dot=g.stated("phi_dot"))),
    }
