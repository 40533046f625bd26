"""Chapter 9: rotor reactions against mass points in explicit motion; balance and balancing."""

import math

import mpmath as mp
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from newton_euler import Body, Frame, composite, particle
from newton_euler.applications import (
    RotorError,
    balance,
    balancing_masses,
    corrections,
    imbalance,
    reactions,
    shaft_axis,
)
from newton_euler.bodies import disk, plate, rod
from tests.kinds import close, every_kind, numbers, within
from tests.turning import cross, rot, second_rate

small = within(1e-13, 26)


def points_of_a_rotor():
    """Masses and their positions along the axes of the shaft, and the same rotor as a Body."""
    shaft_points = [(2, (1, 2, -1)), (1, (-2, 1, 3)), (3, (1, -1, 2)), (1, (0, 2, 1))]
    return [(mp.mpf(m), tuple(mp.mpf(x) / 10 for x in r)) for m, r in shaft_points]


@pytest.mark.parametrize("oblique", [False, True])
def test_reactions_hold_for_mass_points_in_explicit_motion(oblique):
    masses, t0, a, b = points_of_a_rotor(), mp.mpf("0.4"), mp.mpf("0.5"), mp.mpf("0.7")
    angle, g = lambda t: 1 + 2 * t + 3 * t * t, mp.matrix(["1.5", "-9", "2.5"])
    ground = Frame("ground")
    base = ground.rotate("base", (1, 2, 2), mp.mpf("0.9")) if oblique else ground
    shaft = base.rotate("shaft", "z", angle(t0), 2 + 6 * t0, mp.mpf(6))
    A, B = shaft.point("A", 0, 0, -a), shaft.point("B", 0, 0, b)
    body = composite("rotor", [particle(m, shaft.point("P", *r)) for m, r in masses])
    found = reactions(body, A, B, ground, gravity=base.vector(*g))
    # what the supports must give, about the origin
    force, moment = mp.matrix(3, 1), mp.matrix(3, 1)
    with mp.workdps(60):
        for m, r in masses:
            place = lambda t, r=r: rot("z", angle(t)) * mp.matrix(r)
            load = m * (second_rate(place, t0) - g)
            force, moment = force + load, moment + cross(place(t0), load)
    FA, FB = (v.components(base) for v in (found.A, found.B))
    small = mp.mpf(10) ** -24
    assert close((FA[0] + FB[0], FA[1] + FB[1], found.axial), tuple(force), small)
    turning = a * FA[1] - b * FB[1], -a * FA[0] + b * FB[0], found.moment
    assert close(turning, tuple(moment), small)


def test_a_vertical_shaft_carries_the_weight_along_itself():
    ground = Frame("ground")
    shaft = ground.rotate("shaft", "z", rate=4.0)
    wheel = disk(0.2, shaft.point("G", 0, 0, 0.1), "z", mass=2.0)
    B = shaft.point("B", 0, 0, 1.0)
    found = reactions(wheel, shaft.origin, B, ground, -10.0 * ground.k)
    assert found.axial == 20.0
    assert found.A.norm() == found.B.norm() == 0


def on_x(*bodies_of):
    shaft = Frame("shaft")
    A, B = shaft.point("A", -0.5, 0, 0), shaft.point("B", 0.5, 0, 0)
    return composite("rotor", [make(shaft) for make in bodies_of]), A, B


STATES = [
    ("both", [lambda s: disk(0.2, s.origin, "x", mass=1.0)]),
    ("dynamic", [lambda s: disk(0.2, s.point("G", 0, 0.01, 0), "x", mass=1.0)]),
    ("static", [lambda s, k=k: particle(1.0, s.point("P", 0.2 * k, 0.1 * k, 0)) for k in (1, -1)]),
    ("static", [lambda s: disk(0.2, s.rotate("tilted", "z", 0.3), "x", mass=1.0)]),
    ("neither", [lambda s: rod(0.4, s.rotate("slant", "z", 0.6).point("G", 0.2, 0, 0), "x", mass=1.0)]),
]  # fmt: skip


@pytest.mark.parametrize(("state", "parts"), STATES)
def test_the_state_of_balance(state, parts):
    verdict = balance(*on_x(*parts))
    assert verdict.state == state
    assert ("statically balanced" in str(verdict)) == (state in ("static", "both"))
    assert ("dynamically balanced" in str(verdict)) == (state in ("dynamic", "both"))


@pytest.mark.parametrize(("offset", "static"), [(0.9e-6, True), (1.1e-6, False)])
def test_static_balance_on_both_sides_of_its_tolerance(offset, static):
    k = math.sqrt((0.02 + 0.01 + 0.01) / 2)  # disk of radius 0.2, about its centre
    body, A, B = on_x(lambda s: disk(0.2, s.point("G", 0, offset * k, 0), "x", mass=1.0))
    assert balance(body, A, B, tolerance=1e-6).static is static


@pytest.mark.parametrize(("tilt", "dynamic"), [(0.9e-6, True), (1.1e-6, False)])
def test_dynamic_balance_on_both_sides_of_its_tolerance(tilt, dynamic):
    angle = tilt * 0.02 / (0.02 - 0.01)  # m k^2 over the difference of the moments
    body, A, B = on_x(lambda s: disk(0.2, s.rotate("tilted", "z", angle), "x", mass=1.0))
    verdict = balance(body, A, B, tolerance=1e-6)
    assert verdict.dynamic is dynamic
    assert verdict.tilt == pytest.approx(tilt, rel=1e-6)


def test_balance_does_not_depend_on_units_and_a_ball_of_equal_moments_is_balanced():
    for scale in (1e-9, 1.0, 1e9):
        wheel = lambda s, f=scale: disk(0.2 * f, s.point("G", 0, 1e-12 * f, 0), "x", mass=f)
        body, A, B = on_x(wheel)
        assert balance(body, A, B).state == "both"
    body = Frame("ground").rotate("body", (1, 2, 3), 0.7)
    sides = [(n, 0.1 * s) for n in range(3) for s in (-1, 1)]
    place = lambda n, x: body.point("C", *(x if k == n else 0 for k in range(3)))
    cube = composite("cube", [plate(0.2, 0.2, place(n, x), "xyz"[n], mass=1.0) for n, x in sides])
    for end in ((1.0, 0, 0), (0.3, -0.4, 0.5), (-2.0, 1.0, 7.0)):
        assert balance(cube, body.origin, body.point("B", *end)).state == "both"


def test_dynamic_balance_asks_for_the_point_where_the_body_is_not_balanced_statically():
    body, A, B = on_x(lambda s: disk(0.2, s.point("G", 0.1, 0.01, 0), "x", mass=1.0))
    assert balance(body, A, B).dynamic
    assert not balance(body, A, B, about=A).dynamic


coordinate = st.floats(-1, 1).map(lambda x: round(x, 3))
mass_points = st.lists(
    st.tuples(st.floats(0.1, 5), coordinate, coordinate, coordinate), min_size=1, max_size=5
)


@settings(max_examples=60)
@given(mass_points, st.floats(-2, 0.4), st.floats(0.6, 2), st.floats(0.05, 1), st.floats(-3, 3))
def test_balanced_rotors_have_no_dynamic_reactions(points, z1, z2, radius, alpha):
    ground = Frame("ground")
    shaft = ground.rotate("shaft", (1, -1, 2), 0.3, 4.0, alpha)
    axis = [x / math.sqrt(6) for x in (1, -1, 2)]
    A, B = (shaft.point(n, *(s * x for x in axis)) for n, s in (("A", 0.1), ("B", 1.3)))
    parts = [particle(m, shaft.point("P", *r), f"P{n}") for n, (m, *r) in enumerate(points)]
    body = composite("rotor", parts)
    weights = balancing_masses(body, A, B, (z1, z2), radius=radius)
    whole = composite("balanced", [body, *weights])
    before, after = reactions(body, A, B, ground), reactions(whole, A, B, ground)
    scale = sum(m for m, *_ in points) + sum(w.mass for w in weights)
    assert max(after.A.norm(), after.B.norm()) < 1e-12 * scale * 40
    assert balance(whole, A, B, tolerance=1e-10).state == "both"
    turned = -alpha * radius**2 * sum(w.mass for w in weights)
    assert before.moment - after.moment == pytest.approx(turned, abs=1e-10 * scale)


@every_kind
def test_each_weight_may_have_a_radius_of_its_own(kind):
    ground = Frame("ground")
    m, x, z, one, three, omega = numbers(kind, 2, "0.5", 1, 1, 3, 4)
    shaft = ground.rotate("shaft", "z", rate=omega)
    A, B = shaft.point("A", 0, 0, 0 * z), shaft.point("B", 0, 0, 4 * z)
    P, Q = shaft.point("P", x, 0, z), shaft.point("Q", 0, x, three)
    body = composite("rotor", [particle(m, P), particle(one, Q, "Q")])
    weights = balancing_masses(body, A, B, (one / 2, 2 * three / 3), (one, three))
    found = reactions(composite("balanced", [body, *weights]), A, B, ground)
    assert close(found.A, (0, 0, 0), 10 * small(kind))
    assert close(found.B, (0, 0, 0), 10 * small(kind))


def test_one_plane_through_the_disk_needs_no_second_weight():
    shaft = Frame("shaft")
    A, B = shaft.point("A", -0.2, 0, 0), shaft.point("B", 0.3, 0, 0)
    wheel = disk(0.2, shaft.point("G", 0, 0.01, 0), "x", mass=4.0)
    first, second = balancing_masses(wheel, A, B, (0.2, 0.4), radius=0.1)
    assert first.mass == pytest.approx(0.4, rel=1e-15)
    assert first.centre.position(shaft).components() == pytest.approx((0, -0.1, 0), abs=1e-16)
    assert second.mass == pytest.approx(0, abs=1e-16)


def test_corrections_as_formulas():
    m, r, z, z1, z2 = sympy.symbols("m r z z1 z2", positive=True)
    shaft = Frame("shaft")
    B, body = shaft.point("B", 0, 0, sympy.Integer(1)), particle(m, shaft.point("P", r, 0, z))
    U1, U2 = corrections(body, shaft.origin, B, (z1, z2))
    assert sympy.simplify(U1.x + m * r * (z2 - z) / (z2 - z1)) == 0
    assert sympy.simplify(U2.x + m * r * (z - z1) / (z2 - z1)) == 0


@pytest.mark.parametrize(("ask", "words"), [
    (lambda s, A, B, W: shaft_axis(A, s.point("C", -0.2, 0, 0)), "bearings A and C coincide; one point is not an axis"),
    (lambda s, A, B, W: corrections(W, A, B, (0.1, 0.1)), r"two different planes are needed; got 0\.1 and 0\.1"),
    (lambda s, A, B, W: balancing_masses(W, A, B, (0.1, 0.2), radius=0),
     r"radius of the balancing weights must be positive, got 0: on the axis"),
    (lambda s, A, B, W: balancing_masses(W, A, B, (0.1, 0.2), radius=(0.1, -0.1)),
     r"radius of the balancing weights must be positive, got -0\.1"),
    (lambda s, A, B, W: reactions(W, A, B, s.parent, about=s.point("Q", 0, 0.1, 0)), r"Q is 0\.1 off the axis"),
    (lambda s, A, B, W: reactions(W, s.point("A", -0.2, 0.1, 0), s.point("B", 0.3, 0.1, 0), s.parent), "the velocity of A"),
])  # fmt: skip
def test_errors_in_words(ask, words):
    shaft = Frame("ground").rotate("shaft", "x", rate=2.0)
    A, B = shaft.point("A", -0.2, 0, 0), shaft.point("B", 0.3, 0, 0)
    with pytest.raises(RotorError, match=words):
        ask(shaft, A, B, disk(0.2, shaft.point("G", 0, 0.01, 0), "x", mass=4.0))


def test_a_body_that_turns_about_another_axis_is_refused():
    ground = Frame("ground")
    shaft = ground.rotate("shaft", "y", rate=2.0)
    wheel = disk(0.2, shaft.point("G", 0, 0.01, 0), "x", mass=4.0)
    A, B = shaft.point("A", -0.2, 0, 0), shaft.point("B", 0.3, 0, 0)
    with pytest.raises(RotorError, match="not turn about its bearings as a fixed axis: its an"):
        reactions(wheel, A, B, ground)


def test_balance_of_expressions_is_refused_and_imbalance_is_not():
    shaft, d = Frame("shaft"), sympy.Symbol("d")
    wheel = Body("wheel", 1, shaft.point("G", 0, d, 0), (1, 1, 1))
    A, B = shaft.point("A", -1.0, 0, 0), shaft.point("B", 1.0, 0, 0)
    with pytest.raises(RotorError, match="depends on expressions"):
        balance(wheel, A, B)
    assert sympy.simplify(imbalance(wheel, A, B).static.y - d) == 0
