"""The worked examples of Appendix A, over every kind of number."""

import pytest

from newton_euler import Frame, cos, sin, sqrt
from newton_euler.algebra import SingularError
from newton_euler.chapters.examples.appA import plane, triangle, turning_unit_vector
from tests.kinds import close, every_kind, numbers, small

ground = Frame("ground")


@every_kind
def test_example_A_1_a_turning_unit_vector_is_normal_to_its_rate(kind):
    theta, rate = numbers(kind, "0.7", "-3")
    e, e_dot = turning_unit_vector(theta, rate)
    assert close(e, (cos(theta), sin(theta), 0), small(kind, 0.01))
    assert close(e_dot, (-rate * sin(theta), rate * cos(theta), 0), small(kind, 0.01))
    assert close(e.dot(e_dot), 0, small(kind, 0.01))


def points(kind):
    return [
        ground.point(name, *numbers(kind, *c))
        for name, c in (("A", (1, 1, 1)), ("B", (4, 5, 6)), ("C", (2, 3, 7)))
    ]


@pytest.mark.parametrize("kind", ["float", "mpmath", "sympy"])
def test_example_A_2_unit_vectors_and_normal_of_a_triangle(kind):
    AB, AC, normal = triangle(*points(kind))
    one = numbers(kind, 1)
    assert close(AB, [x / (5 * sqrt(2 * one)) for x in (3, 4, 5)], small(kind, 0.01))
    assert close(AC, [x / sqrt(41 * one) for x in (1, 2, 6)], small(kind, 0.01))
    assert close(normal, [x / sqrt(369 * one) for x in (14, -13, 2)], small(kind, 0.01))


@pytest.mark.parametrize("kind", ["float", "mpmath", "sympy"])
def test_example_A_3_plane_through_three_points(kind):
    """14x - 13y + 2z - 3 = 0; the scan prints +13 in the normal, which the result contradicts."""
    a, b, c, d = plane(*points(kind))
    assert close((a, b, c, d), (14, -13, 2, -3), 0)
    for x, y, z in ((1, 1, 1), (4, 5, 6), (2, 3, 7)):
        assert close(a * x + b * y + c * z + d, 0, 0)


def test_three_points_on_a_line_have_no_plane():
    with pytest.raises(SingularError, match="A, B and C lie on one line"):
        triangle(*(ground.point(n, x, 2 * x, 0) for n, x in (("A", 0.0), ("B", 1.0), ("C", 3.0))))
