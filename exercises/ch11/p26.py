"""11/26: the energy of a spherical pendulum, from the two levels between which it moves."""

from mpmath import fp

from exercises.devices.spherical_pendulum import level_motion, other_level, way
from exercises.tools import on_ground, proofs
from newton_euler import solve_rates, sqrt
from newton_euler.dynamics import speed_after, weight_potential


def potential(g, depth):
    return weight_potential(g.m, -depth, g.g)


def ratio(g):
    """The ratio of the kinetic energies at c and b, with the same angular momentum."""

    def per_square(depth):  # over the square of the angular momentum, at any rate
        T, H = level_motion(g.m, g.a, depth, sqrt(g.g / g.a))
        return T / H**2

    return per_square(g.c) / per_square(g.b)


def kinetic(g, at_c):
    """The kinetic energy at the level b, for this ratio of that at c to it."""
    (T_b,) = solve_rates(lambda T_b: (1 - at_c) * T_b + potential(g, g.b) - potential(g, g.c), 1)
    return T_b


def energy(g, at_c):
    return {"E_total": kinetic(g, at_c) + potential(g, g.b)}


def solve(g):
    v_b = speed_after(0, kinetic(g, ratio(g)), g.m)
    return {"E_total": g.m * v_b**2 / 2 + potential(g, g.b)}


def steps(g):
    at_c = ratio(g)
    distances = {f"d_{n}": sqrt(g.a**2 - depth**2) for n, depth in (("b", g.b), ("c", g.c))}
    return {**distances, "ratio": at_c, "v_b": speed_after(0, kinetic(g, at_c), g.m)}


def prove(g):
    """The speed at b after which the bob is next horizontal at c: in floats, then refined."""

    def miss(speed):
        kind = float if isinstance(speed, float) else g.one.__class__
        place, _ = other_level(*(kind(x) for x in (g.g, g.b, g.a)), speed)
        return -place[2] - kind(g.c)

    # with this speed it stays at the level b
    level = float((g.a**2 - g.b**2) * g.g / g.b) ** 0.5
    near = g.one * fp.findroot(miss, (level / 20, 0.95 * level), solver="anderson", tol=1e-20)
    v_b = proofs.vanishing(miss, near, near * (1 + g.one / 10**9))
    place, velocity = other_level(g.g, g.b, g.a, v_b)
    return {"E_total": g.m * proofs.size(velocity) ** 2 / 2 + g.m * g.g * place[2], "v_b": v_b}


def mistakes(g):
    return {
        "at_rest_above": {"E_total": potential(g, g.b)},
        "depth_from_length": energy(g, ((g.a - g.b) / (g.a - g.c)) ** 2),
        "depths_as_arms": energy(g, (g.b / g.c) ** 2),
        "upside_down": {"E_total": -solve(g)["E_total"]},
    }


def draw(g, ax):
    ground, s = on_ground(ax, azimuth=-60, elevation=14)
    O, speed = (0, 0, 0), speed_after(0, kinetic(g, ratio(g)), g.m)
    places = way(g.g, g.b, g.a, speed, 7 * sqrt(g.a / g.g), 120)
    s.ground(O, normal=-ground.k)
    for depth, name, aside in ((g.b, "b", 0.3), (g.c, "c", 0.6)):
        s.ring((0, 0, -depth), ground.k, sqrt(g.a**2 - depth**2))
        s.dimension(O, (0, 0, -depth), label=name, offset=-aside * g.a)
    s.path(places)
    s.line(O, places[0], style="solid")
    s.dot(places[0])
    s.label([x / 2 for x in places[0]], "a", offset=(6, 10), bold=False)
    s.label(places[0], "m", offset=(6, -14), bold=False)
    s.label(O, "O", offset=(0, 14))
