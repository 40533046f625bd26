"""8/2: a square plate on a pin and a cable that snaps."""

from exercises.devices import broken_cable as device
from exercises.tools import box, on_ground, plus, second_rate
from newton_euler import Frame, bodies, sqrt

follows = {
    "a_C": lambda g, alpha_plate: device.acceleration_of((g.b, -g.b, 0), alpha_plate),
    "R_A": lambda g, alpha_plate: device.pin_force(g, square(g), alpha_plate),
}


def square(g):
    return lambda frame: bodies.plate(
        g.b, g.b, frame.point("G", g.b / 2, -g.b / 2, 0), "z", mass=device.mass(g), name="plate"
    )


def answers(g, alpha):
    a_C, R_A = (f(g, alpha) for f in follows.values())
    return {"alpha_plate": alpha, "a_C": a_C, "R_A": R_A}


def solve(g):
    found = device.falls(g, square(g))
    return answers(g, found.alpha) | {"R_A": Frame("ground").vector(found.R_x, found.R_y, 0)}


def steps(g):
    yield from device.fall_steps(g, square(g), "A")


def prove(g):
    points = [(u, plus(r, [g.b / 2, -g.b / 2, 0])) for u, r in box(g.b, g.b, 0, order=2)]
    alpha, R, C, G = device.by_energy(g, points, [g.b, -g.b, 0], [g.b / 2, -g.b / 2, 0])
    found = {"alpha_plate": alpha, "a_C": second_rate(C), "R_A": R, "a_G": second_rate(G)}
    return found | device.sums(g, points, "A")


def mistakes(g):
    shape, right = square(g), solve(g)
    alpha, R = right["alpha_plate"], right["R_A"]
    return {
        "about_G": answers(g, device.moment_of_weight(g, shape) / (device.mass(g) * g.b**2 / 6)),
        "arm_AG": answers(g, sqrt(2 * g.one) * alpha),  # b/sqrt(2) for b/2
        "counterclockwise": {key: -right[key] for key in ("alpha_plate", "a_C")},
        "vertical_only": {"R_A": R.frame.vector(0, R.y, 0)},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    A, B, C, D = (0, 0, 0), (g.b, 0, 0), (g.b, -g.b, 0), (0, -g.b, 0)
    top = (g.b, 0.4 * g.b, 0)
    s.plate([A, B, C, D], shade="light")
    s.hinge(A)
    s.ground((-0.09 * g.b, 0, 0), ground.i)
    s.line((-0.09 * g.b, 0.04 * g.b, 0), A, style="solid")
    s.line((-0.09 * g.b, -0.04 * g.b, 0), A, style="solid")
    s.cable(B, top)
    s.ground(top, -ground.j)
    s.dimension(B, C, label="b", offset=0.2 * g.b)
    s.dimension(D, C, label="b", offset=-0.2 * g.b)
    s.label(A, "A", offset=(6, 10))
    s.label(B, "B", offset=(-8, 10))
    s.label(C, "C", offset=(8, -6))
    s.label(D, "D", offset=(-8, -6))
