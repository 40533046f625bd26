"""2/5: a jet of water falling into a trench."""

from exercises.tools import mp, on_ground, root
from newton_euler import cos, kinematics, pi, sin


def heights(g, up):
    """Depths of the jet below the nozzle at both edges."""
    drop = lambda x: -kinematics.from_time(lambda t: -g.g, x / (g.v_0 * sin(g.phi)), v0=up)[0]
    return drop(g.d), drop(g.d + g.w)


def upward(g):
    return g.v_0 * cos(g.phi)


def solve(g):
    return {"h": heights(g, upward(g))}


def steps(g):
    u = g.v_0 * sin(g.phi)
    return {"t_near": g.d / u, "t_far": (g.d + g.w) / u}


def prove(g):
    """The height of the jet at an edge: the time to the ground is the root of a quadratic."""
    v, u = g.v_0 * mp.cos(g.phi), g.v_0 * mp.sin(g.phi)
    range_from = lambda h: u * (v + mp.sqrt(v**2 + 2 * g.g * h)) / g.g
    height = lambda x: root(lambda h: range_from(h) - x, 0, 10 * x)
    return {"h": [height(g.d), height(g.d + g.w)]}


def mistakes(g):
    rise = upward(g) ** 2 / (2 * g.g)
    near, far = heights(g, upward(g))
    return {
        "from_the_horizontal": solve(g.but(phi=pi(g.phi) / 2 - g.phi)),
        "no_upward_velocity": {"h": heights(g, 0 * g.v_0)},
        "from_the_top": {"h": (near + rise, far + rise)},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    low, high = solve(g)["h"]
    u, v = g.v_0 * sin(g.phi), upward(g)
    for h, x in ((low, g.d), (high, g.d + g.w)):
        times = [x / u * n / 60 for n in range(61)]
        s.path([(u * t, 0, h + v * t - g.g / 2 * t**2) for t in times])
    depth, end = 0.06 * g.d, g.d + g.w
    s.road([(-0.1 * g.d, 0, 0), (g.d, 0, 0), (g.d, 0, -depth), (end, 0, -depth), (end, 0, 0),
            (end + 0.1 * g.d, 0, 0)])  # fmt: skip
    nozzle = (0, 0, high)
    up, ahead = (0, 0, high + 0.35 * g.d), (u / g.v_0 * g.d, 0, high + v / g.v_0 * g.d)
    s.line(nozzle, up)
    s.arc(nozzle, up, ahead, label=r"$\phi$")
    s.vector(nozzle, ground.vector(u, 0, v), "$v_0$")
    s.dimension((0, 0, 0), nozzle, label="h", offset=-0.06 * g.d)
    s.dimension((0, 0, -depth), (g.d, 0, -depth), label="d", offset=0.1 * g.d)
    s.dimension((g.d, 0, -depth), (end, 0, -depth), label="w", offset=0.1 * g.d)
