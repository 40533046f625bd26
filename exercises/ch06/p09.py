"""6/9: when an object begins to slip on a turning cone; forces per unit mass."""

from exercises.tools import mp, mpf, on_ground, root, rot, second_rate, times
from newton_euler import Frame, cos, cylindrical, sin, solve_linear, sqrt, tan, where
from newton_euler.dynamics import resultant_force, weight


def about_to_slip(g):
    """The highest rate without slip, and the inward acceleration and N at it."""
    ground = Frame("ground")
    P = cylindrical(ground, "P", g.r, 0, 0)
    normal = P.local.vector(sin(g.beta), 0, cos(g.beta))
    up = P.local.vector(-cos(g.beta), 0, sin(g.beta))
    forces = lambda N: weight(g.one, ground.k, g.g) + N * (normal + g.mu * up)
    law = lambda a_n, N: resultant_force(g.one, P.local.i * -a_n) - forces(N)
    a_n, N = solve_linear(law)
    # zero if it slides off even at rest
    return sqrt(where(a_n > 0, a_n, 0 * a_n) / g.r), a_n, N


def solve(g):
    high, *_ = about_to_slip(g)
    return {"omega_ok": (0 * high, high)}


def steps(g):
    _, a_n, N = about_to_slip(g)
    return {"N": N, "F": g.mu * N, "a_n": a_n}


def prove(g):
    """By the contact force on the circle: slip begins where its tangential part reaches mu N."""

    def contact(omega):
        x, _, z = second_rate(lambda t: times(rot("z", omega * t), [g.r, 0, 0]))
        return times(rot("y", -g.beta), [x, 0, z + g.g])  # outward on the surface, and its normal

    def grip(omega):
        along, _, N = contact(omega)
        return g.mu * N - abs(along)

    high = root(grip, 0, 10 * mp.sqrt(g.g / g.r))
    low = mpf(0) if grip(0) > 0 else mp.nan
    along, _, N = contact(high)
    return {"omega_ok": [low, high], "N": N, "F": -along}


def mistakes(g):
    high = lambda a_n: sqrt(a_n / g.r)
    up_to = lambda a_n: {"omega_ok": (0 * high(a_n), high(a_n))}
    return {
        "N_at_rest": up_to(g.g * (g.mu - tan(g.beta))),
        "along_surface": up_to(g.g * (g.mu * cos(g.beta) - sin(g.beta))),
        "turntable": solve(g.but(beta=0 * g.beta)),
        "bowl": solve(g.but(beta=-g.beta)),
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    out = 1.7 * g.r  # the radius of the base
    low = out * tan(g.beta)
    foot = (0, 0, -low - 0.3 * out)
    apex, rim = (0, 0, 0), (out, 0, -low)
    size = 0.16 * g.r
    x = g.r - size / 2 * sin(g.beta)  # so that the middle of the object is at r
    touched = ground.point("P", x, 0, -x * tan(g.beta))
    surface = ground.rotate("surface", "y", g.beta, origin=touched)
    P = surface.point("P", 0, 0, size / 2)
    s.ground(foot, normal=ground.k)
    s.shaft(foot, (0, 0, -low))
    s.cone(apex, -ground.k, low, out)
    s.box(P, surface, (1.6 * size, size, size))
    s.line((0, 0, -low), (0, 0, 0.75 * g.r), style="centre")
    s.turn((0, 0, 0.35 * g.r), ground.k, label=r"$\omega$")
    s.dimension((0, 0, 0.62 * g.r), (g.r, 0, 0.62 * g.r), label="r", offset=0.0)
    s.line((g.r, 0, 0.66 * g.r), P, style="solid")
    s.arc(rim, (0, 0, -low), apex, label=r"$\beta$")
