"""The worked example of 11.15, a sphere that rolls down an incline, and the energy balance of a
sphere that slides, then rolls.

Oracles: SciPy on second-order equations of motion, energy by bodies in frames.
"""

import math

import numpy as np
import pytest

from newton_euler import Frame, kinetic_energy, moving
from newton_euler.bodies import sphere
from newton_euler.chapters.examples.ch08 import rolling_begins, sphere_at
from newton_euler.chapters.examples.ch11 import friction_needed, rolling_energy, rolling_speed
from newton_euler.dynamics import audit, kinetic_energy_about, power
from newton_euler.scenes.planar.rolling_sphere import rolling_down
from tests.explicit import integrated
from tests.kinds import close, every_kind, numbers, small


@every_kind
def test_example_11_15_seven_tenths_of_m_v2(kind):
    m, R, v = numbers(kind, 3, "0.2", 2)
    T, unit = rolling_energy(m, R, v), m * v * v
    assert close(T.value, 7 * unit / 10, small(kind))
    assert close((T.terms["translation"], T.terms["rolling"]), (unit / 2, unit / 5), small(kind))


@every_kind
def test_example_11_15_by_a_body_in_a_frame_and_about_the_contact(kind):
    m, R, v, pivoting = numbers(kind, 3, "0.25", 2, 5)
    ground = Frame("ground")
    G, C = ground.point("G", moving(0 * v, v), 0, R), ground.point("C", 0, 0, 0)
    frame = ground.rotate("pivot", "z", rate=pivoting, origin=G).rotate("ball", "y", rate=v / R)
    ball, T = sphere(R, frame, mass=m), rolling_energy(m, R, v, pivoting)
    for found in (kinetic_energy(ball, ground), kinetic_energy_about(ball, C, ground)):
        assert close(found.value, T.value, small(kind))
    # the component that the book leaves out
    assert close(T.terms["pivoting"], m * R * R * pivoting**2 / 5, small(kind))


@every_kind
def test_example_11_15_speed_after_a_drop(kind):
    h, g = numbers(kind, "0.7", 10)
    assert close(rolling_speed(h, g) ** 2, 10 * g * h / 7, 10 * small(kind))
    assert close(rolling_speed(h, g, k=0) ** 2, 2 * g * h, 10 * small(kind))  # in free fall


def test_example_11_15_the_motion_down_the_plane():
    model = rolling_down(0.5, 9.81)
    x, v = model.solution(1.5, (0.0, 0.0))
    assert v == pytest.approx(rolling_speed(x * math.sin(0.5), 9.81), rel=1e-14)
    assert integrated(model, (0.0, 0.0), 1.5)(1.5)["v"] == pytest.approx(v, rel=1e-11)
    assert model.invariant("energy over mass", (x, v)) == pytest.approx(0, abs=1e-13)


def test_example_11_15_the_vertical_plane_is_only_a_limit():
    """Friction needed over normal force grows without bound, which the book does not say."""
    assert friction_needed(math.pi / 4) == pytest.approx(2 / 7)
    assert friction_needed(math.pi / 2 - 1e-6) > 1e5


@pytest.mark.parametrize("v0", [7.0, np.array([2.0, 5.0, 7.0])])
def test_the_books_of_a_sphere_that_slides_and_then_rolls(v0):
    """At the slip v + omega r, 1/7 m v0^2 becomes heat; what stays is that of rolling."""
    m, mu, g, r = 2.0, 0.2, 10.0, 0.5
    begins = rolling_begins(v0, mu, g, r)
    ground = Frame("ground")

    def motion(t):
        _, v, omega = sphere_at(t, v0, mu, g, r)
        G = ground.point("G", moving(0.0 * v, v), r, 0)
        return sphere(r, ground.rotate("ball", "z", rate=omega, origin=G), mass=m)

    def friction(t):
        """Only while there is slip; at the contact point of the ball, which slides on the ground."""
        ball = motion(t)
        turning = ball.frame.angular_velocity(ground)
        contact = ball.centre.velocity(ground) + turning.cross(-r * ground.j)
        return power(-mu * m * g * ground.i, contact)

    energy, breaks = (lambda t: kinetic_energy(motion(t), ground)), np.unique(begins.t).tolist()
    books = audit(energy, 0.0, 2.0, powers={"friction": friction}, breaks=breaks)
    assert books.balances()
    assert np.allclose(books.heat("friction"), m * v0**2 / 7, rtol=1e-12)
    assert np.allclose(energy(2.0).value, 7 / 10 * m * (5 / 7 * v0) ** 2, rtol=1e-14)
    # as if it rolled all the time
    naive = audit(energy, 0.0, 2.0)
    assert not naive.balances()
    assert np.allclose(naive.residual, -m * v0**2 / 7, rtol=1e-12)
