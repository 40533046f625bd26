"""9/4: a slanting plate on a shaft."""

from exercises.devices import rotor
from exercises.tools import box, rot, times
from newton_euler.bodies import plate


def fixed_plate(g):
    """The plate; its axes: x along the slanting edges, y along the normal."""
    _, shaft = rotor.turning_shaft(g)
    tilted = shaft.rotate("plate", "z", angle=g.theta)
    return rotor.in_bearings(shaft, [plate(g.h, g.b, tilted, "y", mass=g.m)], -g.c, g.c)


solve, steps, follows = rotor.problem_of(
    fixed_plate,
    ("I_1", "x", "about the mid-line along the slanting edges"),
    ("I_2", "y", "about the normal of the plate"),
)


def prove(g):
    points = [(share * g.m, p) for share, p in box(g.b, 0, g.h)]
    tilt = rot("z", g.theta)
    return rotor.prove(g, [(m, times(tilt, p)) for m, p in points], -g.c, g.c) | {
        "I_1": sum(m * (y * y + z * z) for m, (_, y, z) in points),
        "I_2": sum(m * (x * x + z * z) for m, (x, _, z) in points),
    }


def mistakes(g):
    r = fixed_plate(g)
    return {
        "millimetres": rotor.with_inertia(r, moment=10**6, product=10**6),
        "h_in_the_product": rotor.with_inertia(r, product=1 - (g.h / g.b) ** 2),
        "wrong_sign": rotor.with_inertia(r, product=-1),
        "along_omega": {**rotor.with_inertia(r, product=0), "balance": "both"},
    }


def draw(g, ax):
    r = fixed_plate(g)
    s = rotor.sketch(ax, r)
    p, b, h = r.body.parts[0].frame, g.b / 2, g.h / 2
    corners = [p.point("", x, 0, z) for x, z in ((-b, -h), (b, -h), (b, h), (-b, h))]
    s.plate(corners)
    s.arc(r.O, r.B, p.point("", b, 0, 0), label=r"$\theta$", radius=0.8 * b)
    s.axes(r.O, r.shaft, length=0.9 * b)
    s.dimension(corners[2], corners[3], label="b")
    s.dimension(corners[3], corners[0], label="h")
    s.label(r.O, "O")
    s.dimension(r.A, r.O, label="c", offset=0.3 * b)
