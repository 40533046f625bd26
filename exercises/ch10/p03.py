"""10/3: the two steady precessions of a top."""

from exercises.devices.steady_precession import both_rates, needed_by_rates
from exercises.devices.top_on_its_point import data, data_steps, draw, proof_data, top, two
from exercises.tools import mp
from newton_euler.applications.gyroscopes import fast_spin, steady_precession


def solve(g, **wrong):
    return two(steady_precession(**top(g, **wrong)))


def steps(g):
    yield from data_steps(g)
    yield "D", steady_precession(**top(g)).discriminant


def prove(g):
    """Both rates at which mass points need exactly the moment of their weights."""
    given, found = proof_data(g)
    slow, fast = both_rates(*given)
    square, _ = needed_by_rates(*given[:3])
    D = (square * (fast - slow) / mp.sin(g.theta)) ** 2
    return {"psi_slow": slow, "psi_fast": fast, "D": D} | found


def mistakes(g):
    m_c2 = data(g)["I0"] * (g.c / g.k_x) ** 2
    return {
        "fast_spin": two(fast_spin(**top(g))),
        "spin_is_whole_rate": solve(g, spin=None, omega_z=g.phi_dot),
        "inches": solve(g.but(g=g.g / 12)),
        "rpm": solve(g.but(phi_dot=g.stated("phi_dot"))),
        "about_G": solve(g, I0=data(g)["I0"] - m_c2),
    }
