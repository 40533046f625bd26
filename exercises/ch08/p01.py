"""8/1: a beam on a pin and a cable that snaps."""

from exercises.devices import broken_cable as device
from exercises.tools import box, on_ground, plus, second_rate
from newton_euler.bodies import rod

follows = {"R_C": lambda g, a_B: device.pin_force(g, beam(g), -a_B / ((1 - g.k) * g.L)).y}


def offset(g):
    """The horizontal distance from the pin to the centre of mass."""
    return (1 - 2 * g.k) * g.L / 2


def beam(g):
    m, place = device.mass(g), (offset(g), -g.n * g.L, 0)
    return lambda frame: rod(g.L, frame.point("G", *place), "x", mass=m)


def a_B(g, alpha):
    return -device.acceleration_of(((1 - g.k) * g.L, -g.n * g.L, 0), alpha).y


def answers(g, alpha):
    return {"a_B": a_B(g, alpha), "R_C": device.pin_force(g, beam(g), alpha).y}


def solve(g):
    found = device.falls(g, beam(g))
    return {"a_B": a_B(g, found.alpha), "R_C": found.R_y}


def steps(g):
    yield "d", offset(g)
    *first, a_G = device.fall_steps(g, beam(g), "C")
    yield from first
    yield "alpha", device.falls(g, beam(g)).alpha
    yield a_G


def prove(g):
    points = [(u, plus(r, [offset(g), -g.n * g.L, 0])) for u, r in box(g.L, 0, 0, order=2)]
    alpha, R, B = device.by_energy(g, points, [(1 - g.k) * g.L, -g.n * g.L, 0])
    return {"a_B": -second_rate(B)[1], "R_C": R[1], "alpha": alpha} | device.sums(g, points, "C")


def mistakes(g):
    moment, m = device.moment_of_weight(g, beam(g)), device.mass(g)
    return {
        "about_G": answers(g, moment / (m * g.L**2 / 12)),
        "about_the_end": answers(g, moment / (m * g.L**2 / 3)),
        "no_height": solve(g.but(n=0 * g.n)),
        "as_in_statics": {"R_C": g.W / (2 * (1 - g.k))},
        "B_falls_freely": {"a_B": g.g},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    low = -g.n * g.L
    A, C, B = (-g.k * g.L, low, 0), (0, 0, 0), ((1 - g.k) * g.L, low, 0)
    top = (B[0], 0.4 * g.L, 0)
    s.rod(A, B)
    s.rod((0, low, 0), C)
    s.hinge(C)
    s.ground((0, 0.09 * g.L, 0), -ground.j)
    s.line((-0.03 * g.L, 0.09 * g.L, 0), C, style="solid")
    s.line((0.03 * g.L, 0.09 * g.L, 0), C, style="solid")
    s.cable(B, top)
    s.ground(top, -ground.j)
    s.dimension(A, B, label="L", offset=-0.3 * g.L)
    s.dimension(A, (0, low, 0), label="$kL$", offset=-0.17 * g.L)
    s.dimension(C, (0, low, 0), label="$nL$", offset=0.11 * g.L)
    s.label(A, "A", offset=(-10, 0))
    s.label(B, "B", offset=(10, -4))
    s.label(C, "C", offset=(-14, 6))
