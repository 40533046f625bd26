"""6/10: the tension in a pendulum's wire before and after release, for unit weight and length."""

from exercises.tools import mp, on_ground, plus, rate, root, rot, second_rate, size, times
from newton_euler import Frame, cos, moving, polar, sin, solve_linear
from newton_euler.dynamics import resultant_force, weight


def tensions(g):
    """Before the cut, and after it with an unknown theta''; x down, y toward the cord."""
    ground = Frame("ground")
    W = weight(g.one, -ground.i, g.one)

    def held(T, cord):
        wire = polar(ground, "bob", g.one, g.theta).local.i
        return W - T * wire + cord * ground.j

    def released(T, theta_ddot):
        bob = polar(ground, "bob", g.one, moving(g.theta, acceleration=theta_ddot))
        return resultant_force(g.one, bob.acceleration(ground)) + T * bob.local.i - W

    return solve_linear(held).T, solve_linear(released).T


def solve(g):
    before, after = tensions(g)
    return {"k": after / before}


def steps(g):
    before, after = tensions(g)
    return {"T_before": before, "T_after": after}


def prove(g):
    """Stationary energy before; after release, theta_0 - c t^2/2 with the c that conserves it."""
    place = lambda theta: [mp.sin(theta), -mp.cos(theta), 0]
    energy = lambda cord, theta: place(theta)[1] - cord * place(theta)[0]
    slope = lambda cord: rate(lambda theta: energy(cord, theta), g.theta)
    before = size([root(slope, 0, 1000), -1, 0])
    falling = lambda c: lambda t: place(g.theta - c * t**2 / 2)
    # over time, in the limit t = 0
    power = lambda c: second_rate(lambda t: size(rate(falling(c), t)) ** 2 / 2 + falling(c)(t)[1])
    bob = falling(root(power, mp.mpf("0.01"), 10))
    after = times(rot("z", -g.theta), plus(second_rate(bob), [0, 1, 0]))[1]
    return {"k": after / before, "T_before": before, "T_after": after}


def mistakes(g):
    k = solve(g)["k"]
    return {
        "still_at_rest": {"k": k / k},
        "cord_does_nothing": {"k": cos(g.theta)},
        "inverted": {"k": 1 / k},
        "sine": {"k": sin(g.theta) ** 2},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    bob = (sin(g.theta), -cos(g.theta), 0)
    wall = (sin(g.theta) + 0.7, -cos(g.theta), 0)
    s.road([(0.3, 0, 0), (-0.3, 0, 0)])
    s.ground(wall, -ground.i)
    s.line((0, 0, 0), (0, -0.6, 0))
    s.cable((0, 0, 0), bob)
    s.cable(bob, wall)
    s.sphere(bob, 0.05)
    s.arc((0, 0, 0), (0, -1, 0), bob, label=r"$\theta$")
    s.label((bob[0] / 2, bob[1] / 2, 0), "wire", offset=(18, 6), bold=False)
    s.label((bob[0] + 0.35, bob[1], 0), "cord", offset=(0, 10), bold=False)
