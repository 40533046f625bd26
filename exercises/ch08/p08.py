"""8/8: a cylinder on a suddenly accelerated slab, slipping and rolling."""

from exercises.devices.rolling_cylinder import rolls, slips
from exercises.tools import disk, on_ground, plus, proofs, rot, second_rate, times, vanishing


def no_slip(g, condition=None):
    """The motion without slip, for unit mass."""
    return rolls(g.one, g.r, (0, -g.g), g.n * g.g, no_slip=condition)


def with_slip(g, f):
    return slips(g.one, g.r, (0, -g.g), f)


def solve(g):
    """Rolling needs the friction n m g/3, more than the limit in case a, less in b."""
    return {"alpha_a": with_slip(g, g.f_a).alpha, "alpha_b": no_slip(g).alpha}


def steps(g):
    f_min = no_slip(g).F / (g.one * g.g)
    return {"a_Gb": no_slip(g).a, "f_min": f_min, "a_Ga": with_slip(g, g.f_a).a}


def prove(g):
    """The friction is at its limit, unless less of it keeps the contact at rest on the slab."""
    points = disk(g.r, order=2)
    motion = lambda alpha: proofs.carried(points, lambda t: rot("z", alpha * t**2 / 2))
    # alpha for a unit force at the contact, from the moment that mass points need
    by_one = vanishing(lambda alpha: proofs.moment_needed(1, motion(alpha))[2] - g.r, 0, 1 / g.r)
    turning = lambda F: by_one * F

    def lag(F):
        """The slab's acceleration minus that of the contact."""
        alpha = turning(F)

        def contact(t):
            return plus([F * t**2 / 2, 0, 0], times(rot("z", alpha * t**2 / 2), [0, -g.r, 0]))

        return g.n * g.g - second_rate(contact)[0]

    friction = lambda f: f * g.g if lag(f * g.g) > 0 else vanishing(lag, 0, f * g.g)
    F_a, F_b = friction(g.f_a), friction(g.f_b)
    f_min = vanishing(lambda f: lag(f * g.g), 0, 1)
    alphas = {"alpha_a": turning(F_a), "alpha_b": turning(F_b)}
    return {**alphas, "a_Ga": F_a, "a_Gb": F_b, "f_min": f_min}


def mistakes(g):
    right = solve(g)
    no_turning = no_slip(g, lambda a, alpha: a - g.n * g.g)
    center_at_rest = no_slip(g, lambda a, alpha: g.r * alpha - g.n * g.g)
    return {
        "always_slips": {"alpha_b": with_slip(g, g.f_b).alpha},
        "always_rolls": {"alpha_a": no_slip(g).alpha},
        "no_turning": {"alpha_b": no_turning.alpha},
        "no_motion_of_center": {"alpha_b": center_at_rest.alpha},
        "clockwise": {key: -alpha for key, alpha in right.items()},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    O, rim, h = (0, 0, 0), (0.8 * g.r, 0.6 * g.r, 0), 0.3 * g.r
    s.disk(O, ground.k, g.r)
    s.box((0, -g.r - h / 2, 0), ground, (5 * g.r, h, h))
    s.dot(O)
    s.dimension(O, rim, label="r", offset=0)
    s.vector((2.5 * g.r, -g.r - h / 2, 0), (g.r, 0, 0), "$n g$", kind="acceleration")
    s.axes((-2.4 * g.r, 0, 0), ground, length=0.6 * g.r, labels=["x", "y", ""])
