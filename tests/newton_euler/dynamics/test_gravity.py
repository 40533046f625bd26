"""Gravitation and weight (5.20)-(5.27); the oracle for the attraction of a planet is the sum over
its mass points.
"""

import numpy as np
import pytest
import sympy

from newton_euler import Dimension, Frame, compiled, particle
from newton_euler.algebra import FrameError, ScalarError
from newton_euler.bodies import MassError
from newton_euler.dynamics import (
    attraction,
    gravitation,
    gravitational_field,
    gravity_at_height,
    gravity_at_surface,
    mass_from_weight,
    weight,
)
from newton_euler.dynamics.gravity import K
from tests.kinds import close, every_kind, number, numbers, within

small = within(1e-14, 27)


@every_kind
def test_eqn_5_20_and_5_21_two_particles_attract_each_other_with_opposite_forces(kind):
    m1, m2, k, x, y = numbers(kind, 3, 2, "0.5", 2, "1.5")
    space = Frame("space")
    a = particle(m1, space.point("A", x, 0, 0), "A")
    b = particle(m2, space.point("B", 0, y, 0), "B")
    on_a, on_b, way = gravitation(a, b, K=k), gravitation(b, a, K=k), b.centre - a.centre
    assert close(on_a, -on_b, small(kind))
    assert close(on_a.cross(way), (0, 0, 0), small(kind))  # along the line that joins them
    assert np.all(number(on_a.dot(way)) > 0)  # toward the other body
    square, force = x * x + y * y, on_a.norm()
    assert close(force * square, k * m1 * m2, small(kind, 10))
    assert close(force * force, attraction(m1, m2, 1, k) ** 2 / (square * square), small(kind, 10))


@every_kind
def test_eqn_5_22_and_5_23_the_field_of_a_planet_is_the_force_on_a_unit_mass(kind):
    M, m, k, x, y, z = numbers(kind, 30, 2, "0.5", 1, 2, -2)
    space = Frame("space")
    planet = particle(M, space.origin, "planet")
    P = space.point("P", x, y, z)
    g = gravitational_field(P, M, space, k)
    assert close(m * g, gravitation(particle(m, P), planet, K=k), small(kind, 10))
    distance = 3 * x  # (1, 2, 2)
    assert close(distance**3 * g, [-k * M * c for c in (x, y, z)], small(kind, 1000))


def test_a_radially_symmetric_planet_attracts_like_a_particle():
    """(5.22) against the sum over the mass points of a ball whose density falls outward."""
    nodes, w = np.polynomial.legendre.leggauss(40)
    r, wr = (nodes + 1) / 2, w / 2
    mu, wm = nodes, w  # cosine of the angle from the direction of P
    rho = 2.0 - r
    masses = 2 * np.pi * (wr * rho * r**2)[:, None] * wm[None, :]
    x, across = r[:, None] * mu, r[:, None] * np.sqrt(1 - mu**2)
    for d in (1.5, 3.0):
        pull = (masses * (d - x) / ((d - x) ** 2 + across**2) ** 1.5).sum()
        assert abs(pull - attraction(masses.sum(), 1.0, d, 1.0)) < 1e-11


@every_kind
def test_eqn_5_24_gravity_from_mass_and_radius(kind):
    M, R, k = numbers(kind, 30, 3, "0.5")
    assert close(gravity_at_surface(M, R, k) * R * R, k * M, small(kind, 20))


def test_eqn_5_24_gives_the_book_s_gravity_of_the_earth():
    """From the largest to the smallest radius; the book has 9.79 to 9.83 m/s^2."""
    least, mean = (gravity_at_surface(5.972e24, radius) for radius in (6378.137e3, 6371e3))
    assert 9.79 < least < mean < 9.833
    assert abs(gravity_at_surface(5.972e24, 6371e3) - 9.818) < 1e-3
    assert K == 6.673e-11


@every_kind
def test_gravity_at_height_falls_with_the_square_of_the_distance(kind):
    M, R, k, h = numbers(kind, 30, 3, "0.5", "0.75")
    at_surface = gravity_at_surface(M, R, k)
    assert close(
        gravity_at_height(h, R, at_surface), gravity_at_surface(M, R + h, k), small(kind, 10)
    )


@every_kind
def test_eqn_5_25_to_5_27_weight(kind):
    m, g = numbers(kind, "2.5", "9.81")
    ground = Frame("ground")
    assert close(weight(m, ground.k, g), (0, 0, -m * g), small(kind, 10))  # (5.27)
    assert close(
        weight(particle(m, ground.origin), 7 * ground.j, g), (0, -m * g, 0), small(kind, 10)
    )
    assert close(mass_from_weight(m * g, g), m, small(kind))  # (5.26)
    assert close(weight(m, ground.k, g).norm(), m * g, small(kind, 10))


@pytest.mark.parametrize("size", [1e-300, 1e-120, 1e120, 1e300])
def test_masses_and_distances_of_any_size(size):
    assert attraction(size, size, size, 1.0) == pytest.approx(1.0, rel=1e-15)
    space = Frame("space")
    ball, star = particle(size, space.origin), particle(size, space.point("P", 0, size, 0))
    assert gravitation(ball, star, K=1.0).y == pytest.approx(1.0, rel=1e-15)
    field = gravitational_field(space, size, star.centre, K=1.0)
    assert field.y == pytest.approx(1 / size, rel=1e-15)


def test_dimensions_and_compiling():
    mass, length, k = Dimension(1), Dimension(0, 1), Dimension(-1, 3, -2)
    assert attraction(mass, mass, length, k) == Dimension(1, 1, -2)
    assert gravity_at_height(length, length, Dimension(0, 1, -2)) == Dimension(0, 1, -2)

    def force(m, x, k):
        space = Frame("space")
        return gravitation(
            particle(m, space.origin), particle(2 * m, space.point("P", x, x, 0)), K=k
        )

    assert close(compiled(force)(1.5, 0.3, 2.0), tuple(force(1.5, 0.3, 2.0)), 1e-13)
    assert force(mass, length, k).x == Dimension(1, 1, -2)
    r = sympy.Symbol("r", positive=True)
    assert sympy.diff(attraction(1, 1, r, 1), r) == -2 / r**3


@pytest.mark.parametrize(("ask", "error", "words"), [
    (lambda P: gravitation(P, P), MassError, r"the distance of P and P must be positive, got 0"),
    (lambda P: attraction(1.0, 1.0, -1.0), MassError, r"distance of the two bodies must be positive, got -1.0"),
    (lambda P: weight(1.0, "up"), FrameError, "weight: up is a Vector"),
    (lambda P: weight("heavy", P.frame.k), ScalarError, "weight: body is a Body.* or a number"),
    (lambda P: gravity_at_height(1.0, 0.0), MassError, "radius of the planet must be positive"),
])  # fmt: skip
def test_masses_distances_and_frames_that_make_no_sense_are_refused(ask, error, words):
    with pytest.raises(error, match=words):
        ask(particle(1.0, Frame("ground").origin, "P"))
