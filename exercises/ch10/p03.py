"""10/3: the two steady precessions of a top."""

from exercises.devices import top_on_its_point as device
from exercises.devices.steady_precession import both_rates, needed_by_rates
from exercises.tools import mp
from newton_euler.applications.gyroscopes import fast_spin, steady_precession

draw = device.draw


def solve(g, **wrong):
    return device.two(steady_precession(**device.top(g, **wrong)))


def steps(g):
    yield from device.data_steps(g)
    yield "D", steady_precession(**device.top(g)).discriminant


def prove(g):
    """Both rates at which mass points need exactly the moment of their weights."""
    given, found = device.proof_data(g)
    slow, fast = both_rates(*given)
    square, _ = needed_by_rates(*given[:3])
    D = (square * (fast - slow) / mp.sin(g.theta)) ** 2
    return {"psi_slow": slow, "psi_fast": fast, "D": D} | found


def mistakes(g):
    m_c2 = device.data(g)["I0"] * (g.c / g.k_x) ** 2
    return {
        "fast_spin": device.two(fast_spin(**device.top(g))),
        "spin_is_whole_rate": solve(g, spin=None, omega_z=g.phi_dot),
        "inches": solve(g.but(g=g.g / 12)),
        "rpm": solve(g.but(phi_dot=g.stated("phi_dot"))),
        "about_G": solve(g, I0=device.data(g)["I0"] - m_c2),
    }
