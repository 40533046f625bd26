"""8/18: a quarter of a disk that turns about one of its straight edges."""

from mpmath import mp

from exercises import proofs
from exercises.devices import turning_body
from exercises.devices.turning_body import about_origin, answers, moment_from_momentum, steps_of
from newton_euler import Frame, cos, pi, sin
from newton_euler.bodies import integrated
from newton_euler.drawing import Sketch

PLATE = Frame("plate")
AXIS = "x"


def inertia(g):
    """By integration in polar coordinates."""

    def place(rho, phi):
        return rho * cos(phi), rho * sin(phi), 0

    quarter = integrated(place, (0, g.r), (0, pi(g.one) / 2), frame=PLATE, mass=g.m, name="plate")
    return about_origin(PLATE, [quarter])


def solve(g):
    return answers(g, inertia(g), AXIS)


follows = moment_from_momentum(AXIS)


def steps(g):
    yield from steps_of(g, inertia(g), AXIS)


def prove(g):
    """By mass points on arcs; 24 places of the Gauss rule on each have all digits."""
    with mp.workdps(proofs.DIGITS):
        half = mp.mpf(1) / 2
        points = []
        for share, (u, _, _) in proofs.box(1, 0, 0):
            rho = g.r * (u + half)
            for part, (turn, _, _) in proofs.box(1, 0, 0, order=24):
                phi = mp.pi / 2 * (turn + half)
                place = [rho * mp.cos(phi), rho * mp.sin(phi), 0]
                points.append((2 * (u + half) * share * part, place))
    return turning_body.prove(g, AXIS, plate=turning_body.of_points(g.m, points))


def mistakes(g):
    I = inertia(g)
    quartered = turning_body.added_to_moment(I, AXIS, -3 * I.moments[0] / 4)
    return {
        "no_products": answers(g, turning_body.without_products(I), AXIS),
        "no_rotation": turning_body.no_rotation(g, I, AXIS),
        "quartered": answers(g, quartered, AXIS),
        "wrong_sign": answers(g, turning_body.wrong_sign(I), AXIS),
    }


def draw(g, ax):
    s = Sketch(ax, PLATE, azimuth=-60, elevation=28)
    O, X = (0, 0, 0), (g.r, 0, 0)
    s.plate([O, *s.around(O, X, PLATE.k, 3.14159265 / 2)])
    s.axes(O, PLATE, length=1.4 * g.r)
    s.turn((1.12 * g.r, 0, 0), PLATE.i, r"$\omega$")
    s.dimension(O, X, "r")
    s.label(O, "O")
