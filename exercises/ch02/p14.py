"""2/14: a slotted collar driven by a crank."""

from exercises.tools import mp, on_ground, rate, second_rate
from newton_euler import Frame, moving, polar

CASES = 1, 2


def pin(g, case):
    """Velocity and acceleration of P along x, y; C moves like P along x."""
    ground = Frame("ground")
    rates = {1: (g.omega, 0 * g.alpha), 2: (0 * g.omega, g.alpha)}[case]
    P = polar(ground, "P", g.d, moving(g.theta, *rates))
    return P.velocity(ground).expressed_in(ground), P.acceleration(ground).expressed_in(ground)


def solve(g):
    v, a = zip(*(pin(g, case) for case in CASES), strict=True)
    return {"v_1": v[0].x, "a_1": a[0].x, "v_2": v[1].x, "a_2": a[1].x}


def steps(g):
    (v, a), (_, a_too) = (pin(g, case) for case in CASES)
    return {"v_P": v, "a_P1": a, "a_P2": a_too}


def prove(g):
    """The position of P in terms of u = tan(theta/2)."""

    def P(theta):
        u = mp.tan(theta / 2)
        return [g.d * (1 - u**2) / (1 + u**2), 2 * g.d * u / (1 + u**2), 0]

    first = lambda t: P(g.theta + g.omega * t)
    second = lambda t: P(g.theta + g.alpha * t**2 / 2)
    v, a, v_too, a_too = rate(first), second_rate(first), rate(second), second_rate(second)
    answers = {"v_1": v[0], "a_1": a[0], "v_2": v_too[0], "a_2": a_too[0]}
    return answers | {"v_P": v, "a_P1": a, "a_P2": a_too}


def mistakes(g):
    right = solve(g)
    return {
        "speed_of_P": {"v_1": g.d * g.omega},
        "sign": {key: -right[key] for key in ("v_1", "a_1", "a_2")},
        "no_a_1": {"a_1": 0 * right["a_1"]},
        "no_a_2": {"a_2": 0 * right["a_2"]},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    P = polar(ground, "P", g.d, g.theta)
    x = P.position(ground).expressed_in(ground).x
    d, O = g.d, (0, 0, 0)

    def outline(half, low, high):
        return [(x + a * half, b, 0) for a, b in ((-1, low), (1, low), (1, high), (-1, high))]

    s.plate(outline(0.1 * d, -0.1 * d, 1.2 * d), [outline(0.04 * d, 0.18 * d, 1.12 * d)])
    s.axes(O, ground, length=1.6 * d, labels=["x", "", ""])
    s.rod(O, P)
    s.hinge(O)
    s.hinge(P)
    s.arc(O, (d, 0, 0), P, label=r"$\theta$")
    s.swing(O, P, ground.k, label=r"$\dot\theta,\ \ddot\theta$")
    s.dimension(O, P, "d", offset=0.15 * d)
    s.label(O, "O")
    s.label(P, "P", offset=(14, 6))
    s.label((x + 0.1 * d, 0, 0), "C", offset=(10, -10))
