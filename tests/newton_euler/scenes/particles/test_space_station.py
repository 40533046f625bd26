"""The rotating space station (6.7)."""

import math

import numpy as np
import pytest

from newton_euler import Frame, moving
from newton_euler.chapters.examples.ch06 import rim_speed
from newton_euler.dynamics.newton import relative_acceleration
from newton_euler.scenes.particles.space_station import free_body, station_rate
from tests.kinds import close, every_kind, numbers, small


@every_kind
def test_example_6_7_the_rate_that_simulates_the_ground(kind):
    g, r = numbers(kind, "9.81", 100)
    omega = station_rate(g, r)
    ground = Frame("stars")
    A = ground.rotate("station", "z", rate=-omega).point("A", r, 0, 0)
    assert close(A.acceleration(ground), (-g, 0, 0), small(kind))
    assert close(A.velocity(ground), (0, -rim_speed(g, r), 0), small(kind))


@every_kind
def test_example_6_7_a_free_body_moves_on_a_straight_line_among_the_stars(kind):
    """The exact path against (6.10), using the moving frame."""
    omega, x, y, dx, dy = numbers(kind, "-0.3", 2, "-1.5", "0.4", "0.9")
    _, _, ddx, ddy = free_body(omega).derivative((x, y, dx, dy))
    stars = Frame("stars")
    P = stars.rotate("station", "z", rate=omega).point("P", moving(x, dx), moving(y, dy), 0)
    expected = relative_acceleration(numbers(kind, 1), P, stars)
    assert close((ddx, ddy, 0), tuple(expected), small(kind, 0.1))


def test_example_6_7_a_throw_at_the_opposite_person_misses_behind():
    """A throw from (r, 0) through the centre; omega < 0 as in the book."""
    g, r, u = 9.81, 100.0, 20.0
    omega = -station_rate(g, r)
    model = free_body(omega)
    w = np.array([-u, omega * r])  # among the stars; the thrower moves with the rim
    t = -2 * np.dot(w, [r, 0.0]) / np.dot(w, w)  # when |r + w t| = r again
    x, y, _, _ = model.solution(t, (r, 0.0, -u, 0.0))
    assert math.hypot(x, y) == pytest.approx(r, rel=1e-14)
    assert abs(math.atan2(y, x) - math.pi) > 0.5  # rad: it misses the person at pi
    straight = complex(*(r * np.array([1.0, 0.0]) + w * t))
    assert abs(complex(x, y) * np.exp(1j * omega * t) - straight) < 1e-12 * r


def test_example_6_7_someone_who_runs_against_the_rotation_stands_still_among_the_stars():
    g, r = 9.81, 100.0
    model = free_body(-station_rate(g, r))
    start = (r, 0.0, 0.0, rim_speed(g, r))
    assert close(model.invariant("inertial speed, squared", start), 0, 1e-20)
    path = [model.solution(t, start)[:2] for t in np.linspace(0, 30, 7)]
    assert close([math.hypot(*p) for p in path], [r] * 7, 1e-12)  # along the wall: a circle


def test_example_6_7_book_calls_the_paths_limacons_but_a_throw_through_the_centre_is_a_spiral():
    """Its radius is linear in the angle (Archimedes); a limacon has a + b cos(angle)."""
    omega = 0.5
    model = free_body(omega)
    start = (3.0, 0.0, -1.0, -omega * 3.0)  # w = (-1, 0) among the stars
    t = np.linspace(0.1, 2.9, 8)
    x, y, _, _ = model.solution(t, start)
    distance, angle = np.hypot(x, y), np.unwrap(np.arctan2(y, x))
    assert close(distance, 3.0 + angle / omega, 1e-14)
    columns = np.stack([np.ones_like(angle), np.cos(angle), np.sin(angle)], 1)
    _, residual, *_ = np.linalg.lstsq(columns, distance, rcond=None)
    assert math.sqrt(residual[0]) > 1e-3
