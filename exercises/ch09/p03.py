"""9/3: a slanting disk on a shaft."""

from exercises.devices import rotor
from exercises.tools import along_x, rot, times
from exercises.tools import disk as disk_points
from newton_euler import Body, bodies, pi


def fixed_disk(g):
    """The disk; its axes: x along the normal, y in the x, y plane of the shaft."""
    _, shaft = rotor.turning_shaft(g)
    tilted = shaft.rotate("disk", "z", angle=g.alpha)
    return rotor.in_bearings(shaft, [bodies.disk(g.r, tilted, "x", mass=g.m)], -g.c, g.c)


solve, steps, follows = rotor.problem_of(
    fixed_disk, ("I_n", "x", "about the normal"), ("I_d", "y", "about a diameter")
)


def prove(g):
    points = [(share * g.m, p) for share, p in along_x(disk_points(g.r))]
    tilt = rot("z", g.alpha)
    return rotor.prove(g, [(m, times(tilt, p)) for m, p in points], -g.c, g.c) | {
        "I_n": sum(m * (y * y + z * z) for m, (_, y, z) in points),
        "I_d": sum(m * (x * x + z * z) for m, (x, _, z) in points),
    }


def mistakes(g):
    r = fixed_disk(g)
    I_n, I_d, _ = r.body.parts[0].inertia.moments
    exchanged = Body("disk", g.m, r.body.parts[0].frame, (I_d, I_n, I_n))
    return {
        "along_omega": {**rotor.with_inertia(r, product=0), "balance": "both"},
        "moments_exchanged": rotor.only(
            rotor.answers(rotor.in_bearings(r.shaft, [exchanged], -g.c, g.c))
        ),
        "from_the_plane": rotor.only(solve(g.but(alpha=pi(g.alpha) / 2 - g.alpha)), "H_O"),
        "static_is_enough": {"balance": "both"},
    }


def draw(g, ax):
    r = fixed_disk(g)
    s = rotor.sketch(ax, r, azimuth=-20, elevation=12)
    tilted = r.body.parts[0].frame
    s.disk(r.O, tilted.i, g.r)
    tip = tilted.point("", 1.1 * g.r, 0, 0)
    s.line(r.O, tip, style="centre")
    s.arc(r.O, r.B, tip, label=r"$\alpha$", radius=0.9 * g.r)
    s.axes(r.O, r.shaft, length=0.6 * g.r)
    s.label(r.O, "O", offset=(-12, -18))
    s.dimension(r.O, tilted.point("", 0, g.r, 0), label="r", offset=0.2 * g.r)
    s.dimension(r.O, r.B, label="c", offset=-0.35 * g.r)
