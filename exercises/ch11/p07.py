"""11/7: a linkage of two pairs of links, folding down on a spring."""

from exercises.tools import minus, mp, on_ground, until
from newton_euler import Frame, acos, atan2, cos, sin, sqrt


def scene(g, theta, side=1):
    """Ground, y up from O; the knee K, right of the shaft (left with side -1); the collar C."""
    ground = Frame("ground")
    # so that C is above O: along the lower link it is a - b cos(theta) from O, b sin(theta) across
    lean = atan2(g.b * sin(theta), g.a - g.b * cos(theta))
    lower = ground.rotate("lower link", "z", angle=-side * lean)
    K = lower.point("K", 0, g.a, 0)
    upper = lower.rotate("upper link", "z", angle=-side * theta, origin=K)
    return ground, K, upper.point("C", 0, -g.b, 0)  # from KO, turned by theta


def height(g):
    """p, q and the collar's height h: k h^2/2 - p h + q = 0 is the energy equation times h/x."""
    p = g.k * (g.a + g.b) / 2 - (g.m_c + g.m_b) * g.g
    q = g.m_b * g.g * (g.b - g.a)
    return p, q, (p + sqrt(p**2 - 2 * g.k * q)) / g.k


def solve(g):
    return folded(g, height(g)[2])


def steps(g):
    p, q, h = height(g)
    return {"p": p, "q": q, "h": h}


def prove(g):
    """The power of the forces, per rate of the lower links, integrated along the motion until the
    work returns to zero. The velocity of the collar is about the instantaneous centre of an upper
    link, at the height of the collar on the line of the lower link.
    """
    ball = lambda lean: [g.a * mp.sin(lean), g.a * mp.cos(lean)]
    collar = lambda x, y: y + mp.sqrt(g.b**2 - x**2)

    def power(state):
        """The power of the collar's weight, of the balls' and of the spring."""
        x, y = ball(state[0])
        h = collar(x, y)
        # the centre is (x h/y, h), and both of its distances are multiplied by y
        sinks = x * h / (h - y)
        push = g.k * (g.a + g.b - h)
        return [1, (g.m_c * g.g - push) * sinks + 2 * g.m_b * g.g * x]

    nothing = 0 * g.a
    _, (lean, _) = until(power, [nothing] * 2, lambda s: s[1], nothing + 1 / 8)
    x, y = ball(lean)
    h = collar(x, y)
    down, up = minus([0, 0], [x, y]), minus([0, h], [x, y])
    cosine = sum(p * q for p, q in zip(down, up, strict=True)) / (g.a * g.b)
    return {"theta": mp.acos(cosine), "h": h}


def folded(g, h):
    """The angle at the knee with the collar at the height h, by the law of cosines."""
    return {"theta": acos((g.a**2 + g.b**2 - h**2) / (2 * g.a * g.b))}


def mistakes(g):
    weight = (g.m_c + 2 * g.m_b) * g.g
    return {
        "balance_of_forces": folded(g, g.a + g.b - weight / g.k),
        "one_ball": solve(g.but(m_b=g.m_b / 2)),
        "balls_drop_with_collar": folded(g, g.a + g.b - 2 * weight / g.k),
        "no_collar": solve(g.but(m_c=0 * g.m_c)),
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    O, unit = (0, 0, 0), 0.06 * (g.a + g.b)
    s.ground((0, -unit, 0), ground.j)
    s.shaft((0, -unit, 0), (0, g.a + g.b, 0))
    for side in (1, -1):
        base, *joints = scene(g, 2.3, side)  # at any angle
        knee, top = (P.position(base).components() for P in joints)
        s.rod(O, knee, top)
        s.sphere(knee, 0.6 * unit)
        s.label(knee, "$m_b$", offset=(side * 20, 0), bold=False)
    s.arc(knee, O, top, label=r"$\theta$")
    for end, name, down in ((O, "a", -1), (top, "b", 1)):  # beside the links of the right side
        middle = [(p + q) / 2 for p, q in zip(end, (-knee[0], *knee[1:]), strict=True)]
        s.label(middle, name, offset=(12, 8 * down), bold=False)
    low, high = (0, 0.3 * unit, 0), (0, top[1] - unit / 2, 0)
    s.spring(low, high, radius=0.45 * unit, coils=12)
    s.box(top, ground, (1.6 * unit, unit, unit))
    s.hinge(O)
    s.label(O, "O", offset=(-16, -4))
    s.label(top, "$m_c$", offset=(26, 6), bold=False)
    s.label((0, top[1] / 2, 0), "k", offset=(18, 0), bold=False)
