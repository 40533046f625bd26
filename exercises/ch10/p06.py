"""10/6: a space station that precesses free of moments."""

from exercises.devices.steady_precession import frames, orientation
from exercises.tools import Sketch, carried, disk, mean, mp, proofs, raised, vanishing
from newton_euler import bodies, cos, pi
from newton_euler.applications.gyroscopes import free_precession, steady_spin

# the component along OC of a spin about an axis that may point away from it
follows = {"sense": lambda g, phi_dot: by_sign(phi_dot * cos(g.theta) * g.psi_dot)}


def per_mass(g, shape=bodies.cylinder):
    """Transverse and axial moment of inertia per unit mass."""
    I_0, _, I_z = shape(g.R, g.L, frames(g.theta)[1], "z", mass=g.one).inertia.moments
    return I_0, I_z


def spin(g, shape=bodies.cylinder, theta=None):
    theta = g.theta if theta is None else theta
    return steady_spin(*per_mass(g, shape), theta, g.psi_dot, mgr=0)


def solve(g):
    sense = lambda: str(free_precession(*per_mass(g), g.theta, spin(g)).sense)
    return {"phi_dot": whole_rate(g) - g.psi_dot * cos(g.theta), "sense": sense}


def whole_rate(g):
    """The total rate about the axis of symmetry in torque-free precession (10.29)."""
    I_0, I_z = per_mass(g)
    return I_0 / I_z * g.psi_dot * cos(g.theta)


def steps(g):
    I_0, I_z = per_mass(g)
    return {"I": I_z, "I_0": I_0, "omega_z": whole_rate(g)}


def by_sign(along):
    """The answer on the sense, from the component of the spin along OC."""
    return "direct" if along > 0 else "retrograde"


def prove(g):
    """The spin for which the angular momentum is along OC, hence constant."""
    points = raised(disk(g.R, order=2), g.L)

    def off(phi_dot):
        motion = carried(points, orientation(g.theta, g.psi_dot, phi_dot))
        return proofs.angular_momentum(1, motion)[1]

    phi_dot = vanishing(off, 0, g.psi_dot)
    axis = [0, -mp.sin(g.theta), mp.cos(g.theta)]
    omega = proofs.angular_velocity(orientation(g.theta, g.psi_dot, phi_dot))
    return {
        "phi_dot": phi_dot,
        "sense": lambda: by_sign(phi_dot * axis[2] * g.psi_dot),
        "I": mean(lambda r: r[0] ** 2 + r[1] ** 2, points),
        "I_0": mean(lambda r: r[1] ** 2 + r[2] ** 2, points),
        "omega_z": sum(x * y for x, y in zip(omega, axis, strict=True)),
    }


def mistakes(g):
    return {
        "whole_rate": {"phi_dot": whole_rate(g)},
        "shell": {"phi_dot": spin(g, bodies.cylindrical_shell)},
        "no_cosine": {"phi_dot": spin(g, theta=0 * g.theta)},
        "opposite": {"sense": lambda: by_sign(-spin(g))},
    }


def draw(g, ax):
    ground, axes = frames(g.theta, pi(g.theta) / 2)
    s = Sketch(ax, ground, azimuth=-68, elevation=16)
    high = g.L / 2 + 1.4 * g.R  # beyond the body
    O, C, end = axes.origin, (0, 0, high), axes.point("", 0, 0, high)
    A, B = (axes.point("", 0, 0, side * g.L / 2) for side in (-1, 1))
    s.cylinder(A, B, g.R)
    s.line(B, end, style="centre")
    s.line(O, C, style="centre")
    s.arc(O, C, end, label=r"$\theta$", radius=0.9 * high)
    s.turn((0, 0, 0.8 * high), ground.k, label=r"$\dot\psi$")
    s.dimension(A, B, label="L", offset=-1.6 * g.R)
    s.dimension(A, axes.point("", 0, g.R, -g.L / 2), label="R", offset=axes.k * (-0.1 * g.L))
    s.dot(O, "O")
    s.label(C, "C")
