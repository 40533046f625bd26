"""9/7: a disk that spins on a bent arm."""

from exercises.devices import spinning_disk as device
from exercises.tools import Sketch, terms


def disk_on_arm(g):
    return device.spinning(g, g.r, "y", "z", (g.L, 0, g.h))


def solve(g):
    d = disk_on_arm(g)
    H, Hdot, M = device.answers(d, "M_A").values()
    found = {"H_O": H, "Hdot_O": Hdot, "F_A": device.force(d), "M_A": M}
    return found | {"balance": lambda: device.balance(d)}


def steps(g):
    d = disk_on_arm(g)
    yield from device.spin_steps(d, "z")
    yield from terms(device.momentum(d), "H_O", "kg*m^2/s", "7.7", "7.23")


follows = device.following("M_A", "y")


def prove(g):
    return device.prove_spinning(g, g.r, "y", "z", (g.L, 0, g.h), "M_A")


def mistakes(g):
    d = disk_on_arm(g)
    return {
        "rate_of_the_disk": device.disk_rate(d, "M_A"),
        "no_rotation": {**device.no_rotation(d, "M_A"), "balance": "dynamic"},
        "no_orbital": {"H_O": device.momentum(d).without("orbital")},
        "moments_exchanged": device.answers(device.with_moments_exchanged(d, "z"), "M_A"),
    }


def draw(g, ax):
    d = disk_on_arm(g)
    s = Sketch(ax, d.arm, up="y", azimuth=-42, elevation=20)
    A, B, C = d.O, d.arm.point("B", g.L, 0, 0), d.body.centre
    s.shaft((0, -0.35 * g.L, 0), (0, 0.6 * g.L, 0))
    s.rod(A, B, C)
    s.disk(C, d.arm.k, g.r)
    s.hinge(A, axis=d.arm.j)
    s.dot(C)
    s.axes(A, d.arm, length=0.35 * g.L)
    s.turn((0, 0.5 * g.L, 0), d.arm.j, label=r"$\omega_1$")
    s.turn((g.L, 0, 0.6 * g.h), d.arm.k, label=r"$\omega_2$")
    s.dimension(A, B, label="L")
    s.dimension(B, C, label="h")
    s.dimension(C, (g.L, -g.r, g.h), label="r")
    for P, name in (A, "A"), (B, "B"), (C, "C"):
        s.label(P, name)
