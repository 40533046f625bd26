"""8/9: a disk that rolls up a slope and comes to rest."""

from exercises.devices.rolling_cylinder import rolled, rolls
from exercises.tools import force_needed, kinetic_energy, let_go, mp, on_ground, vanishing
from newton_euler import Frame, cos, sin
from newton_euler.bodies import disk, ring
from newton_euler.kinematics.rectilinear import from_speed


def motion(g, shape=disk):
    """x up the slope."""
    return rolls(g.m, g.a, (-g.g * sin(g.theta), -g.g * cos(g.theta)), shape=shape)


def distance(g, a):
    """The distance to rest, with the constant acceleration a up the slope."""
    _, place = from_speed(lambda _: a, 0 * g.v_0, g.v_0)
    return {"d_OP": place}


def solve(g):
    return distance(g, motion(g).a)


def steps(g):
    found = motion(g)
    I = disk(g.a, Frame("disk"), "z", mass=g.m).inertia.moments[2]
    return {"I_G": I, "F": found.F, "a_G": found.a}


def prove(g):
    """By equal energies at O and P, and the mass points released at P."""
    height = lambda q: mp.sin(g.theta) * sum(u * r[0] for u, r in rolled(g.a, q))

    def energy(q, t):
        return kinetic_energy(g.m, lambda t: rolled(g.a, q(t)), t) + g.m * g.g * height(q(t))

    start = kinetic_energy(g.m, lambda t: rolled(g.a, g.v_0 * t))
    d = vanishing(lambda d: start - g.m * g.g * height(d), 1, 2)
    a = let_go(energy)
    along = force_needed(g.m, lambda t: rolled(g.a, a * t**2 / 2))[0]
    return {"d_OP": d, "a_G": a, "F": along + g.m * g.g * mp.sin(g.theta)}


def mistakes(g):
    slope, radians = g.g * sin(g.theta), g.but(theta=g.stated("theta"))
    return {
        "no_rotation": distance(g, -slope),
        "friction_down": distance(g, -2 * slope),
        "ring": distance(g, motion(g, ring).a),
        "degrees_as_radians": {"d_OP": -(g.v_0**2) / (2 * motion(radians).a)},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    slope = ground.rotate("slope", "z", angle=g.theta)
    r = 0.8
    places = {"O": (0, 0), "P": (4 * r, 0), "foot": (-3 * r, -r), "end": (6 * r, -r)}
    C, P, foot, end = (slope.point(name, x, y, 0) for name, (x, y) in places.items())
    s.road([foot, end])
    level = ground.translate("level", ground.point("level", *foot.position(ground).components()))
    s.line(foot, level.point("right", 5 * r, 0, 0))
    s.arc(foot, level.point("right", 5 * r, 0, 0), end, label=r"$\theta$", radius=4 * r)
    s.disk(C, ground.k, r)
    s.line(C, P)
    s.vector(C, 1.6 * r * slope.i, "$v_0$")
    s.dimension(C, slope.point("rim", -0.6 * r, 0.8 * r, 0), label="a", offset=0)
    s.dot(C, "O", offset=(2, -11))
    s.dot(P, "P", offset=(6, 8))
