"""4/26: the drum of a flight simulator, which tilts in a frame that turns about the vertical."""

from exercises.tools import Sketch, mp, proofs, rot, spun, terms, times, transposed
from newton_euler import Frame, pi


def simulator(g):
    """Ground with z up; then the fork about z, the mounting about x, the drum about y (or e)."""
    ground = Frame("ground")
    fork = ground.rotate("fork", "z", rate=g.Omega)
    mounting = fork.rotate("mounting", "x", angle=g.theta, rate=g.theta_dot)
    return ground, fork, mounting, mounting.rotate("drum", "y", rate=g.P)


def turns(g):
    """Omega, theta_dot and P as vectors along the axes of the fork, with their rates."""
    ground, fork, mounting, drum = simulator(g)
    pairs = (fork, ground), (mounting, fork), (drum, mounting)
    return ground, *(one.angular_velocity(other).expressed_in(fork) for one, other in pairs)


def alpha_of(ground, *turns):
    return sum(turns[1:], turns[0]).rate(ground)


def solve(g):
    # by (4.12) along the axes of the fork, for a short formula
    return {"alpha_drum": alpha_of(*turns(g))}


def steps(g):
    _, _, mounting, _ = simulator(g)
    _, Omega, theta_dot, P = turns(g)
    yield "e", mounting.j.expressed_in(mounting.parent)
    yield "omega_axes", Omega
    yield "omega_drum", Omega + theta_dot + P
    yield from terms(solve(g)["alpha_drum"], "alpha_drum", "rad/s^2", "4.6")


def prove(g):
    theta = lambda t: g.theta + g.theta_dot * t
    tilted = lambda t: spun([0, mp.cos(theta(t)), mp.sin(theta(t))], [1, 0, 0], g.P * t)
    drum = lambda t: times(rot("z", g.Omega * t), tilted(t))
    return {
        "alpha_drum": proofs.angular_acceleration(drum),
        "omega_drum": proofs.angular_velocity(drum),
        "e": transposed(drum(0))[0],
    }


def mistakes(g):
    ground, Omega, theta_dot, P = turns(g)
    alpha = alpha_of(ground, Omega, theta_dot, P)
    return {
        "no_fork_x_mounting": {"alpha_drum": alpha - Omega.cross(theta_dot)},
        "e_fixed_in_the_frame": {"alpha_drum": alpha.without("relative")},
        "alpha_zero": {"alpha_drum": alpha.without(*alpha.terms)},
        "theta_from_the_vertical": solve(g.but(theta=pi(g.theta) / 2 - g.theta)),
    }


def draw(g, ax):
    ground, fork, mounting, _ = simulator(g)
    s = Sketch(ax, ground, azimuth=25, elevation=18)
    arms = [(fork.point("", x, 0, 0), fork.point("", x, 0, -1)) for x in (-0.6, 0.6)]
    O, foot, top = fork.point("", 0, 0, 0), fork.point("", 0, 0, -1.6), fork.point("", 0, 0, -1)
    e = mounting.point("", 0, 1.2, 0)
    s.cylinder(mounting.point("", 0, -0.35, 0), mounting.point("", 0, 0.35, 0), 0.3)
    for pin, low in arms:
        s.rod(0.5 * pin.position(ground), pin, low)
    s.rod(arms[0][1], arms[1][1])
    s.shaft(foot, top)
    s.ground(foot, ground.k)
    s.axes(O, fork, length=1.2)
    s.line(O, e, style="dashed")
    s.arc(O, fork.point("", 0, 1, 0), e, label=r"$\theta$", radius=0.75)
    s.turn(fork.point("", 0, 0, -1.35), fork.k, label=r"$\Omega$")
    s.turn(arms[1][0], fork.i, label=r"$\dot\theta$")
    s.turn(mounting.point("", 0, 0.95, 0), mounting.j, label="P")
    s.label(e, "e")
