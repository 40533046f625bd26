"""8/7: a cylinder falling while a thread unwinds from it."""

from exercises.devices.rolling_cylinder import rolled, rolls
from exercises.tools import force_needed, kinetic_energy, let_go, mp, on_ground
from newton_euler import Frame
from newton_euler.bodies import disk, ring
from newton_euler.dynamics import mass_from_weight


def motion(g, shape=disk):
    """The cylinder rolls down the thread, x being downward."""
    return rolls(mass_from_weight(g.W, g.g), g.R, (g.g, 0), shape=shape)


def solve(g):
    return {"a_G": motion(g).a}


def steps(g):
    found, m = motion(g), mass_from_weight(g.W, g.g)
    I = disk(g.R, Frame("cylinder"), "z", mass=m).inertia.moments[2]
    return {"m": m, "I_G": I, "alpha": -found.alpha, "T": -found.F}


def prove(g):
    """By the energy of mass points released from rest."""
    m = g.W / g.g
    a = let_go(lambda q, t: kinetic_energy(m, lambda t: rolled(g.R, q(t)), t) - g.W * q(t))
    needed = force_needed(m, lambda t: rolled(g.R, a * t**2 / 2))[0]
    return {"a_G": a, "T": g.W - needed, "alpha": mp.mpf(a) / g.R}


def mistakes(g):
    return {
        "hoop": {"a_G": motion(g, ring).a},
        "no_tension": {"a_G": g.g},
        "tension_as_weight": {"a_G": 0 * g.g},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    O, top = (0, 0, 0), (-g.R, 2.6 * g.R, 0)
    s.disk(O, ground.k, g.R)
    s.ground(top, -ground.j)
    s.line(top, (-g.R, 0, 0), style="solid")
    s.dot(O, "G", offset=(-8, -8))
    s.dimension(O, (g.R * 0.8, g.R * 0.6, 0), label="R", offset=0)
    s.vector(O, (0, -0.6 * g.R, 0), "$a_G$", kind="acceleration")
