"""Chapter 11, (11.15)-(11.20), (11.34), (11.35): potentials given, found, or missing, and why.

Oracles: derivatives by SymPy, potentials by hand, and the work along paths that wind.
"""

import math

import pytest
import sympy

from newton_euler import Frame, at, atan2, compiled, cos, sin, spherical, sqrt
from newton_euler.algebra import WorkError
from newton_euler.bodies import MassError
from newton_euler.dynamics.potential import (
    NoPotential,
    conservative_force,
    curl,
    find_potential,
    gravitational_potential,
    jacobian,
    spring_between,
    spring_potential,
    weight_potential,
)
from newton_euler.dynamics.work import power, work_along
from newton_euler.kinematics import along, gradient
from tests.kinds import LENGTH, MASS, TIME, close, every_kind, numbers, within

ENERGY = MASS * LENGTH**2 / TIME**2
small = within(1e-12, 26)


def hill(x, y, z):
    """A potential whose cross-derivatives are all nonzero."""
    return x * x * y + y * z**3 - 2 * x * z


def down_hill(x, y, z):
    """Minus the gradient of ``hill``, by hand."""
    return -(2 * x * y - 2 * z), -(x * x + z**3), -(3 * y * z * z - 2 * x)


def exactly(V, kind, *place):
    """V at a point; with SymPy from the formula of V."""
    if kind != "sympy":
        return V(*place)
    names = sympy.symbols("x y z", real=True)
    return V(*names).subs(dict(zip(names, place, strict=True)))


def vortex(x, y, z):
    """A field without curl but with a hole, the z axis: each turn round it does the work 2 pi."""
    square = x * x + y * y
    return -y / square, x / square, 0


@every_kind
def test_eqn_11_16_11_17_the_force_is_minus_the_gradient_of_the_partial_derivatives(kind):
    q = x, y, z = numbers(kind, 2, "-0.5", "1.5")
    P = Frame("ground").point("P", *q)
    assert close(conservative_force(hill, P), down_hill(x, y, z), small(kind))
    slopes = [at(lambda s, n=n: hill(*q[:n], s, *q[n + 1 :]), q[n]).rate for n in range(3)]
    assert close(gradient(hill, P), slopes, small(kind))


@every_kind
def test_eqn_11_18_in_spherical_coordinates(kind):
    """V = -1/R^2: the force is -2/R^3 along e_R everywhere."""
    R, theta, phi = numbers(kind, 2, "0.5", "0.25")
    P = spherical(Frame("ground"), "P", R, theta, phi)
    F = conservative_force(lambda R, theta, phi: -1 / (R * R), P)
    assert close(F, (-2 / R**3, 0 * R, 0 * R), small(kind))


@every_kind
def test_eqn_11_19_power_is_minus_the_rate_of_the_potential(kind):
    t, place = numbers(kind, "0.75"), lambda t: (sin(t), t * t, 1 - t)
    P = Frame("ground").point("P", *along(place, t))
    rate = at(lambda t: hill(*place(t)), t).rate
    assert close(power(conservative_force(hill, P), P.velocity(P.frame)), -rate, small(kind))


@every_kind
def test_eqn_11_15_11_20_work_and_the_sum_of_its_components_are_the_potential_lost(kind):
    q, lost = numbers(kind, 1), hill(0, 0, 1) - hill(1, 2, 3)
    straight = lambda s: (s, 2 * s, 1 + 2 * s)
    bent = lambda s: (s**3, 2 * s * s, 1 + 2 * s * (3 - 2 * s))
    for path in (straight, bent):
        U = work_along(down_hill, path, 0, q, exact=kind == "sympy")
        for work in (U.value, U.terms["x"] + U.terms["y"] + U.terms["z"]):
            assert close(work, hill(0, 0, 1) - hill(*path(q)), 10 * small(kind))
        if kind != "array":  # in an array the ends differ between instants
            assert close(U.value, lost, small(kind))


@every_kind
def test_eqn_11_34_11_35_the_potential_of_weight_and_spring_is_minus_their_work(kind):
    m, g, h, K, x = numbers(kind, 2, "9.81", "1.5", 20, "-0.5")
    for V, F, path in (
        (weight_potential(m, h, g), lambda *r: (0, 0, -m * g), lambda q: (sin(q), q * q, h * q)),
        (spring_potential(K, x), lambda x, y, z: (-K * x, 0, 0), lambda q: (x * q, 0, 0)),
    ):
        U = work_along(F, path, 0, 1 + 0 * h, exact=kind == "sympy")
        assert close(V, -U.value, small(kind))


@every_kind
def test_eqn_11_35_a_slant_spring_pulls_along_its_line(kind):
    """The gradient of V at one end gives the tension, toward the other end."""
    K, l0, x, y = numbers(kind, 20, "1.5", 3, 4)
    ground = Frame("ground")
    P, V = ground.point("P", x, y, 0), lambda x, y, z: spring_between(K, l0, (0, 0, 0), (x, y, z))
    r = sqrt(x * x + y * y)
    F = K * (r - l0)
    assert close(spring_between(K, l0, ground.origin, P), V(x, y, 0), small(kind))
    assert close(conservative_force(V, P), (-F * x / r, -F * y / r, 0), 10 * small(kind))


def test_potentials_are_energies():
    ground = Frame("ground")
    P, stiffness = ground.point("P", LENGTH, LENGTH, 0), MASS / TIME**2
    assert weight_potential(MASS, LENGTH, LENGTH / TIME**2) == ENERGY
    assert spring_potential(stiffness, LENGTH) == ENERGY
    assert spring_between(stiffness, LENGTH, ground.origin, P) == ENERGY
    assert gravitational_potential(MASS, MASS, LENGTH, LENGTH**3 / (MASS * TIME**2)) == ENERGY
    assert compiled(lambda K, x: spring_potential(K, x))(200.0, 0.1) == pytest.approx(1.0)


@every_kind
def test_a_potential_is_found(kind):
    x, y, z = numbers(kind, 2, "-0.5", "1.5")
    assert close(exactly(find_potential(down_hill), kind, x, y, z), hill(x, y, z), small(kind))


def test_a_potential_found_differentiates_to_the_force_in_symbols_too():
    V, P = find_potential(down_hill), Frame("ground").point("P", 2.0, -0.5, 1.5)
    assert close(-gradient(V, P), down_hill(2.0, -0.5, 1.5), 1e-14)
    place = lambda t: (sin(t), t * t, 1 - t)
    found, true = (at(lambda t, f=f: f(*place(t)), 0.75) for f in (V, hill))
    for part in ("value", "rate", "acceleration"):
        assert getattr(found, part) == pytest.approx(getattr(true, part), rel=1e-12)
    x, y, z, c = sympy.symbols("x y z c", real=True)
    cubic = lambda x, y, z: tuple(c * (x * x + y * y + z * z) * q for q in (x, y, z))
    assert sympy.expand(find_potential(cubic)(x, y, z) + c * (x**2 + y**2 + z**2) ** 2 / 4) == 0


@every_kind
def test_the_curl_by_hand(kind):
    q = x, y, z = numbers(kind, 2, "-0.5", "1.5")
    F = lambda x, y, z: (x * y * z, -x * z, y * y)
    assert close(curl(F, q), (2 * y + x, x * y, -z - x * z), small(kind))
    partial = (y * z, x * z, x * y), (-z, 0, -x), (0, 2 * y, 0)
    assert close(jacobian(F, q), partial, small(kind))


def test_a_force_with_curl_has_no_potential():
    words = r"at \(-0\.7.*the curl of the force is \(0, 0, 2\), not zero"
    with pytest.raises(NoPotential, match=words) as refused:
        find_potential(lambda x, y, z: (-y, x, 0))
    assert refused.value.curl == (0, 0, 2)
    g = sympy.symbols("g_xy g_yx")
    with pytest.raises(NoPotential, match=r"-g_xy \+ g_yx|g_yx - g_xy"):
        find_potential(lambda x, y, z: (g[0] * y, g[1] * x, 0))


@pytest.mark.parametrize(("curl_part", "conservative"), [(1e-11, True), (1e-7, False)])
def test_both_sides_of_the_tolerance_of_the_curl(curl_part, conservative):
    field = lambda x, y, z: (-x - curl_part * y, -y, -z)
    if conservative:
        assert find_potential(field)(1.0, 0.0, 0.0) == pytest.approx(0.5)
        return
    with pytest.raises(NoPotential, match="the curl of the force is"):
        find_potential(field)


def test_a_hole_in_the_region_is_found_by_a_loop_round_it():
    """The vortex has no curl, yet no potential: the naive test of (11.18) passes on it."""
    box = ((-1, 1), (-1, 1), (0, 1))
    assert max(map(abs, curl(vortex, (0.3, -0.4, 0.5)))) < 1e-15
    circle = lambda s: (0.8 * cos(2 * math.pi * s), 0.9 * sin(2 * math.pi * s), 0.5)
    words = r"round loop 1 the force does the work 6\.28319, though its curl is zero"
    with pytest.raises(NoPotential, match=words) as refused:
        find_potential(vortex, base=(1, 0, 0), box=box, loops=[circle])
    assert refused.value.circulation == pytest.approx(2 * math.pi)
    # a region that does not surround the hole
    V = find_potential(vortex, base=(1, 0, 0), box=((0.5, 1), (-1, 1), (0, 1)))
    assert V(1.0, 1.0, 0.0) == pytest.approx(-math.pi / 4)
    assert at(lambda t: -atan2(t, 1 + 0 * t), 1.0).rate == pytest.approx(
        at(lambda t: V(1.0, t, 0.0), 1.0).rate
    )


def test_a_hole_elsewhere_needs_its_own_loop():
    aside = lambda x, y, z: vortex(x - 0.9, y - 0.9, z)
    ring = lambda s: (0.9 + 0.05 * cos(2 * math.pi * s), 0.9 + 0.05 * sin(2 * math.pi * s), 0.5)
    assert find_potential(aside)(0.5, 0.0, 0.0) is not None
    with pytest.raises(NoPotential, match="round loop 1"):
        find_potential(aside, loops=[ring])
    assert find_potential(down_hill, loops=[ring])(0.0, 0.0, 0.0) == 0  # a loop round no hole
    with pytest.raises(WorkError, match="loop 1 is not closed: it leads from"):
        find_potential(down_hill, loops=[lambda s: (s, 0, 0)])


@pytest.mark.parametrize(("field", "message"), [
    (lambda x, y, z: (1 / x, 0), r"two|got 2 components"),
    (lambda x, y, z: (sqrt(x), 0, 0), r"the force has no value at \(-0\.75.*keep base, box and loops away"),
    (lambda x, y, z: (math.inf, 0, 0), "not finite; keep base, box and loops"),
    (lambda x, y, z: ("x", 0, 0), "the force has no value at.*expected a number"),
])  # fmt: skip
def test_what_is_not_a_field_is_refused(field, message):
    with pytest.raises(WorkError, match=message):
        find_potential(field)


def test_a_straight_line_through_the_centre_of_attraction_is_refused():
    attraction = lambda x, y, z: tuple(-c / (x * x + y * y + z * z) ** 1.5 for c in (x, y, z))
    V = find_potential(attraction, base=(-1, 0, 0), box=((1, 2), (1, 2), (1, 2)))
    with pytest.raises((WorkError, ZeroDivisionError), match=r"did not converge|no value"):
        V(1.0, 0.0, 0.0)
    with pytest.raises(MassError, match="the distance of the two bodies must be positive"):
        gravitational_potential(1.0, 1.0, 0.0)
