"""6/18: a shot at a target on a tower to the north, on the turning Earth."""

from exercises.devices.turning_earth import flight, ground_axes, shot, to_first_order
from exercises.tools import on_ground, root, scaled, size
from newton_euler import sin


def launch(g):
    """The velocity of the bullet, along the line to the target."""
    aim = ground_axes(g).vector(0, g.D, g.H)
    return aim * (g.v_0 / aim.norm())


def solve(g):
    v = launch(g)
    t = g.D / v.y  # y does not depend on the rotation for a shot to the north
    r = shot(g, t, v)
    return {"t_D": t, "d_up": r.z - g.H, "d_east": r.x}


def steps(g):
    v = launch(g)
    moved = {name: x.x for name, x in shot(g, g.D / v.y, v).terms.items()}
    return {"v_rel": v, "x_launch": moved["launch turned"], "x_fall": moved["fall turned"]}


def prove(g):
    """The free flight in the inertial frame, up to the distance D to the north."""
    way = size([g.D, g.H])
    place = flight(g, scaled(g.v_0 / way, [0, g.D, g.H]))

    def at_tower(share):
        t = root(lambda t: place(t, share)[1] - g.D, way / (2 * g.v_0), 2 * way / g.v_0)
        x, _, z = place(t, share)
        return [t, z - g.H, x]

    return dict(zip(("t_D", "d_up", "d_east"), to_first_order(at_tower), strict=True))


def mistakes(g):
    v, right = launch(g), solve(g)
    t = right["t_D"]
    upright = shot(g, t, v, omega=g.omega_e * sin(g.lat) * v.frame.k)
    return {
        "no_fall_turned": {"d_east": shot(g, t, v).without("fall turned").x},
        "no_north_part": {"d_east": upright.x},
        "shot_to_the_south": {"d_east": right["d_east"] - 2 * upright.x},
        "no_fall": {"d_up": 0 * right["d_up"]},
    }


def draw(g, ax):
    _, s = on_ground(ax, plane="yz")
    O, foot, T = (0, 0, 0), (0, g.D, 0), (0, g.D, g.H)
    sag = 0.12 * size([g.D, g.H])  # far greater than in the problem
    s.road([(0, -0.15 * g.D, 0), (0, 1.4 * g.D, 0)])
    s.rod(foot, T)
    s.line(O, T)
    s.path([(0, g.D * q, g.H * q - sag * q * q) for q in (n / 40 for n in range(41))])
    s.dot(T)
    s.vector(O, (0, g.D, g.H), "$v_0$")
    s.dimension(O, foot, "D", offset=-0.14 * g.D)
    s.dimension(foot, T, "H", offset=-0.1 * g.D)
    s.label(O, "gun", offset=(-16, 10), bold=False)
    s.label(T, "target", offset=(0, 12), bold=False)
    s.label((0, 1.3 * g.D, 0), "north", offset=(0, 10), bold=False)
