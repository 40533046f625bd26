"""The rod BE of 2/36 to 2/39 slides along i in a bracket that turns clockwise about A."""

from exercises.devices.turning_plate import motion, motion_steps, proof, turning
from exercises.tools import Sketch, in_frame
from newton_euler import moving


def about(name, side, **rates):
    """The end ``name`` as a function of g, and ``solve``, ``steps``, ``prove`` and ``draw`` for it;
    ``side``: -1 or 1, along i from A. ``rates``: functions of g, for :func:`end`.
    """
    place = lambda g: (side * getattr(g, f"x_{name}"), getattr(g, f"y_{name}"))
    given = lambda g: {rate: of(g) for rate, of in rates.items()}
    this_end = lambda g: end(g, name, *place(g), **given(g))
    return (
        this_end,
        lambda g: motion(*this_end(g)),
        lambda g: motion_steps(*this_end(g), "mm"),
        lambda g: prove(g, name, *place(g), **given(g)),
        lambda g, ax: draw(g, ax, name, *place(g), **given(g)),
    )


def end(g, name, x, y, alpha=None, a_r=None):
    """Ground, and the rod's end; ``alpha`` (clockwise) and ``a_r`` are the rates of omega and u."""
    ground, bracket = turning("bracket", -g.omega, None if alpha is None else -alpha)
    growing = {} if a_r is None else {"acceleration": a_r}
    return ground, bracket.point(name, moving(x, rate=g.u, **growing), y, 0)


def prove(g, name, x, y, alpha=0, a_r=0):
    """Proof by the explicit path of the end."""
    return proof(
        name,
        "bracket",
        lambda t: -g.omega * t - alpha * t**2 / 2,
        lambda t: x + g.u * t + a_r * t**2 / 2,
        lambda t: y,
    )


def without(ground, P, *names):
    """The answer for the acceleration of P without these terms."""
    return in_frame(ground, {f"a_{P.name}": P.acceleration(ground).without(*names)})


def common_mistakes(g, scene, x):
    """The mistakes of 2/36 and 2/39; ``scene(g)`` is the end, ``x`` names its distance from A."""
    return {
        "counterclockwise": motion(*scene(g.but(omega=-g.omega))),
        "no_coriolis": without(*scene(g), "coriolis"),
        "other_end": motion(*scene(g.but(**{x: -getattr(g, x)}))),
    }


def draw(g, ax, name, x, y, alpha=None, a_r=None):
    """The figure; the rod extends equally far on both sides of A.

    Second rates are arrows: ``alpha`` a wider arc, the negative ``a_r`` to the left.
    """
    ground, P = end(g, name, x, y)
    bracket, side, far = P.frame, x / abs(x), abs(x)
    w, A = 0.12 * far, bracket.point("A", 0 * x, 0, 0)
    C, D = (bracket.point(n, a * far, y, 0) for n, a in (("C", -0.5), ("D", 0.5)))
    s = Sketch(ax, ground, plane="xy")
    foot = 0.6 * w
    s.plate([(-foot, -foot, 0), (foot, -foot, 0), (0.62 * far, y, 0), (-0.62 * far, y, 0)],
            shade="light")  # fmt: skip
    s.rod((-far, y, 0), (far, y, 0))
    for G, a in ((C, -0.5), (D, 0.5)):
        s.cylinder((a * far - w, y, 0), (a * far + w, y, 0), 0.5 * w)
        s.label(G, G.name, offset=(0, 17))
    for letter, a in (("B", -far), ("E", far)):
        s.label((a, y, 0), letter, offset=(0, -13))
    s.dot(P)
    s.hinge(A)
    s.axes(A, ground, labels=["i", "j", ""])
    s.turn(A, -ground.k, label=r"$\omega$")
    s.vector((far, y, 0), ground.i, "u")
    if alpha is not None:
        s.turn(A, -ground.k, label=r"$\alpha$", radius=0.45 * far)
    if a_r is not None:
        s.vector((0.9 * far, y - 0.3 * far, 0), -ground.i, "d", kind="acceleration")
    s.label(A, "A", offset=(-4, -22))
    s.line((0.45 * x, 0, 0), (0.9 * x, 0, 0))
    s.dimension((0, y, 0), P, f"$x_{name}$", offset=0.4 * far * side)
    s.dimension((0.9 * x, 0, 0), (0.9 * x, y, 0), f"$y_{name}$", offset=0.1 * x)
