"""11/15: a collar driven outward by a spring on a rod that turns freely about the vertical."""

from exercises.tools import mp, on_ground, until
from newton_euler import Frame, kinetic_energy, moving, particle, root, solve_rates, sqrt
from newton_euler.dynamics import angular_momentum, spring_potential

follows = {
    "v_r": lambda g, omega_B: sqrt(speed(g) ** 2 - (g.r_B * omega_B) ** 2),
    "v_theta": lambda g, omega_B: g.r_B * omega_B,
}


def collar(g, r, v_r, omega):
    """The ground with z up along the shaft, and the collar at r on the rod that turns at omega."""
    ground = Frame("ground")
    rod = ground.rotate("rod", "z", rate=omega)
    return ground, particle(g.W / g.g, rod.point("collar", moving(r, rate=v_r), 0, 0), "collar")


def momentum(g, r, omega):
    """The angular momentum about the shaft, which exerts no moment about its axis."""
    ground, body = collar(g, r, 0, omega)
    return angular_momentum(body, ground, ground).expressed_in(ground).z


def turning(g, r):
    """The rate of the rod when the collar is at r."""
    (omega,) = solve_rates(lambda omega: momentum(g, r, omega) - momentum(g, g.r_A, g.omega_A), 1)
    return omega


def kinetic(g, r, v_r, omega):
    return kinetic_energy(*reversed(collar(g, r, v_r, omega))).value


def potential(g, r):
    return spring_potential(g.k, r - g.l_0)


def energy(g):
    return kinetic(g, g.r_A, 0, g.omega_A) + potential(g, g.r_A)


def speed(g):
    """The speed of the collar at B."""
    return sqrt(2 * (energy(g) - potential(g, g.r_B)) / (g.W / g.g))


def answers(g, rate):
    """The answers; ``rate``: of the rod, as a function of r."""

    def surplus(r):
        """The kinetic energy of the radial motion."""
        return energy(g) - potential(g, r) - kinetic(g, r, 0, rate(r))

    omega_B = rate(g.r_B)
    v_theta = g.r_B * omega_B
    return {
        "omega_B": omega_B,
        "v_r": sqrt(speed(g) ** 2 - v_theta**2),
        "v_theta": v_theta,
        "r_max": root(surplus, g.r_B, 3 * g.l_0),
    }


def solve(g):
    return answers(g, lambda r: turning(g, r))


def steps(g):
    spring = {"V_A": potential(g, g.r_A), "V_B": potential(g, g.r_B)}
    return {"H_O": momentum(g, g.r_A, g.omega_A), **spring, "E": energy(g), "v_B": speed(g)}


def prove(g):
    """The collar's rectangular coordinates over time, under the spring alone."""
    m = g.W / g.g

    def rates(state):
        x, y, *v = state
        r = mp.sqrt(x * x + y * y)
        a = -g.k * (r - g.l_0) / (m * r)
        return [*v, a * x, a * y]

    distance = lambda state: mp.hypot(*state[:2])
    outward = lambda s: (s[0] * s[2] + s[1] * s[3]) / distance(s)
    across = lambda s: (s[0] * s[3] - s[1] * s[2]) / distance(s)
    start, step = [g.r_A, 0, 0, g.r_A * g.omega_A], 1 / (4 * g.omega_A)
    _, B = until(rates, start, lambda state: distance(state) - g.r_B, step)
    _, farthest = until(rates, B, outward, step)
    return {
        "omega_B": across(B) / distance(B),
        "v_r": outward(B),
        "v_theta": across(B),
        "r_max": distance(farthest),
        "v_B": mp.hypot(*B[2:]),
        "H_O": m * distance(farthest) * across(farthest),
    }


def mistakes(g):
    return {
        "rod_driven": {"omega_B": g.omega_A, "v_theta": g.r_B * g.omega_A},
        "linear_momentum": answers(g, lambda r: g.omega_A * g.r_A / r),
        "at_rest": {"r_max": answers(g, lambda r: 0 * g.omega_A)["r_max"]},
        "whole_speed": {"v_r": speed(g)},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    r, z = g.r_B, ground.k
    A, B, top = (g.r_A, 0, 0), (g.r_B, 0, 0), (0, 0, 0.45 * r)
    s.shaft((0, 0, -0.4 * r), top)
    s.rod((0, 0, 0), (1.2 * r, 0, 0))
    s.ground((0, 0, -0.4 * r), z)
    s.hinge((0, 0, -0.25 * r), axis=z)
    size = 0.09 * r
    s.spring((0, 0, 0), (g.r_A - size / 2, 0, 0), radius=0.035 * r)
    s.box(A, ground, (size, size, 1.5 * size))
    cord = 0.05 * r
    s.line((0, 0, cord), (g.r_A - size / 2, 0, cord), style="solid")
    s.label((g.r_A / 2, 0, cord), "cord", offset=(0, 9), bold=False)
    s.turn((0, 0, 0.35 * r), z, label=r"$\omega_A$")
    s.dimension((0, 0, 0), A, label="$r_A$", offset=-0.16 * r)
    s.dimension((0, 0, 0), B, label="$r_B$", offset=-0.3 * r)
    s.label((g.r_A, 0, 0.75 * size), "A", offset=(0, 10))
    s.dot(B, "B", offset=(0, 12))
