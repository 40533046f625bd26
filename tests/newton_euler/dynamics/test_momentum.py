"""Chapter 8, (8.1)-(8.21), with examples. The oracle: a body of mass points in explicit motion."""

import pytest

from newton_euler import Dimension, Frame, compiled, moving, sin
from newton_euler.bodies.solids import rod, sphere
from newton_euler.dynamics.force_systems import ForceSystem
from newton_euler.dynamics.momentum import angular_momentum, equations_of_motion, resultant_moment
from newton_euler.kinematics import along
from newton_euler.kinematics.rotations import apply, product, rotation_matrix
from tests.kinds import every_kind, number, numbers, within
from tests.tumbling import MASSES, close, free_body, path, turns

small = within(1e-12, 20)


def expected(kind, q, about, part, differences):
    """The sum of d_i x m_i times a rate of d_i (``differences``) or of each particle's position, in
    ground components: explicit positions, differentiated by the product rule.
    """
    like = "array" if kind == "array" else "mpmath"
    a, b, c, t = q if kind == "array" else map(number, q)
    angles = list(zip(((0, 0, 1), (1, 0, 0), (0, 3, 4)), turns(a, b, c), strict=True))

    def carried(r, count):
        """A point with coordinates r(s) in the frame after this many turns."""

        def where(s):
            matrices = (rotation_matrix(axis, angle(s)) for axis, angle in angles[:count])
            turned = apply(product(*matrices), r(s))
            return [x + p(s) for x, p in zip(turned, path(a, b, c), strict=True)]

        return where

    fixed = lambda *x: carried(lambda s: numbers(like, *x), 3)
    places = [(numbers(like, m), fixed(*x)) for m, x in MASSES]
    B = {
        "G": lambda s: [sum(m * P(s)[n] for m, P in places) / sum(m for m, _ in places) for n in range(3)],
        "body": fixed("1/2", -1, "1/3"),
        "rest": lambda s: numbers(like, 1, 2, -1),
        "drift": lambda s: [x * (1 + s - t) for x in numbers(like, 2, "1/3", -1)],
        "any": carried(lambda s: (b + s * s, c * s**3, sin(a * s)), 2),
    }[about]  # fmt: skip
    total = [0, 0, 0]
    for m, P in places:
        arm = along(lambda s, P=P: [x - y for x, y in zip(P(s), B(s), strict=True)], t)
        d = [x.value for x in arm]
        f = [m * getattr(x, part) for x in (arm if differences else along(P, t))]
        total = [x + d[n - 2] * f[n - 1] - d[n - 1] * f[n - 2] for n, x in enumerate(total)]
    return tuple(total)


@every_kind
@pytest.mark.parametrize("about", ["G", "body", "rest", "any"])
def test_eqn_7_6_relative_angular_momentum_about_any_point_is_that_of_its_particles(kind, about):
    ground, _, body, points, q = free_body(kind)
    H = angular_momentum(body, ground, points.get(about))
    assert close(H.components(ground), expected(kind, q, about, "rate", True), 10 * small(kind))


@every_kind
@pytest.mark.parametrize("about", ["G", "body", "rest", "drift", "any"])
def test_eqn_8_8_to_8_11_moment_of_motion_about_any_point_is_that_of_the_particles(kind, about):
    """M_B = sum of d_i x m_i a_i (8.8) against DH/Dt + d x m a_B (8.9)."""
    ground, carrier, body, points, q = free_body(kind)
    by_particles = expected(kind, q, about, "acceleration", False)
    for via in (None, carrier, ground):
        M = resultant_moment(body, ground, points.get(about), via)
        assert close(M.components(ground), by_particles, 10 * small(kind))
        if kind == "sympy":
            # H differentiated term by term is a long formula; the other kinds show that it
            # agrees
            continue
        H, via = angular_momentum(body, ground, points.get(about)), via or body.frame
        assert close(M.terms["relative"], H.expressed_in(via).rate(via), 10 * small(kind))
        assert close(M.terms["rotation"], via.angular_velocity(ground).cross(H), 10 * small(kind))
        assert close(sum(list(M.terms.values())[1:], M.terms["relative"]), M, 10 * small(kind))
        assert list(M.terms) == (
            ["relative", "rotation"] if about == "G" else ["relative", "rotation", "reference"]
        )


def test_the_reference_term_matters_except_in_the_three_cases_of_the_book():
    ground, _, body, points, _ = free_body("float")
    for name, point in points.items():
        reference = resultant_moment(body, ground, point).terms["reference"]
        assert (reference.norm() > 1) == (name in ("body", "any"))
    B = ground.point("on the line of a_G", *(moving(0.0, 0.0, 2 * x) for x in (1.0, 2.0, 3.0)))
    ball = sphere(1.0, ground.point("G", *(moving(x, 0.1, 0.2) for x in (0.5, 1.0, 1.5))), mass=2.0)
    along = resultant_moment(ball, ground, B).terms["reference"]  # d parallel to a_B
    assert along.norm() < 1e-12


@every_kind
def test_eqn_8_1_to_8_3_places_and_rates_relative_to_b(kind):
    ground, _, body, points, _ = free_body(kind)
    B, G = points["any"], body.centre
    seen = lambda P: (P.velocity(ground), P.acceleration(ground))
    for P in (part.centre for part in body.parts):
        d, d_G, rho = (v.expressed_in(ground) for v in (P - B, G - B, P - G))
        assert close(d, d_G + rho, small(kind))
        rates = (P - B).rate(ground), (P - B).rate(ground).rate(ground)
        for rate_, of_P, of_B in zip(rates, seen(P), seen(B), strict=True):
            known = of_P.expressed_in(ground) - of_B
            assert close(rate_.components(ground), known, 10 * small(kind))


@every_kind
def test_eqn_8_21_newton_euler_equations_vanish_for_the_forces_of_the_motion(kind):
    """Each particle is driven by its own force m_i a_i."""
    ground, _, body, points, _ = free_body(kind)
    forces = ForceSystem(
        {p.name: (p.centre.acceleration(ground) * p.mass, p.centre) for p in body.parts}, ground
    )
    for about in (None, *points.values()):
        for v in equations_of_motion(body, forces, ground, about).values():
            assert close(v, (0, 0, 0), 10 * small(kind))
    names = list(equations_of_motion(body, forces, ground, points["rest"]))
    assert names == ["force on body", "moment on body about C"]


def test_momentum_and_moments_have_their_units_and_can_be_compiled():
    def moments(m, length, w, a):
        ground = Frame("ground")
        frame = ground.rotate("bar", "z", 0.3, w, a)
        bar = rod(length, frame.point("G", length, 0, 0), "x", mass=m)
        B = frame.point("B", length, length, length)
        M = [resultant_moment(bar, ground, *about) for about in ((B,), ())]
        return angular_momentum(bar, ground, B), *M

    M, L, T = Dimension(1), Dimension(0, 1), Dimension(0, 0, 1)
    units = (M * L * L / T, M * L * L / (T * T), M * L * L / (T * T))
    for vector, unit in zip(moments(M, L, 1 / T, 1 / (T * T)), units, strict=True):
        assert all(x in (0, unit) for x in vector)
    numbers_ = (2.0, 0.5, 3.0, -1.0)
    assert close(compiled(moments)(*numbers_), [tuple(v) for v in moments(*numbers_)], 1e-13)


def test_a_symbol_with_an_index_is_put_in_braces_before_the_index_that_says_of_what():
    ground, _, body, points, _ = free_body("float")
    latex = resultant_moment(body, ground, points["any"]).explain().latex
    assert r"{\mathbf{M}_B}_{\text{of body" in latex  # MathJax refuses a double subscript


def test_explanations_name_the_equation_and_its_terms():
    ground, _, body, points, _ = free_body("float")
    M = resultant_moment(body, ground, points["any"])
    text = str(M.explain("N m"))
    words = (
        "moment of body about E, seen from ground, by way of body, equation (8.9), components in"
    )
    assert text.startswith(words)
    assert "reference  d x m a_B" in text
    assert r"\tag{8.10}" in resultant_moment(body, ground).explain().latex
    assert M.without("reference").norm() != M.norm()
