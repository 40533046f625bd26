"""8/6: an unbalanced wheel, rolling down a slope and about to jump."""

from exercises.tools import Sketch, minus, mp, mpf, plus, rate, root, scaled, second_rate, vanishing
from newton_euler import Frame, atan2, cos, sin, solve_linear, sqrt
from newton_euler.dynamics import acceleration_by, weight


def upright(g):
    """The vector omega^2 OG, x horizontal and y up. Without contact forces there is no moment about
    G, so omega and the velocity of O are constant, and the acceleration of G, which is g, is
    centripetal only.
    """

    def laws(q_x, q_y):
        ground = Frame("ground")
        wheel = ground.rotate("wheel", "z", rate=g.one)
        a_G = wheel.point("G", q_x, q_y, 0).acceleration(ground).expressed_in(ground)
        return a_G - acceleration_by(g.one, weight=weight(g.one, ground.j, g.g))

    found = solve_linear(laws)
    return Frame("ground").vector(found.q_x, found.q_y, 0)


def solve(g):
    q = upright(g)
    return {"v_min": g.r * sqrt(q.norm() / g.e), "phi_G": g.theta + atan2(-q.x, q.y)}


def steps(g):
    q = upright(g)
    return {"a_G": -q.norm(), "omega": sqrt(q.norm() / g.e)}


def contact(g, phi, square):
    """Proof: contact forces along slope and normal, for unit mass, one half on each side of G."""
    v, k = mp.sqrt(square), g.r / 2

    def places(a):
        def motion(t):
            s = v * t + a * t**2 / 2
            c, n = mp.cos(phi - s / g.r), mp.sin(phi - s / g.r)
            G = [s - g.e * n, g.e * c]
            return [[G[0] + k * c, G[1] + k * n], [G[0] - k * c, G[1] - k * n]]

        return motion

    pull = [g.g * mp.sin(g.theta), -g.g * mp.cos(g.theta)]
    # the force on each half besides gravity, and the power of both, which is zero without slip
    missing = lambda a: [scaled(g.one / 2, minus(x, pull)) for x in second_rate(places(a))]
    dot = lambda F, w: sum(x * y for x, y in zip(F, w, strict=True))
    power = lambda a: sum(map(dot, missing(a), rate(places(a))))
    return plus(*missing(vanishing(power, 0, g.g)))


def prove(g):
    """The speed at which the normal force vanishes, where the friction vanishes too."""
    square = lambda phi: vanishing(lambda u: contact(g, phi, u)[1], g.g * g.r, 2 * g.g * g.r)

    def friction(phi):
        F = contact(g, phi, square(phi))[0] / g.g
        return mp.chop(F, mpf(10) ** -20)  # below this, the error of differences in time

    phi = root(friction, mpf(-1), mpf(1.4))
    v = mp.sqrt(square(phi))
    return {"v_min": v, "phi_G": phi, "omega": v / g.r}


def mistakes(g):
    right, square = solve(g), g.g * (g.r**2 + 2 * g.r * g.e * cos(g.theta) + g.e**2) / g.e
    return {
        "G_on_the_normal": {"v_min": g.r * sqrt(g.g * cos(g.theta) / g.e), "phi_G": 0 * g.theta},
        "speed_of_G": {"v_min": sqrt(square)},
        "relative_speed": {"v_min": sqrt(g.g * g.e)},
        "downhill": {"phi_G": -right["phi_G"]},
    }


def draw(g, ax):
    tilt, other = 0.35, 0.9  # angles of the slope and of OG, not the answer's
    ground = Frame("ground")
    slope = ground.rotate("slope", "-z", angle=tilt)
    s = Sketch(ax, ground, plane="xy")
    r, e = 1.0, 0.5
    C = slope.point("O", 0, 0, 0)
    G = slope.point("G", e * sin(other), -e * cos(other), 0)
    left, right = slope.point("left", -2 * r, -r, 0), slope.point("right", 2.4 * r, -r, 0)
    level = ground.translate("level", ground.point("l", *right.position(ground).components()))
    s.road([left, right])
    s.line(right, level.point("m", -2 * r, 0, 0))
    s.arc(right, left, level.point("m", -2 * r, 0, 0), label=r"$\theta$", radius=1.2 * r)
    s.disk(C, ground.k, r)
    s.dimension(C, G, label="e", offset=0)
    s.dimension(C, slope.point("rim", -0.8 * r, 0.6 * r, 0), label="r", offset=0)
    s.vector(C, 1.5 * r * slope.i, "v")
    s.dot(C, "O", offset=(2, 10))
    s.dot(G, "G", offset=(4, -11))
