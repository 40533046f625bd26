"""Bodies by integration (5.12), (5.13), (7.10), against Appendix B and mpmath; integrals that do
not converge are refused.
"""

import math

import numpy as np
import pytest
import sympy

from newton_euler import Frame, cos, sin, sqrt
from newton_euler.bodies import MassError, integrated
from newton_euler.bodies import solids as B
from tests.kinds import close

R, H = 0.7, 1.6


def spherical(r, a, b):
    return r * sin(a) * cos(b), r * sin(a) * sin(b), r * cos(a)


F = Frame("body")
WHOLE = (0.0, 2 * math.pi)
NUMERIC = {  # position, limits, and the same body from the table, its axis along z
    "rod": (lambda u: (u, 0, 0), [(0.0, H)], B.rod(H, F.point("C", H / 2, 0, 0), density=2.0)),
    "ring": (lambda a: (R * cos(a), R * sin(a), 0), [WHOLE], B.ring(R, F, "z", density=2.0)),
    "half disk, Cartesian": (
        lambda x, y: (x, y, 0),
        [(-R, R), (0.0, lambda x: sqrt(R * R - x * x))],
        B.half_disk(R, F, "z", "y", density=2.0),
    ),
    "shell": (lambda a, b: spherical(R, a, b), [(0.0, math.pi), WHOLE], B.spherical_shell(R, F, density=2.0)),
    "ball, Cartesian": (
        lambda x, y, z: (x, y, z),
        [
            (-R, R),
            (lambda x: -sqrt(R * R - x * x), lambda x: sqrt(R * R - x * x)),
            (0.0, lambda x, y: sqrt(R * R - x * x - y * y)),
        ],
        B.hemisphere(R, F, "z", density=2.0),
    ),
    "box, backwards": (
        lambda x, y, z: (x, y, z),
        [(3.0, 2.0), (0.0, 1.0), (5.0, 6.0)],
        B.box(1, 1, 1, F.point("C", 2.5, 0.5, 5.5), density=2.0),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", NUMERIC)
def test_eqn_5_12_5_13_and_7_10_numbers(name):
    position, limits, known = NUMERIC[name]
    body = integrated(position, *limits, frame=F, density=2.0)
    assert close(body.mass, known.mass, 1e-10)
    assert close(body.centre.position(F), known.centre.position(F), 1e-10)
    assert close(body.inertia.matrix, known.inertia.matrix, 1e-9)
    assert body.error < 3e-10
    assert close(body.content, known.mass / 2, 1e-10)


def test_the_estimated_error_is_not_smaller_than_the_true_one():
    position, limits, known = NUMERIC["ball, Cartesian"]
    for rtol in (1e-3, 1e-6, 1e-9):
        body = integrated(position, *limits, frame=F, density=2.0, rtol=rtol)
        assert abs(body.mass - known.mass) / known.mass <= body.error <= 2 * rtol


def test_far_from_the_origin_the_moments_about_G_keep_their_digits():
    body = integrated(
        lambda r, a: (1e6 + r * cos(a), r * sin(a), 0), (0.0, 1.0), WHOLE, frame=F, mass=1.0
    )
    assert close(body.inertia.moments, (0.25, 0.25, 0.5), 1e-9)  # m d^2 is 1e12 here


m, r, h, a, b, alpha = sympy.symbols("m r h a b alpha", positive=True)
TURN = (0, 2 * sympy.pi)
CORNERS = (F.point(n, x, y, 0) for n, x, y in (("O", 0, 0), ("B", b, 0), ("H", 0, h)))
FORMULAS = {
    "arc": (lambda t: (r * cos(t), r * sin(t), 0), [(-alpha, alpha)], B.arc(r, alpha, F, "z", "x", mass=m)),
    "half ring": (lambda t: (r * cos(t), r * sin(t), 0), [(0, sympy.pi)], B.half_ring(r, F, "z", "y", mass=m)),
    "shell": (lambda t, u: spherical(r, t, u), [(0, sympy.pi), TURN], B.spherical_shell(r, F, mass=m)),
    "cone": (
        lambda z, s, t: (s * cos(t), s * sin(t), z), [(0, h), (0, lambda z: r * z / h), TURN], B.cone(r, h, F, "z", mass=m)),
    "open cone": (
        lambda z, t: (r * z / h * cos(t), r * z / h * sin(t), z), [(0, h), TURN], B.Body(
            "open cone", m, F.point("G", 0, 0, 2 * h / 3), (*(m * (9 * r**2 + 2 * h**2) / 36,) * 2, m * r**2 / 2))),
    "triangle": (lambda x, y: (x, y, 0), [(0, b), (0, lambda x: h * (1 - x / b))], B.simplex(*CORNERS, mass=m)),
}  # fmt: skip


@pytest.mark.parametrize("name", FORMULAS)
def test_eqn_5_13_and_7_10_in_symbols(name):
    position, limits, known = FORMULAS[name]
    body = integrated(position, *limits, frame=F, mass=m, exact=True)
    found, expected = (
        (*x.about(F).moments, *x.about(F).products, *x.centre.position(F)) for x in (body, known)
    )
    assert all(sympy.simplify(x - y) == 0 for x, y in zip(found, expected, strict=True))
    assert body.error == 0


def test_eqn_5_13_of_the_area_under_a_parabola():
    below = (0, a), (0, lambda x: b * x**2 / a**2)
    body = integrated(lambda x, y: (x, y, 0), *below, frame=F, mass=m, exact=True)
    assert body.content == a * b / 3
    assert body.centre.position(F).components() == (3 * a / 4, 3 * b / 10, 0)
    assert body.about(F).matrix[0][:2] == (m * b**2 / 7, -m * a * b / 4)


def test_what_does_not_converge_is_refused_in_words():
    jump = lambda u, v: (u, v, 0), (0.0, 1.0), (0.0, 1.0)
    quarter = {"frame": F, "density": lambda x, y, z: np.where(x * x + y * y < 0.7, 1.0, 0.0)}
    words = r"did not converge: after \d+ subdivisions .* 1e-10 was asked for. Split the body"
    with pytest.raises(MassError, match=words):
        integrated(*jump, **quarter)
    assert abs(integrated(*jump, **quarter, rtol=1e-3).mass - 0.7 * math.pi / 4) < 2e-3


line, unit = lambda u: (u, 0, 0), (0.0, 1.0)


@pytest.mark.parametrize(("words", "position", "limits", "given"), [
    ("are not finite: look at limits", line, [unit], {"density": lambda x, y, z: 1 / x}),
    (r"needs mass=... or density=...", line, [unit], {}),
    (r"has 0 parameters; a curve has one", lambda: (0, 0, 0), [], {"mass": 1.0}),
    (r"no extent", line, [(1.0, 1.0)], {"mass": 1.0}),
    (r"has points without a (finite )?value", lambda u: (sqrt(u), 0, 0), [(-1.0, 1.0)], {"mass": 1.0}),
    (r"the mass of body is -(1.0|0.99999)", line, [unit], {"density": -1.0}),
    (r"folds back on itself", lambda u: (u**2, 0, 0), [(-1, 1)], {"mass": 1, "exact": True}),
    (r"SymPy finds no formula", line, [(0, h)], {"density": lambda x, y, z: sympy.sin(sympy.sin(x)) + 2, "exact": True}),
])  # fmt: skip
def test_what_is_not_a_body_is_refused_in_words(words, position, limits, given):
    with pytest.raises(MassError, match=words):
        integrated(position, *limits, frame=F, **given)
