"""11/12: a collar on a half hoop in a horizontal plane, pulled by a spring from above it."""

from exercises.devices.spring_to_pin import pull
from exercises.tools import Sketch, minus, mp, size, speed_along
from newton_euler import Frame, pi
from newton_euler.dynamics import speed_after, spring_between, spring_potential, weight_potential

follows = {"v_C": lambda g, v_B: speed_after(v_B, energy(g, "B") - energy(g, "C"), g.m)}


def scene(g):
    ground = Frame("ground")
    places = {"A": (-g.r, 0, 0), "B": (0, 0, g.r), "C": (g.r, 0, 0), "D": (g.x_D, g.y_D, g.z_D)}
    return ground, {name: ground.point(name, *place) for name, place in places.items()}


def length(g, name):
    """The length of the spring, with the collar at A, B or C."""
    _, points = scene(g)
    return (points[name] - points["D"]).norm()


def energy(g, name):
    """The energy of the spring."""
    _, points = scene(g)
    return spring_between(g.k, g.l_0, points["D"], points[name])


def work(g, name):
    """The work of the spring, from A."""
    return energy(g, "A") - energy(g, name)


def speeds(g, U_B, U_C):
    return {"v_B": speed_after(0, U_B, g.m), "v_C": speed_after(0, U_C, g.m)}


def solve(g):
    return speeds(g, work(g, "B"), work(g, "C"))


def steps(g):
    for name in "ABC":
        yield f"l_{name}", length(g, name)
        yield f"V_{name}", energy(g, name)


def prove(g):
    """The pull of the spring, integrated along the rod."""
    rod = lambda phi: [-g.r * mp.cos(phi), 0, g.r * mp.sin(phi)]
    D = [g.x_D, g.y_D, g.z_D]
    spring = pull(g.k, g.l_0, D)
    v_B = speed_along(g.m, spring, rod, 0, mp.pi / 2)
    v_C = speed_along(g.m, spring, rod, mp.pi / 2, mp.pi, v_B)
    places = {"l_A": rod(0), "l_B": rod(mp.pi / 2), "l_C": rod(mp.pi)}
    return {"v_B": v_B, "v_C": v_C} | {key: size(minus(D, P)) for key, P in places.items()}


def mistakes(g):
    U_B, U_C = work(g, "B"), work(g, "C")
    changes = [length(g, "A") - length(g, name) for name in "BC"]
    return {
        "no_free_length": solve(g.but(l_0=0 * g.l_0)),
        "flat": solve(g.but(y_D=0 * g.y_D)),
        "z_up": {"v_B": speeds(g, U_B - weight_potential(g.m, g.r, g.g), U_C)["v_B"]},
        "change_of_length": speeds(g, *(spring_potential(g.k, x) for x in changes)),
    }


def draw(g, ax):
    ground, points = scene(g)
    s = Sketch(ax, ground, azimuth=30, elevation=22, up="y")
    O = ground.origin
    A, B, C, D = (points[name] for name in "ABCD")
    s.wire([*s.around((0, 0, 0), (-g.r, 0, 0), ground.j, pi(g.r)), (g.r, 0, 0)])
    s.axes(O, ground, length=0.5 * g.r)
    s.spring(D, A)
    s.sphere(A, 0.06 * g.r)
    s.dot(O, "O", offset=(-14, 8))
    s.dot(B, "B", offset=(0, -16))
    s.dot(C, "C", offset=(-12, 14))
    s.dot(D, "D", offset=(14, 6))
    below = (g.x_D, 0, g.z_D)
    s.line(O, (g.x_D, 0, 0))
    s.dimension((g.x_D, 0, 0), below, label="$z_D$", offset=0)
    s.dimension(below, D, label="$y_D$", offset=0)
    s.dimension(O, (g.x_D, 0, 0), label="$x_D$", offset=0.5 * g.r)
    s.dimension(A, O, label="r", offset=0)
    s.label(A, "A", offset=(-20, 8))
