"""9/5: two crossed rods on a shaft."""

from exercises.devices import rotor
from exercises.tools import box
from newton_euler.bodies import rod


def two_rods(g):
    _, shaft = rotor.turning_shaft(g)
    first = rod(g.l, shaft.point("G1", g.p, g.l / 2, 0), "y", mass=g.m, name="first rod")
    second = rod(g.l, shaft.point("G2", g.q, 0, g.l / 2), "z", mass=g.m, name="second rod")
    return rotor.in_bearings(shaft, [first, second], 0, g.d)


solve, steps, follows = rotor.problem_of(two_rods, products="xy xz", off_axis=True)


def prove(g):
    outward = [(share * g.m, x + g.l / 2) for share, (x, _, _) in box(g.l, 0, 0)]
    points = [(m, [g.p, u, 0]) for m, u in outward] + [(m, [g.q, 0, u]) for m, u in outward]
    return rotor.prove(g, points, 0, g.d, ("I_xx", "I_xy", "I_xz", "a_G"))


def mistakes(g):
    r = two_rods(g)
    right = rotor.answers(r)
    return {
        "about_the_middle": rotor.only(rotor.with_inertia(r, moment=1 * g.one / 4), "H_O"),
        # with moments about A, F_B does not depend on the force equation
        "pure_couple": rotor.only(rotor.pure_couple(r), "F_A"),
        "wrong_sign": rotor.with_inertia(r, product=-1),
        "millimetres": {
            **{key: right[key] * 10**6 for key in ("H_O", "Hdot_O")},
            **{key: right[key] * 10**3 for key in ("F_A", "F_B")},
        },
    }


def draw(g, ax):
    r = two_rods(g)
    s = rotor.sketch(ax, r, azimuth=-40, elevation=20)
    first, second = (g.p, 0, 0), (g.q, 0, 0)
    ends = (g.p, g.l, 0), (g.q, 0, g.l)
    s.rod(first, ends[0])
    s.rod(second, ends[1])
    s.dimension(first, ends[0], label="l", offset=-0.15 * g.l)
    s.dimension(second, ends[1], label="l", offset=-0.15 * g.l)
    s.axes(r.O, r.shaft, length=0.45 * g.l)
    s.dimension(r.A, first, label="p", offset=0.2 * g.d)
    s.dimension(r.A, second, label="q", offset=-0.14 * g.d)
    s.dimension(r.A, r.B, label="d", offset=-0.3 * g.d)
