"""11/19: the kinetic energies of two disks on one shaft, rolling round the vertical."""

from exercises.devices.disk_on_shaft import energy_of_disk, rolling, spinning, unrolled
from exercises.tools import Sketch
from newton_euler import Body, kinetic_energy
from newton_euler.bodies import disk

follows = {"ratio": lambda g, T_outer, T_inner: T_outer / T_inner}


def places(g):
    return {"outer": g.R + g.d, "inner": g.R - g.d}


def answers(g, energy):
    """The answers; ``energy``: of a disk, as a function of its distance from the axis."""
    outer, inner = map(energy, places(g).values())
    return {"T_outer": outer, "T_inner": inner, "ratio": outer / inner}


def terms_at(g, d):
    """The energy of translation and that of rotation of the disk."""
    return kinetic_energy(disk(g.r, d.body, "x", mass=g.M), d.ground)


def solve(g):
    return answers(g, lambda s: terms_at(g, rolling(g.Omega, g.r, s)).value)


def spin(d):
    """Inward, as the shaft turns about the upward vertical."""
    return -d.body.angular_velocity(d.shaft).x


def steps(g):
    for name, s in places(g).items():
        d = rolling(g.Omega, g.r, s)
        yield f"omega_{name}", spin(d)
        yield f"T_trans_{name}", terms_at(g, d).terms["translation"]
        yield f"T_rot_{name}", terms_at(g, d).terms["rotation"]


def prove(g):
    spins = {name: unrolled(g.Omega, g.r, s) for name, s in places(g).items()}
    energy = lambda name, s: energy_of_disk(g.M, g.r, g.Omega, spins[name], s)
    T_outer, T_inner = (energy(name, s) for name, s in places(g).items())
    found = {"T_outer": T_outer, "T_inner": T_inner, "ratio": T_outer / T_inner}
    for name in spins:
        found |= {f"omega_{name}": abs(spins[name]), f"T_rot_{name}": energy(name, 0)}
    return found


def mistakes(g):
    def no_turning(s):
        d = rolling(g.Omega, g.r, s)
        in_place = spinning(0 * g.Omega, spin(d), s)
        return terms_at(g, d).terms["translation"] + terms_at(g, in_place).terms["rotation"]

    def alike(s):
        d = rolling(g.Omega, g.r, s)
        axial = disk(g.r, d.body, "x", mass=g.M).inertia.moment("x")
        return kinetic_energy(Body("disk", g.M, d.body, (axial, axial, axial)), d.ground).value

    one_spin = lambda s: terms_at(g, spinning(g.Omega, spin(rolling(g.Omega, g.r, g.R)), s)).value
    return {
        "no_turning_of_plane": answers(g, no_turning),
        "axial_for_diameter": answers(g, alike),
        "one_spin": answers(g, one_spin),
    }


def draw(g, ax):
    R, half, r = 1.5, 0.55, 0.4
    d = spinning(1.0, 1.0, R)
    s = Sketch(ax, d.ground, azimuth=-60, elevation=20)
    k, O = d.ground.k, (0, 0, 0)
    inner, outer = ((x, 0, 0) for x in (R - half, R + half))
    s.shaft((0, 0, -r), (0, 0, 0.8))
    s.ground((0, 0, -r), k)
    s.rod(O, (2.4, 0, 0))
    for C in (inner, outer):
        s.disk(C, d.shaft.i, r)
        s.dot(C)
    s.axes((0, 0, -r), d.ground, length=0.7)
    s.turn((0, 0, 0.6), k, label=r"$\Omega$")
    s.dimension(O, inner, label="$R - d$", offset=0.6)
    s.dimension(O, outer, label="$R + d$", offset=-0.7)
    s.dimension(outer, (R + half, 0, r), label="r", offset=0)
