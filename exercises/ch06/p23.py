"""6/23: the force of a locomotive on its track, on the turning Earth."""

from exercises.devices.turning_earth import RADIUS, axes_turned, from_above, ground_axes
from exercises.tools import minus, plus, scaled, second_rate, times
from newton_euler import Frame, dynamics, pi, sqrt
from newton_euler.applications import coriolis_acceleration, earth_rate


def velocity(g, east=-1):
    """The velocity, northwest by default."""
    return ground_axes(g).vector(east, 1, 0) * (g.v / sqrt(2 * g.one))


def on_track(g, v, share=1):
    """The reaction to the track's force, which balances the weight and gives the Coriolis term."""
    a = -share * coriolis_acceleration(earth_rate(v.frame), v)
    of_track = dynamics.reaction(g.M, a, weight=-g.M * g.g * v.frame.k)
    # a plain vector, so that its terms do not take the names of the other force's
    return {"F_track": v.frame.vector(*(-of_track).components())}


def solve(g):
    return on_track(g, velocity(g))


def steps(g):
    v = velocity(g)
    Omega = earth_rate(v.frame)
    return {"v_rel": v, "Omega": Omega, "a_C": -coriolis_acceleration(Omega, v)}


def prove(g):
    """The straight motion in the inertial frame; the first-order part is odd in the rate."""
    v = scaled(g.v / (2 * g.one) ** 0.5, [-1, 1, 0])

    def acceleration(sense):
        path = lambda t: plus([0, 0, RADIUS], scaled(t, v))
        return second_rate(lambda t: times(axes_turned(g, sense * g.omega_e * t), path(t)))

    a = scaled(g.one / 2, minus(acceleration(1), acceleration(-1)))
    return {"F_track": scaled(-g.M, plus(a, [0, 0, g.g])), "a_C": a, "v_rel": v}


def mistakes(g):
    v = velocity(g)
    right = solve(g)["F_track"]
    return {
        "force_of_the_track": {"F_track": -right},
        "no_vertical": {"F_track": v.frame.vector(right.x, right.y, -g.M * g.g)},
        "no_2": on_track(g, v, share=g.one / 2),
        "northeast": on_track(g, velocity(g, east=1)),
    }


def draw(g, ax):
    ground = Frame("ground")
    s = from_above(ground, ax)
    heading = ground.rotate("locomotive", "z", angle=3 * pi(g.one) / 4)
    along, across = heading.i, heading.j
    for side in (-0.2, 0.2):
        s.line((side * across - 2.4 * along).components(ground),
               (side * across + 2.4 * along).components(ground), style="solid")  # fmt: skip
    s.box((0, 0, 0), heading, (1.2, 0.55, 0.4))
    s.vector((0.6 * along).components(ground), along, "v", kind="velocity")
    s.label((0, 0, 0), "M", offset=(0, 0), bold=False)
