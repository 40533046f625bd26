"""6/21: a long shot to the north, on the turning Earth."""

from exercises.devices.turning_earth import flight, ground_axes, shot, to_first_order
from exercises.tools import Sketch, mp
from exercises.tools import root as place_of
from newton_euler import Frame, asin, cos, pi, sin
from newton_euler.applications import flight_time, launch_velocity

follows = {"x": lambda g, phi: landing(g, phi)[1].x}


def elevation(g):
    """The smaller one for the range D = v_0^2 sin(2 phi)/g without rotation."""
    return asin(g.g * g.D / g.v_0**2) / 2


def landing(g, phi):
    """The point of impact; to first order the rotation does not change the time of flight."""
    north = pi(phi) / 2
    t = flight_time(g.v_0, north, phi, g.lat, g.g, 0 * g.omega_e)
    return t, shot(g, t, launch_velocity(ground_axes(g), g.v_0, north, phi))


def solve(g):
    phi = elevation(g)
    _, r = landing(g, phi)
    return {"phi": phi, "x": r.x}


def steps(g):
    t, r = landing(g, elevation(g))
    return {"t_f": t, "x_launch": r.terms["launch turned"].x, "x_fall": r.terms["fall turned"].x}


def prove(g):
    """The elevation from the height above the target; then free flight in the inertial frame."""

    def over_target(e):
        t = g.D / (g.v_0 * mp.cos(e))
        return g.v_0 * mp.sin(e) * t - g.g * t**2 / 2

    phi = place_of(over_target, 0, mp.pi / 4)
    v_y, v_z = g.v_0 * mp.cos(phi), g.v_0 * mp.sin(phi)
    place, top = flight(g, [0, v_y, v_z]), v_z / g.g

    def down(share):
        t = place_of(lambda t: place(t, share)[2], top, 3 * top)
        return [t, place(t, share)[0]]

    t_f, x = to_first_order(down)
    return {"phi": phi, "x": x, "t_f": t_f}


def mistakes(g):
    right = solve(g)
    t, r = landing(g, right["phi"])
    by_v_y = g.omega_e * sin(g.lat) * (g.v_0 * cos(right["phi"])) * t**2
    high = pi(g.v_0) / 2 - right["phi"]
    return {
        "sine_only": {"x": by_v_y},
        "no_fall_turned": {"x": r.without("fall turned").x},
        "no_half": {"x": right["x"] + by_v_y},
        "no_2": {"x": right["x"] / 2},
        "high": {"phi": high, "x": landing(g, high)[1].x},
    }


def draw(g, ax):
    s = Sketch(ax, Frame("ground"), plane="yz")
    O, T = (0, 0, 0), (0, g.D, 0)
    top = 0.15 * g.D  # far greater than in the problem
    s.road([(0, -0.1 * g.D, 0), (0, 1.4 * g.D, 0)])
    s.path([(0, g.D * q, 4 * top * q * (1 - q)) for q in (n / 40 for n in range(41))])
    s.dot(O)
    s.dot(T)
    aim = (0, g.D, 4 * top)
    s.line(O, (0, 0.45 * g.D, 1.8 * top))
    s.vector(O, aim, "$v_0$")
    s.arc(O, T, aim, label=r"$\phi$")
    s.dimension(O, T, "D", offset=-0.1 * g.D)
    s.label(T, "target", offset=(20, 12), bold=False)
    s.label((0, 1.35 * g.D, 0), "north", offset=(0, 12), bold=False)
