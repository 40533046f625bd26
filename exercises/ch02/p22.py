"""2/22: the acceleration on an exponential spiral."""

from exercises.devices import polar_motion
from exercises.tools import mp, on_ground, second_rate, size
from newton_euler import Frame, cos, exp, log, moving, polar, sin


def particle(g):
    """Ground, distance and particle; theta = 0 at r = R."""
    ground, theta = Frame("ground"), moving(0 * g.n, rate=g.omega)
    r = g.R * exp(g.n * theta)
    return ground, r, polar(ground, "P", r, theta)


solve, steps, mistakes = polar_motion.problem_of(particle)


def prove(g):
    """In the complex plane the spiral is one exponential function of time."""
    z = lambda t: g.R * mp.exp(mp.mpc(g.n, 1) * g.omega * t)
    place = lambda t: [z(t).real, z(t).imag, 0]
    a = second_rate(place)
    return {"a": size(a), "a_P": a}


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    O, r_0 = (0, 0, 0), 0.3 * g.R
    total = log(g.R / r_0) / g.n
    r = lambda theta: r_0 * exp(g.n * theta)
    on_path = lambda theta: (r(theta) * cos(theta), r(theta) * sin(theta), 0)
    s.ring(O, ground.k, r_0)
    s.ring(O, ground.k, g.R)
    s.path([on_path(total * n / 80) for n in range(81)])
    s.line(O, (1.25 * g.R, 0, 0))
    here = 0.5 * total
    P, end = on_path(here), on_path(total)
    s.line(O, P, style="solid")
    tip = [1.15 * g.R * x for x in (cos(here), sin(here), 0)]
    s.line(P, tip)
    s.swing(O, tip, ground.k, label=r"$\omega$")
    s.dot(end)
    s.arc(O, (g.R, 0, 0), P, label=r"$\theta$")
    s.dot(P, "P", offset=(sin(here), -cos(here), 0))
    s.label([0.8 * x for x in P], "$r$", offset=(-sin(here), cos(here), 0), bold=False)
    s.dimension(O, (-r_0 * 0.8, -r_0 * 0.6, 0), label="$r_0$", offset=0)
    s.dimension(O, (g.R * 0.5, -g.R * 3**0.5 / 2, 0), label="R", offset=0)
