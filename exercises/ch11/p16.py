"""11/16: the kinetic energy of a disk that spins at the end of a turning arm."""

from exercises.devices.disk_on_shaft import energy_of_disk, spinning
from exercises.tools import Sketch
from newton_euler import Body, kinetic_energy
from newton_euler.bodies import disk


def energy(g, Omega, spin):
    """The kinetic energy, with the terms of translation and rotation."""
    d = spinning(Omega, spin, g.L)
    return kinetic_energy(disk(g.r, d.body, "x", mass=g.M), d.ground)


def solve(g):
    return {"T": energy(g, g.Omega, g.omega_s).value}


def steps(g):
    d = spinning(g.Omega, g.omega_s, g.L)
    I, T = disk(g.r, d.body, "x", mass=g.M).inertia, energy(g, g.Omega, g.omega_s)
    v, energies = d.C.velocity(d.ground).norm(), T.terms
    moments = {"I_a": I.moment("x"), "I_d": I.moment("y")}
    return {"v_C": v, **moments, "T_trans": energies["translation"], "T_rot": energies["rotation"]}


def prove(g):
    T = energy_of_disk(g.M, g.r, g.Omega, g.omega_s, g.L)
    return {"T": T, "T_rot": energy_of_disk(g.M, g.r, g.Omega, g.omega_s, 0)}


def mistakes(g):
    T, d = energy(g, g.Omega, g.omega_s), spinning(g.Omega, g.omega_s, g.L)
    axial = disk(g.r, d.body, "x", mass=g.M).inertia.moment("x")
    alike = kinetic_energy(Body("disk", g.M, d.body, (axial, axial, axial)), d.ground)

    def with_rotation(Omega, spin):
        return T.terms["translation"] + energy(g, Omega, spin).terms["rotation"]

    return {
        "no_turning_of_plane": {"T": with_rotation(0 * g.Omega, g.omega_s)},
        "axial_for_diameter": {"T": alike.value},
        "rates_added": {"T": with_rotation(0 * g.Omega, g.Omega + g.omega_s)},
        "no_translation": {"T": T.reweighted(translation=0)},
    }


def draw(g, ax):
    d = spinning(g.Omega, g.omega_s, 1.0)
    s = Sketch(ax, d.ground, azimuth=-50, elevation=18)
    r, k = 0.45, d.ground.k
    O, C = (0, 0, 0), d.C
    s.shaft((0, 0, -0.5), (0, 0, 0.7))
    s.ground((0, 0, -0.5), k)
    s.rod(O, C)
    s.disk(C, d.shaft.i, r)
    s.turn((0, 0, 0.5), k, label=r"$\Omega$")
    s.turn((1.3, 0, 0), d.shaft.i, label=r"$\omega_s$")
    s.line(C, (1.55, 0, 0), style="centre")
    s.dimension(O, C, label="L")
    s.dimension(C, (1, 0, r), label="r", offset=0)
    s.label(O, "O", offset=(-12, 8))
    s.dot(C, "C", offset=(8, -10))
