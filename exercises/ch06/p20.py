"""6/20: the sideways force on a car that drives south on the turning Earth."""

from exercises.devices.turning_earth import RADIUS, from_above, ground_axes
from exercises.tools import at_angle, mp, second_rate
from newton_euler import Frame, pi
from newton_euler.applications import earth_rate, force_near_earth


def force(g):
    """The force on the car to first order; here ``coriolis`` is horizontal."""
    ground = ground_axes(g)
    return force_near_earth(g.M, -g.v * ground.j, -g.a * ground.j, earth_rate(ground))


def solve(g):
    return {"F_side": force(g).without("relative")}


def steps(g):
    Omega = earth_rate(ground_axes(g))
    return {"Omega": Omega, "a_C": 2 * Omega.cross(-g.v * Omega.frame.j)}


def prove(g):
    """The eastward acceleration of the motion along a meridian, in the inertial frame."""

    def place(t):
        """Coordinates from the axis in the initial meridian plane, east of it, along the axis."""
        lat = g.lat - (g.v * t + g.a * t**2 / 2) / RADIUS
        return at_angle(RADIUS * mp.cos(lat), g.omega_e * t, RADIUS * mp.sin(lat))

    east = second_rate(place)[1]
    return {"F_side": [g.M * east, 0, 0], "a_C": [east, 0, 0]}


def mistakes(g):
    F = solve(g)["F_side"]
    return {
        "to_the_west": {"F_side": -F},
        "no_2": {"F_side": F / 2},
        "cosine": solve(g.but(lat=pi(g.lat) / 2 - g.lat)),
        "whole_rate": solve(g.but(lat=pi(g.lat) / 2)),
        "with_drive": {"F_side": force(g)},
    }


def draw(g, ax):
    ground = Frame("ground")
    s = from_above(ground, ax)
    for x in (-0.5, 0.5):
        s.line((x, -2, 0), (x, 2, 0), style="solid")
    s.line((0, -2, 0), (0, 2, 0))
    s.box((0, 0.6, 0), ground, (0.5, 1, 0.3))
    s.vector((0, 0.1, 0), (0, -1, 0), "v", kind="velocity")
    s.vector((0.3, 0.1, 0), (0, -1, 0), "a", kind="acceleration")
    s.label((0, 0.6, 0), "M", offset=(0, 0), bold=False)
