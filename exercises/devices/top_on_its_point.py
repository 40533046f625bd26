"""The top of 10/3 and 10/5, which spins on its point O: its data, proof and figure."""

from exercises.annotations import Answers, AnyAxes, Givens, Number, Points, Scalar, Steps
from exercises.devices.steady_precession import frames, of_weights, two_rings, weight_moment
from exercises.tools import Sketch, Step, mean
from newton_euler import dynamics, pi, sqrt
from newton_euler.applications.gyroscopes import FastSpin, SteadyPrecession


def data(g: Givens) -> dict[str, Scalar]:
    """Moments of inertia about O and the moment of the weight, named as in the engine."""
    m = dynamics.mass_from_weight(g.W, g.g)
    ground, axes = frames(g.theta)
    M = weight_moment(m, g.g, ground, axes, g.c)
    return {"I0": m * g.k_x**2, "I": m * g.k_z**2, "theta": g.theta, "moment": M}


def top(g: Givens, **wrong: Scalar) -> dict[str, Scalar]:
    """Arguments for the engine's functions, with wrong ones for a mistake."""
    return data(g) | {"spin": g.phi_dot} | wrong


def two(found: FastSpin | SteadyPrecession) -> Answers:
    """The answers, from the engine's slow and fast precession."""
    return {"psi_slow": found.slow, "psi_fast": found.fast}


def data_steps(g: Givens) -> Steps:
    found = data(g)
    yield Step("I", found["I"], "slug*ft^2", "moment of inertia about the axis of the top, "
               "$W k_z^2/g$", "10.5", "10.17")  # fmt: skip
    yield Step("I_0", found["I0"], "slug*ft^2", "moment of inertia about a transverse axis "
               "through O, $W k_x^2/g$", "10.5", "10.17")  # fmt: skip
    yield Step("M", found["moment"], "lb*ft", r"moment of the weight about O, $W c \sin\theta$",
               "10.6", "10.30")  # fmt: skip


def proof_data(g: Givens) -> tuple[tuple[Number, Points, Number, Number, Number], Answers]:
    """Arguments for the proof, with mass points, and the steps found from these."""
    m, points = g.W / g.g, two_rings(g.k_z, g.k_x, g.c)
    M = of_weights(m, g.g, points, g.theta)
    found = {
        "I": m * mean(lambda r: r[0] ** 2 + r[1] ** 2, points),
        "I_0": m * mean(lambda r: r[1] ** 2 + r[2] ** 2, points),
        "M": M,
    }
    return (m, points, g.theta, g.phi_dot, M), found


def draw(g: Givens, ax: AnyAxes) -> None:
    """The top as a wheel of radius k_z about G, on a thin axle."""
    ground, axes = frames(g.theta, pi(g.theta) / 2)
    s = Sketch(ax, ground, azimuth=-68, elevation=18)
    O, G = axes.origin, axes.point("G", 0, 0, g.c)
    Z, far = (0, 0, 2.4 * g.c), axes.point("", 0, 0, 1.45 * g.c)
    end = axes.point("", 0, 0, 2.3 * g.c)
    s.ground(O, ground.k, size=0.8 * g.c)
    s.line(O, Z, style="centre")
    s.rod(O, G)
    s.disk(G, axes.k, sqrt(2.0) * g.k_z, thickness=0.2 * g.c)
    s.rod(axes.point("", 0, 0, 1.1 * g.c), far)
    s.line(far, end, style="centre")
    s.arc(O, Z, end, label=r"$\theta$", radius=2 * g.c)
    s.turn(axes.point("", 0, 0, 1.65 * g.c), axes.k, label=r"$\dot\phi$")
    s.vector(G, -ground.k * g.W, "W", kind="force")
    s.dimension(O, G, label="c", offset=-1.1 * g.c)
    s.label(Z, "Z")
    s.dot(O, "O")
    s.dot(G, "G")
