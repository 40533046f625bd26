"""6/16: a particle in a tube that turns in a vertical plane."""

from exercises.tools import DIGITS, Sketch, mp, rate, second_rate
from newton_euler import Frame, cosh, dynamics, moving, polar, sin, sinh
from newton_euler.algebra import at


def distance(g, t):
    """The solution of r'' - r omega^2 = -g sin(omega t), (6.6), from r = a with r' = 0."""
    drop = g.g / (2 * g.omega**2)
    return hyperbolic(g, t) + oscillating(g, t) - drop * sinh(g.omega * t)


def hyperbolic(g, t):
    """The solution without gravity."""
    return g.a * cosh(g.omega * t)


def oscillating(g, t):
    """A particular solution with gravity."""
    return g.g / (2 * g.omega**2) * sin(g.omega * t)


def particle(g, r):
    """Ground, x to the right and y up, and the particle, by its distance as a function of time."""
    ground = Frame("ground")
    return ground, polar(ground, "P", at(r, g.t), moving(g.omega * g.t, rate=g.omega))


def solve(g, r=None, leave_out=()):
    """The force across the tube, for the distance as a function of time."""
    ground, P = particle(g, r or (lambda t: distance(g, t)))
    a = P.acceleration(ground).without(*leave_out)
    return {"F_theta": dynamics.reaction(g.m, a, weight=-g.m * g.g * ground.j).y}


def steps(g):
    r = at(lambda t: distance(g, t), g.t)
    return {"r": r.value, "r_dot": r.rate, "F_C": 2 * g.m * r.rate * g.omega}


def prove(g):
    """r as a power series in t from the equation along the tube; the path is differentiated."""
    r, sine = [g.a, mp.mpf(0)], [mp.mpf(0), g.omega]  # series of r and of sin(omega t)
    for n in range(3 * DIGITS):
        both = (n + 1) * (n + 2)
        r.append((g.omega**2 * r[n] - g.g * sine[n]) / both)
        sine.append(-(g.omega**2) * sine[n] / both)
    distance_at = lambda t: mp.polyval(r[::-1], t)
    place = lambda t: [distance_at(t) * mp.cos(g.omega * t), distance_at(t) * mp.sin(g.omega * t)]
    x, y = second_rate(place, g.t)
    theta = g.omega * g.t
    across = g.m * (-x * mp.sin(theta) + (y + g.g) * mp.cos(theta))
    return {"F_theta": across, "r": distance_at(g.t), "r_dot": rate(distance_at, g.t)}


def mistakes(g):
    def no_square(t):
        """r'' = -g sin(omega t)"""
        return g.a + 2 * oscillating(g, t) - g.g * t / g.omega

    return {
        "no_gravity_along": solve(g, lambda t: hyperbolic(g, t)),
        "no_coriolis": solve(g, leave_out=["coriolis"]),
        "no_centripetal": solve(g, no_square),
        "initial_speed": solve(g, lambda t: hyperbolic(g, t) + oscillating(g, t)),
    }


def draw(g, ax):
    ground, P = particle(g.but(t=0.6 / g.omega), lambda t: 1.2 * g.a + 0 * t)
    s = Sketch(ax, ground, plane="xy")
    O = (0, 0, 0)
    end = P.local.i * 2.2 * g.a
    s.line(O, ground.i * 2 * g.a)
    wall = P.local.j * 0.07 * g.a
    for side in (1, -1):
        start, stop = (P.components(ground) for P in (side * wall, end + side * wall))
        s.line(start, stop, style="solid")
    s.sphere(P, 0.06 * g.a)
    s.hinge(O)
    s.swing(O, end, ground.k, label=r"$\omega$")
    s.arc(O, ground.i, P, label=r"$\theta$")
    s.dimension(O, P, label="r", offset=-0.25 * g.a)
    s.vector(P, -ground.j, "g", kind="acceleration")
    s.label(O, "O", offset=(-12, -12))
    s.label(end.components(ground), "B", offset=(12, 8))
