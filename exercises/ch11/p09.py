"""11/9: a roller coaster: the force of the seat in a loop, and a hump without contact force."""

from exercises.devices.vertical_loop import circle, contact, draw_loop, proved_contact
from exercises.tools import force_needed, mp, on_ground, speed_along
from exercises.tools import root as proved_root
from newton_euler import pi, root
from newton_euler.dynamics import mass_from_weight, path_force, speed_after, weight_potential


def mass(g):
    return mass_from_weight(g.W, g.g)


def speed(g, height):
    """The speed at a height above B."""
    return speed_after(0, weight_potential(mass(g), g.h - height, g.g), mass(g))


def at_B(g, v, r=None, **shares):
    return contact(mass(g), g.g, g.d / 2 if r is None else r, 0 * g.one, v, **shares)


def at_D(g, v, r=None, **shares):
    return contact(mass(g), g.g, g.d / 2 if r is None else r, pi(g.d), v, **shares)


def least_radius(g, v):
    """The radius at which the crest needs a force equal to the weight."""
    return root(lambda rho: g.W - path_force(mass(g), v, 0, 1 / rho)[1], g.h / 100, 10 * g.h)


def speeds(g):
    """The speeds at B, D and E."""
    return speed(g, 0), speed(g, g.d), speed(g, g.h_E)


def solve(g):
    v_B, v_D, v_E = speeds(g)
    return {"N_B": at_B(g, v_B), "N_D": at_D(g, v_D), "rho_E": least_radius(g, v_E)}


def steps(g):
    v_B, v_D, v_E = speeds(g)
    needed = lambda v: path_force(mass(g), v, 0, 2 / g.d)[1]
    return {"v_B": v_B, "v_D": v_D, "v_E": v_E, "F_B": needed(v_B), "F_D": needed(v_D)}


def prove(g):
    """The weight integrated along some track from A to B, round the loop and up to E."""
    m, r = g.W / g.g, g.d / 2
    weight = lambda place: [0, 0, -g.W]
    v_B = speed_along(m, weight, lambda q: [g.h * q, 0, g.h * (1 - q) ** 2], 0, 1)
    v_D = speed_along(m, weight, circle(r), 0, mp.pi, v_B)
    v_E = speed_along(m, weight, lambda q: [g.h * q, 0, g.h_E * q * q * (3 - 2 * q)], 0, 1, v_B)

    def over_crest(rho):
        """The force of the track on a car of the rider's weight."""
        along = lambda t: [rho * mp.sin(v_E * t / rho), 0, rho * mp.cos(v_E * t / rho)]
        return force_needed(m, lambda t: [(1, along(t))])[2] + g.W

    return {
        "N_B": proved_contact(m, g.g, r, 0, v_B),
        "N_D": proved_contact(m, g.g, r, mp.pi, v_D),
        "rho_E": proved_root(over_crest, g.h / 100, 10 * g.h),
        "v_B": v_B,
        "v_D": v_D,
        "v_E": v_E,
    }


def mistakes(g):
    v_B, v_D, _ = speeds(g)
    return {
        "no_weight_at_B": {"N_B": at_B(g, v_B, weight=0)},
        "weight_at_D": {"N_D": at_D(g, v_D, weight=-1)},
        "diameter_for_radius": {"N_B": at_B(g, v_B, g.d), "N_D": at_D(g, v_D, g.d)},
        "speed_of_B": {"N_D": at_D(g, v_B), "rho_E": least_radius(g, v_B)},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    r, h, crest = g.d / 2, g.h, 0.8 * g.d + 0.55 * g.h
    start, far = -0.9 * h, crest + 0.6 * h
    ways = [n / 40 for n in range(41)]
    level = 0.2 * h  # height of the track before the loop
    fall = [(start + (-level - start) * q, 0, h * (1 - q) ** 2) for q in ways]
    hump = [(crest + 0.5 * h * (2 * q - 1), 0, g.h_E * (16 * q**2 * (1 - q) ** 2)) for q in ways]
    s.road([*fall, *hump, (far, 0, 0)])
    draw_loop(s, ground, r)
    A, B, D, E = fall[0], (0, 0, 0), (0, 0, g.d), (crest, 0, g.h_E)
    s.dot(A, "A", offset=(4, 14))
    s.dot(B, "B", offset=(0, -16))
    s.dot(D, "D", offset=(0, 14))
    s.dot(E, "E", offset=(0, 14))
    s.line((start, 0, 0), (-level, 0, 0))
    s.dimension((start, 0, 0), A, label="h", offset=0.15 * h)
    s.dimension((0, 0, 0), (0, 0, g.d), label="d", offset=-1.3 * r)
    s.dimension((crest, 0, 0), E, label="$h_E$", offset=0)
