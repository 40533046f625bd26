"""Chapter 6, (6.1)-(6.10) and the examples of 6.3, 6.7, 6.12: forces from motions, motions from
forces. The rotating Earth: test_earth.py.

The oracle of every component equation is m times the second rates of the rectangular coordinates,
differentiated by the product rule and projected on the local unit vectors: no formula of polar,
spherical or relative motion.
"""

import math

import numpy as np
import pytest
import sympy

from newton_euler import (
    Dimension,
    Frame,
    at,
    atan2,
    compiled,
    cos,
    cylindrical,
    frenet,
    moving,
    polar,
    sin,
    spherical,
    sqrt,
)
from newton_euler.algebra import FrameError, SingularError
from newton_euler.bodies import MassError
from newton_euler.dynamics.newton import (
    acceleration_by,
    coordinate_accelerations,
    path_force,
    path_rates,
    reaction,
    relative_acceleration,
    resultant_force,
)
from newton_euler.kinematics import along
from tests.kinds import LENGTH, MASS, TIME, close, every_kind, numbers, within

FORCE = MASS * LENGTH / TIME**2
small = within(1e-13, 26)


def coordinates(kind):
    """Mass, instant, and three functions of time, none of which vanishes together with its rate."""
    m, t, a, b, c = numbers(kind, "2.5", "0.5", "1.5", "-0.4", "0.7")
    x, y = (lambda t: a + b * t + t * t), (lambda t: c + a * t - b * t * t)
    return m, t, x, y, (lambda t: b + c * t + c * t * t * t)


def by_rectangular(m, t, xyz):
    """m times the second rates of the rectangular coordinates ``xyz(t)``."""
    return tuple(m * x.acceleration for x in along(lambda t: [c + 0 * t for c in xyz(t)], t))


@every_kind
def test_eqn_6_1_force_is_mass_times_acceleration_both_ways(kind):
    m, x, y, z = numbers(kind, 2, 5, 6, -3)
    ground = Frame("ground")
    a = acceleration_by(m, push=ground.vector(x, y, z))
    assert close(a, (x / m, y / m, z / m), small(kind))
    assert close(resultant_force(m, a), (x, y, z), small(kind))


@every_kind
def test_eqns_6_2_to_6_4_and_6_7_rectangular_components_in_the_plane_and_in_space(kind):
    m, t, x, y, z = coordinates(kind)
    ground = Frame("ground")
    for third in (lambda t: 0 * t, z):
        xyz = lambda t, third=third: (x(t), y(t), third(t))
        F = resultant_force(m, ground.point("P", *along(xyz, t)).acceleration(ground))
        assert close(F.components()[:2], (2 * m, -2 * numbers(kind, "-0.4") * m), small(kind))
        assert close(F, by_rectangular(m, t, xyz), small(kind))


@every_kind
def test_eqn_6_5_tangential_and_normal_components(kind):
    """Against the rates of speed and direction of the velocity."""
    m, t, u, w, _ = coordinates(kind)
    v = at(lambda t: sqrt(u(t) ** 2 + w(t) ** 2), t)
    theta = at(lambda t: atan2(w(t), u(t)), t)
    velocity = Frame("ground").vector(at(u, t), at(w, t), 0)
    a = velocity.rate(velocity.frame)
    motion = frenet(velocity, a)
    F = resultant_force(m, motion.acceleration)
    F_t, F_n = m * v.rate, m * v.value * theta.rate
    assert close((F.x, F.y), (F_t, F_n), small(kind))
    assert close(F, m * a, small(kind))
    assert close((F.terms["tangential"].x, F.terms["normal"].y), (F_t, F_n), small(kind))
    assert close(path_force(m, v.value, v.rate, motion.flexure), (F_t, F_n), small(kind))
    assert close(path_rates(m, F_t, F_n, v.value), (v.rate, theta.rate), small(kind))


SYSTEMS = {
    polar: lambda r, theta: (r * cos(theta), r * sin(theta), 0),
    cylindrical: lambda r, theta, z: (r * cos(theta), r * sin(theta), z),
    spherical: lambda R, theta, phi: (
        R * cos(phi) * cos(theta),
        R * cos(phi) * sin(theta),
        R * sin(phi),
    ),
}


@every_kind
@pytest.mark.parametrize("system", SYSTEMS)
def test_eqn_6_6_and_6_8_and_6_9_forces_in_curvilinear_coordinates_both_ways(kind, system):
    m, t, *q = coordinates(kind)
    q = q[:2] if system is polar else q
    ground = Frame("ground")
    P = system(ground, "P", *(at(f, t) for f in q))
    F = resultant_force(m, P.acceleration(ground))
    wanted = by_rectangular(m, t, lambda t: SYSTEMS[system](*(f(t) for f in q)))
    assert F.frame is P.local
    assert close(F.components(ground), wanted, 20 * small(kind))
    assert close(sum(F.terms.values()), F, 20 * small(kind))
    second = [at(f, t).acceleration for f in q]
    assert close(coordinate_accelerations(m, P, push=F), second, 50 * small(kind))


def test_forces_along_curved_coordinates_may_come_as_components_or_as_vectors():
    ground = Frame("ground")
    P = polar(ground, "bob", moving(2.0, rate=0.0), moving(0.3, rate=1.5))
    m, g, T = 2.0, 9.81, 30.0
    weight = m * g * ground.i  # x down, theta from the vertical: the pendulum
    ddr, ddtheta = coordinate_accelerations(m, P, weight=weight, cord=(-T, 0))
    assert close(ddr, (m * g * math.cos(0.3) - T) / m + 2.0 * 1.5**2, 1e-14)
    assert close(ddtheta, -g * math.sin(0.3) / 2.0, 1e-14)


@every_kind
def test_eqn_6_10_force_by_way_of_a_moving_frame_and_what_is_seen_there(kind):
    """The origin, the turn and the relative motion all accelerate."""
    m, t, x, angle, y = coordinates(kind)
    ground = Frame("ground")
    disk = ground.rotate(
        "disk", "z", at(angle, t), origin=ground.point("O", at(y, t), at(x, t), at(angle, t))
    )
    P = disk.point("P", at(x, t), at(y, t), at(x, t))

    def place(t):
        c, s = cos(angle(t)), sin(angle(t))
        return y(t) + x(t) * c - y(t) * s, x(t) + x(t) * s + y(t) * c, angle(t) + x(t)

    wanted = by_rectangular(m, t, place)
    F = resultant_force(m, P.acceleration(ground, via=disk))
    assert close(F.components(ground), wanted, 20 * small(kind))
    assert set(F.terms) == {"origin", "relative", "coriolis", "euler", "centripetal"}
    assert close(sum(F.terms.values()).components(ground), wanted, 20 * small(kind))
    seen = relative_acceleration(m, P, ground, push=ground.vector(*wanted))
    assert close(seen, [at(q, t).acceleration for q in (x, y, x)], 20 * small(kind))
    v = P.velocity(disk)
    assert close(seen.terms["coriolis"], -2 * disk.angular_velocity(ground).cross(v), small(kind))


def test_the_terms_of_a_force_print_with_the_number_of_their_equation():
    ground = Frame("ground")
    P = polar(ground, "P", moving(2.0, rate=0.5), moving(0.0, rate=3.0))
    text = str(resultant_force(4.0, P.acceleration(ground)).explain("N"))
    assert text.startswith("polar force of P in ground, equation (6.6)")
    assert "coriolis  m (2 r' theta' e_theta)" in text
    disk = ground.rotate("disk", "z", rate=2.0)
    Q = disk.point("Q", moving(3.0, rate=1.0), 0, 0)
    seen = relative_acceleration(1.0, Q, ground, spring=-5.0 * disk.i).explain()
    assert "equation (6.10)" in str(seen)
    assert r"\tag{6.10}" in seen.latex
    # MathJax refuses a second subscript on a symbol without braces
    assert r"{\mathbf{a}_2}_{\text{spring}}" in seen.latex
    assert "(6.10)" in str(resultant_force(2.0, Q.acceleration(ground)).explain())
    R = reaction(2.0, ground.vector(0, 0, 1.0), weight=-19.62 * ground.k)
    assert "reaction with weight known, equation (6.1)" in str(R.explain())
    assert "minus weight  -F  [0, 0, 19.62]" in str(R.explain())
    assert r"\text{minus weight}" in R.explain().latex
    assert r"-{\mathbf{F}}_{\text{weight}} &= \left(19.62\,\hat{k}\right)" in R.explain().latex
    assert list(acceleration_by(2.0, weight=ground.k, wind=ground.i).without("wind")) == [0, 0, 0.5]


@pytest.mark.parametrize(
    "m", [0, 0.0, -1.0, float("nan"), float("inf"), np.array([1.0, -2.0]), sympy.Integer(-3)]
)
def test_a_mass_must_be_positive(m):
    ground = Frame("ground")
    by = lambda m: acceleration_by(m, F=ground.i)
    for f, *given in ((resultant_force, ground.i), (by,), (path_rates, 1.0, 1.0, 1.0)):
        with pytest.raises(MassError, match="the mass must be positive and finite, got m = "):
            f(m, *given)


def at_the_pole(ground):
    return spherical(ground, "P", moving(np.array([1.0, 0.0])), moving(0.0), moving(0.0))


@pytest.mark.parametrize(("ask", "error", "words"), [
    (lambda f: coordinate_accelerations(1.0, polar(f, "P", moving(0.0, 1.0), moving(0.0, 1.0)), push=(1.0, 1.0)),
     SingularError, r"a coordinate moves nothing at P"),
    (lambda f: coordinate_accelerations(1.0, at_the_pole(f), push=(1.0, 1.0, 0.0)), SingularError, "moves nothing"),
    (lambda f: path_rates(1.0, 1.0, 1.0, 0.0), SingularError, "at rest the velocity has no direction"),
    (lambda f: acceleration_by(1.0), FrameError, "no force is given; name each of them"),
    (lambda f: coordinate_accelerations(1.0, polar(f, "P", 1.0, 0.0), push=(1, 2, 3, 4)), FrameError, "the force push has 4 components"),
])  # fmt: skip
def test_singular_coordinates_and_what_is_not_a_force_are_refused_in_words(ask, error, words):
    with pytest.raises(error, match=words):
        ask(Frame("ground"))


def test_units_of_forces_and_accelerations_and_a_symbolic_mass_as_it_is():
    ground = Frame("ground")
    angle = moving(Dimension(), Dimension(time=-1), Dimension(time=-2))
    length = moving(LENGTH, LENGTH / TIME, LENGTH / TIME**2)
    P = spherical(ground, "P", length, angle, angle)
    assert list(resultant_force(MASS, P.acceleration(ground))) == [FORCE] * 3
    found = coordinate_accelerations(MASS, P, push=(FORCE, FORCE, FORCE))
    assert found == (LENGTH / TIME**2, 1 / TIME**2, 1 / TIME**2)
    assert path_rates(MASS, FORCE, FORCE, LENGTH / TIME) == (LENGTH / TIME**2, 1 / TIME)
    m = sympy.Symbol("m")
    assert resultant_force(m, Frame("ground").vector(0, 0, 2)).z == 2 * m


def _polar_force(m, r, dr, ddr, theta, dtheta, ddtheta):
    ground = Frame("ground")
    P = polar(ground, "P", moving(r, dr, ddr), moving(theta, dtheta, ddtheta))
    return resultant_force(m, P.acceleration(ground))


def test_forces_compile():
    x = (2.0, 1.5, -0.3, 0.2, 0.7, 1.1, -0.4)
    assert close(compiled(_polar_force)(*x), _polar_force(*x), 1e-15)


def test_forces_of_symengine_expressions():
    symengine = pytest.importorskip("symengine")
    m, r, dr, dtheta = symengine.symbols("m r dr dtheta")
    F = _polar_force(m, r, dr, 0, 0, dtheta, 0)
    assert symengine.expand(F.x + m * r * dtheta**2) == 0
    assert symengine.expand(F.y - 2 * m * dr * dtheta) == 0
