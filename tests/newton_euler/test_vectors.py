"""Appendix A in components, and the ledger that a vector keeps of its terms."""

import math

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from newton_euler import Dimension, Frame, Vector, compiled, cross, dot, moving
from newton_euler.algebra import Explanation, FrameError, ScalarError, same
from tests.kinds import KINDS, close, numbers

ground = Frame("ground")
turned = ground.rotate("turned", (1, 2, 2), 0.7)
reals = st.floats(-1e3, 1e3)
triples = st.tuples(reals, reals, reals)


def vectors(kind):
    a, b = numbers(kind, 1, "-2/3", "1/2"), numbers(kind, 2, "1/4", -3)
    return ground.vector(*a), ground.vector(*b), a, b


@pytest.mark.parametrize("kind", KINDS)
def test_eqn_A_11_scalar_product_and_A_12_magnitude(kind):
    a, b, x, y = vectors(kind)
    assert close(a.dot(b), x[0] * y[0] + x[1] * y[1] + x[2] * y[2])
    assert close(dot(a, b), a.dot(b))
    assert close(a.norm() ** 2, a.dot(a))


@pytest.mark.parametrize("kind", KINDS)
def test_eqn_A_13_vector_product_is_right_handed(kind):
    a, b, x, y = vectors(kind)
    assert close(a.cross(b), (x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]))
    assert close(cross(a, b), -b.cross(a))
    assert close(ground.i.cross(ground.j), ground.k)
    assert close(ground.j.cross(ground.k), ground.i)
    assert close(ground.k.cross(ground.i), ground.j)


@given(triples, triples, triples)
def test_products_obey_the_identities_of_lagrange_and_grassmann(a, b, c):
    a, b, c = (ground.vector(*v) for v in (a, b, c))
    scale = 1 + a.norm() * b.norm() * c.norm()
    assert close(a.cross(b.cross(c)), b * a.dot(c) - c * a.dot(b), 1e-12 * scale)
    assert abs(a.dot(b.cross(c)) - c.dot(a.cross(b))) <= 1e-12 * scale
    assert abs(a.cross(b).norm() ** 2 + a.dot(b) ** 2 - (a.norm() * b.norm()) ** 2) <= 1e-11 * (a.norm() * b.norm() + 1) ** 2


@pytest.mark.parametrize("kind", KINDS)
def test_sums_multiples_and_quotients(kind):
    a, b, x, y = vectors(kind)
    (s,) = (numbers(kind, "3/7"),)
    assert close(a + b, tuple(p + q for p, q in zip(x, y, strict=True)))
    assert close(a - b, tuple(p - q for p, q in zip(x, y, strict=True)))
    assert close(s * a, tuple(s * p for p in x))
    assert close(a * s, s * a)
    assert close(a / s, tuple(p / s for p in x), 1e-14)
    assert close(-a, 0 * a - a)
    assert close(sum([a, b, b]), a + 2 * b)


def test_dividing_keeps_the_digits_of_the_dividend():
    third = ground.vector(mpmath.mpf(1), 0, 0) / 3
    assert abs(third.x - mpmath.mpf(1) / 3) < 1e-30
    assert (ground.vector(sympy.Symbol("x"), 0, 0) / 3).x == sympy.Symbol("x") / 3


def test_rates_of_quotients_and_multiples_stay_exact():
    v = ground.vector(moving(sympy.Integer(1), rate=1), 0, 0)
    assert (v / 3).rate(ground).x == sympy.Rational(1, 3)
    assert (2 * v / 3).rate(ground).x == sympy.Rational(2, 3)


def test_vectors_of_two_frames_combine_in_the_frame_of_the_left_one():
    a, b = ground.vector(1.0, 2.0, 3.0), turned.vector(-1.0, 0.5, 2.0)
    assert (a + b).frame is ground
    assert (b + a).frame is turned
    assert close(a + b, (b + a).expressed_in(ground))
    assert a.dot(b) == pytest.approx(b.dot(a))
    assert close(a.cross(b), -(b.cross(a)).expressed_in(ground))


def test_direction_and_angle():
    assert close(ground.vector(3.0, 0, 4.0).direction(), (0.6, 0, 0.8))
    assert ground.i.angle_to(ground.j) == pytest.approx(math.pi / 2)
    for tiny in (1e-9, 1e-14):  # where an arc cosine gives 0
        assert ground.i.angle_to(ground.vector(1.0, tiny, 0)) == pytest.approx(tiny, rel=1e-12)
        assert math.pi - ground.i.angle_to(ground.vector(-1.0, tiny, 0)) == pytest.approx(tiny, rel=0.05, abs=5e-16)
    assert ground.i.angle_to(-ground.i) == math.pi
    assert ground.i.angle_to(2.0 * ground.i) == 0
    with pytest.raises(FrameError, match="a zero vector has no direction"):
        ground.vector(0, 0.0, 0).direction()


@given(triples, triples)
def test_the_angle_between_vectors_lies_in_0_to_pi_and_does_not_depend_on_order(a, b):
    a, b = ground.vector(*a), ground.vector(*b)
    if a.norm() < 1e-100 or b.norm() < 1e-100:
        return
    assert 0 <= a.angle_to(b) <= math.pi
    assert a.angle_to(b) == pytest.approx(b.angle_to(a), abs=1e-15)


def test_components_are_what_a_user_expects_to_see():
    v = ground.vector(1.0, 0, sympy.Symbol("q"))
    assert (v.x, v.y, v.z) == tuple(v) == v.components() == (1.0, 0, sympy.Symbol("q"))
    assert type(v.y) is int
    assert v.components(ground) == v.components()
    x, _, _ = ground.vector(1.0, 2.0, 3.0)
    assert x == 1.0


def test_to_array_has_shape_3_or_3_by_n():
    assert ground.vector(1, 2.0, 0).to_array().tolist() == [1.0, 2.0, 0.0]
    rows = ground.vector(np.array([1.0, 2.0]), 0, 5.0).to_array()
    assert rows.tolist() == [[1.0, 2.0], [0.0, 0.0], [5.0, 5.0]]


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        (lambda a: a * a, r"two vectors have two products: write a.dot\(b\) or a.cross\(b\)"),
        (lambda a: a / a, "a vector cannot be divided by a vector"),
        (lambda a: 1 / a, "nothing can be divided by a vector: 1"),
        (lambda a: a + 1, "cannot add the vector .* and 1: both must be vectors"),
        (lambda a: 1 + a, "cannot add the vector .* and 1: both must be vectors"),
        (lambda a: a - "b", "cannot subtract the vector .* and 'b': both must be vectors"),
        (lambda a: a.dot((1, 2, 3)), r"cannot take the dot product of the vector .* and \(1, 2, 3\)"),
        (lambda a: a.cross(3), "cannot take the cross product of the vector .* and 3"),
        (lambda a: np.zeros(3) + a, "both must be vectors"),
        (lambda a: a.explain(), "was not computed as a named sum"),
        (lambda a: a.without("coriolis"), "no term 'coriolis'; the terms are none"),
    ],
)
def test_mistakes_with_vectors_are_told_in_words(wrong, message):
    with pytest.raises(FrameError, match=message):
        wrong(ground.vector(1.0, 2.0, 3.0))


def test_a_vector_times_what_is_no_number_is_refused():
    for bad in ("2", None, [1.0]):
        with pytest.raises(ScalarError, match="expected a number"):
            ground.i * bad


def test_equal_vectors_are_equal_and_others_are_not():
    ground, elsewhere = Frame("ground"), Frame("elsewhere")
    turned = ground.rotate("turned", "z", angle=0.3)
    a = ground.vector(1.0, 2.0, 2.0)
    assert a == ground.vector(1, 2, 2)
    assert a != ground.vector(1.0, 2.0, 2.0 + 1e-15)  # in one frame to the last digit
    assert a == a.expressed_in(turned)  # in two up to round-off
    assert a != ground.vector(1.0, 2.0, 2.001).expressed_in(turned)
    assert a != elsewhere.vector(1.0, 2.0, 2.0)
    assert (a == 3.0, a == (1.0, 2.0, 2.0)) == (False, False)
    many = ground.vector(np.array([1.0, 2.0]), 0, 0)
    assert many == ground.vector(np.array([1.0, 2.0]), 0, 0)
    assert many != ground.vector(np.array([1.0, 3.0]), 0, 0)
    x, angle = sympy.symbols("x angle")
    symbolic = ground.vector(x, 0, 0)
    assert symbolic == symbolic.expressed_in(ground.rotate("by angle", "z", angle=angle))
    assert symbolic != ground.vector(2 * x, 0, 0)
    with pytest.raises(TypeError, match="unhashable"):
        hash(a)


def test_a_vector_is_indexed_measured_and_converted_like_a_sequence_of_three():
    a = Frame("ground").vector(2.0, 0, -1.0)
    assert (a[0], a[-1], a[:2], len(a), abs(Frame("other").vector(3.0, 0, 4.0))) == (2.0, -1.0, (2.0, 0), 3, 5.0)
    assert np.array(a).tolist() == [2.0, 0.0, -1.0]
    with pytest.raises(IndexError):
        a[3]


def test_same_compares_relative_to_the_larger():
    a = ground.vector(1e6, 0, 0)
    assert same(a, a + ground.vector(0, 1e-7, 0))
    assert not same(a, a + ground.vector(0, 1e-3, 0))
    assert same(a, a.expressed_in(turned))
    assert same(ground.vector(0, 0, 0), turned.vector(0, 0, 0))


# -- the ledger


def moving_arm():
    arm = ground.rotate("arm", "z", angle=0.3, rate=2.0, acceleration=0.5)
    return arm, arm.point("P", moving(1.0, rate=3.0), 0.2, 0).acceleration(ground)


def test_a_factor_a_quotient_and_another_frame_carry_the_terms_along():
    _, a = moving_arm()
    for changed, factor in ((2 * a, 2), (a / 4, 0.25), (-a, -1), (a.expressed_in(turned), 1)):
        assert list(changed.terms) == list(a.terms)
        for name, term in changed.terms.items():
            assert close(term, (factor * a.terms[name]).expressed_in(term.frame), 1e-14)
            assert term.frame is changed.frame
        assert close(sum(changed.terms.values()), changed, 1e-13)


def test_reweighted_and_without_are_sums_of_changed_terms():
    _, a = moving_arm()
    assert close(a.reweighted(), a)
    assert close(a.without("coriolis"), a - a.terms["coriolis"])
    assert close(a.reweighted(coriolis=0.5, euler=-1), a - 0.5 * a.terms["coriolis"] - 2 * a.terms["euler"])
    assert close(a.without(*a.terms), (0, 0, 0))
    with pytest.raises(FrameError, match="no term 'corolis'; the terms are origin, relative, coriolis, euler, centripetal"):
        a.without("corolis")


def test_a_sum_of_vectors_has_no_terms_of_its_own():
    _, a = moving_arm()
    assert (a + a).terms == {}
    assert ground.i.terms == {}


def test_explain_prints_the_equation_its_number_and_every_term():
    _, a = moving_arm()
    text = str(a.explain("m/s^2"))
    assert text.splitlines()[0] == "acceleration of P in ground, by way of arm, equation (4.18), components in arm"
    assert any(line.split() == ["coriolis", "2", "omega", "x", "v_r", "[0,", "12,", "0]", "m/s^2"] for line in text.splitlines())
    assert text.splitlines()[-1].split() == ["sum", "[-4.1,", "11.7,", "0]", "m/s^2"]
    assert isinstance(a.explain(), Explanation)
    assert repr(a.explain()) == str(a.explain())


def test_explain_shows_latex_in_jupyter():
    arm, a = moving_arm()
    shown = a.explain("m/s^2")._repr_mimebundle_()
    assert set(shown) == {"text/plain", "text/latex"}
    latex = a.explain().latex
    assert latex.count("{") == latex.count("}")
    assert r"\tag{4.18}" in latex
    rod = arm.rotate("rod", "x", rate=1.0)
    assert r"\boldsymbol{\omega}_{\text{arm}}\times\boldsymbol{\omega}_{\text{rod}}" in rod.angular_acceleration(ground).explain().latex
    assert r"\tag{4.22}" in rod.angular_velocity(ground).explain().latex
    assert "equation (4.15)" in str(arm.i.rate(ground).explain())
    assert "equation (4.17)" in str(rod.point("Q", 1.0, 0, 0).velocity(ground).explain())


@pytest.mark.parametrize("kind", [*KINDS, "traced", "dimension"])
def test_every_kind_of_component_can_be_shown(kind):
    if kind == "traced":
        compiled(lambda x: (str(ground.vector(x, 1.0, 0)), ground.vector(x, 1.0, 0).latex()) and x)
        return
    x = Dimension(length=1) if kind == "dimension" else numbers(kind, "1/3")
    v = ground.vector(x, 0, -2 * x)
    assert str(v).endswith("in ground")
    assert repr(v).startswith("Vector(")
    assert v.latex().count("{") == v.latex().count("}")
    assert v._repr_latex_() == f"${v.latex()}$"


def test_latex_writes_signs_and_powers_of_ten():
    assert ground.vector(1.5, -2e-7, 0).latex() == r"\left(1.5\,\hat{\imath}-2\times10^{-7}\,\hat{\jmath}\right)_{\text{ground}}"
    assert ground.vector(0, 0, 0).latex() == r"\mathbf{0}"
    assert ground.vector(0, sympy.Symbol("a") + 1, 0).latex() == r"\left(\left(a + 1\right)\,\hat{\jmath}\right)_{\text{ground}}"


def test_numpy_does_not_take_vectors_apart():
    v = ground.vector(1.0, 2.0, 3.0)
    assert isinstance(np.float64(2.0) * v, Vector)
    assert isinstance(np.array([1.0, 2.0]) * v, Vector)
    assert (np.array([1.0, 2.0]) * v).z.tolist() == [3.0, 6.0]
