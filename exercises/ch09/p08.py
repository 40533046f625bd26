"""9/8: a disk that spins in a turning fork."""

from exercises.devices import spinning_disk as device
from exercises.tools import Sketch


def disk_in_fork(g):
    return device.spinning(g, g.a, "x", "y")


def solve(g):
    d = disk_in_fork(g)
    return device.answers(d, "M_R") | {"balance": lambda: device.balance(d)}


def steps(g):
    yield from device.spin_steps(disk_in_fork(g), "y")


follows = device.following("M_R", "x")


def prove(g):
    found = device.prove_spinning(g, g.a, "x", "y", (0, 0, 0), "M_R")
    del found["F_A"]  # zero, and not asked for
    return found


def mistakes(g):
    d = disk_in_fork(g)
    H = device.momentum(d)
    return {
        "rate_of_the_disk": device.disk_rate(d, "M_R"),
        "no_diameter": {"H_O": d.arm.vector(0, H.y, H.z)},
        "on_the_supports": {"M_R": -device.answers(d, "M_R")["M_R"]},
        "no_rotation": {**device.no_rotation(d, "M_R"), "balance": "both"},
    }


def draw(g, ax):
    d = disk_in_fork(g)
    s = Sketch(ax, d.arm, up="y", azimuth=-28, elevation=20)
    bridge, half = -1.35 * g.a, 0.55 * g.a
    s.shaft((-2.9 * g.a, 0, 0), (bridge, 0, 0))
    s.hinge((-2.3 * g.a, 0, 0), axis=d.arm.i)
    for y in (-half, half):
        s.rod((bridge, 0, 0), (bridge, y, 0), (0, y, 0))
        s.rod(d.O, (0, y, 0))
    s.disk(d.O, d.arm.j, g.a)
    s.axes(d.O, d.arm, length=1.3 * g.a)
    s.turn((-1.8 * g.a, 0, 0), d.arm.i, label=r"$\omega_1$")
    s.turn((0, 0.85 * g.a, 0), d.arm.j, label=r"$\omega_2$")
    s.dimension(d.O, (0, 0, -g.a), label="a", offset=0)
    s.label(d.O, "O")
