"""Arguments of a wrong kind are refused in words, and so are impossible ones: text,
None, quantities with units, negative masses. The long run over all public names is
``python -m tests.fuzz``.
"""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import mpmath
import numpy as np
import pytest
import sympy

import newton_euler as ne
from newton_euler import applications, dynamics
from newton_euler.accuracy import timed
from newton_euler.algebra import FrameError, ScalarError, SingularError, scalars
from newton_euler.algebra.errors import ArgumentError, checked
from newton_euler.bodies import MassError, disk, integrated
from newton_euler.motion import ModelError, Neglected
from tests.fuzz.bad import OfAstropy, OfPint
from tests.models import throw

ground = ne.Frame("ground")
P = ground.point("P", 1.0, 2.0, 3.0)


QUANTITIES = OfPint(30.0, "degree"), np.array([1.0, 2.0]).view(OfAstropy)


def test_the_message_says_what_was_expected_what_came_and_what_to_do():
    with pytest.raises(ScalarError) as error:
        ne.radians("30")
    assert str(error.value) == (
        "expected a number (float, array, mpf or expression), got '30' of type str; write numbers "
        "without quotation marks"
    )
    with pytest.raises(FrameError, match=r"frenet: v is a Vector, as ground.vector.* got 3.0"):
        ne.frenet(3.0, ground.i)
    with pytest.raises(ArgumentError, match=r"work_along: path is a function; got 3.0"):
        ne.work_along(lambda x, y, z: (x, y, z), 3.0, 0.0, 1.0)


@pytest.mark.parametrize("quantity", QUANTITIES, ids=["pint", "astropy"])
def test_the_unit_of_a_quantity_is_never_dropped(quantity):
    for take in (
        ne.radians, ne.sin, ne.moving, lambda q: ground.vector(q, 0, 0), lambda q: ground.i * q,
        lambda q: disk(q, ground, mass=1.0), lambda q: dynamics.attraction(q, 1.0, 1.0),
        lambda q: ground.rotate("arm", "z", q), lambda q: ne.unit("m").to_base(q),
        lambda q: ne.Inertia(ground, (q, q, q)), lambda q: ne.at(lambda t: t, q),
    ):  # fmt: skip
        words = r"it has a unit|unit vector|OfPint|OfAstropy"
        with pytest.raises(ne.NewtonEulerError, match=words):
            take(quantity)


@pytest.mark.parametrize("f", [
    lambda m: dynamics.attraction(m, 1.0, 1.0),
    lambda m: dynamics.attraction(1.0, m, 1.0),
    lambda m: dynamics.gravitational_field(P, m, ground),
    lambda m: dynamics.gravitational_potential(m, 1.0, 1.0),
    lambda m: dynamics.gravity_at_surface(m, 1.0),
    lambda m: dynamics.plane_kinetic_energy(m, 1.0, 1.0, 1.0),
    lambda m: dynamics.weight_potential(m, 1.0),
    lambda m: dynamics.weight(m, ground.k),
    lambda m: applications.buoyancy(m, 1.0, 1.0, 1.0, 9.8),
    lambda m: applications.force_near_earth(m, ground.i, ground.j, ground.k),
    lambda m: applications.support_force(m, 9.8, ground),
    lambda m: ne.Body("stone", m, ground),
])  # fmt: skip
def test_negative_masses_are_refused_and_zero_is_a_mass(f):
    for bad in (-1.0, np.array([1.0, -1.0]), mpmath.mpf(-1), float("nan"), float("inf")):
        with pytest.raises(MassError):
            f(bad)
    for good in (0, 0.0, 2.0, sympy.Symbol("m")):
        f(good)


def test_moments_of_inertia_that_no_body_has_are_refused():
    with pytest.raises(MassError, match="no body has these moments"):
        ne.Body("stone", 1.0, ground, (1.0, 1.0, 5.0))
    ne.Body("sheet of a table", 1.0, ground, (0.333, 0.333, 0.667))  # in three digits
    for refused in (
        lambda: dynamics.plane_kinetic_energy(1.0, 1.0, -1.0, 1.0),
        lambda: dynamics.gyroscope_energy(-1.0, 1.0, 1.0, 1.0, 1.0, 1.0),
        lambda: applications.normal_moment(-1.0, ground.i, ground.j),
        lambda: applications.steady_moment(1.0, 3.0, 0.5, 1.0, 1.0),
        lambda: applications.steady_spin(-1.0, 1.0, 0.5, 1.0, moment=0.0),
        lambda: integrated(lambda x: (x, 0, 0), (0.0, 1.0), frame=ground, mass=-1.0),
        lambda: applications.ground_frame(applications.earth_frame(ground), 0.5, radius=-1.0),
    ):
        with pytest.raises(ne.NewtonEulerError):
            refused()


def test_functions_say_where_they_have_no_value():
    for call in (
        lambda: ne.sqrt(-1.0), lambda: ne.log(0.0), lambda: ne.exp(1e6), lambda: ne.sin(float("inf")),
        lambda: ne.at(ne.sqrt, 0.0),
    ):  # fmt: skip
        with pytest.raises((SingularError, MassError)):
            call()
    with pytest.raises(OverflowError):  # for those who expect what Python raises
        ne.exp(1e6)
    with pytest.raises(ScalarError, match="not known to hold"):
        ne.where(sympy.Symbol("x") > 1, 1.0, 2.0)


def energy(s, p, t):
    return p.g * s.h + s.v**2 / 2


AIR = Neglected("the air", lambda s, p, t: 0.01 * t**2, "position, m")
FALL = replace(throw(g=9.81), invariants={"energy": energy}, neglects=(AIR,))
START = (1.0, 0.0)


def test_what_a_function_of_a_model_returns_is_reported_where_it_does_not_fit():
    none, pole = lambda s, p, t: None, lambda s, p, t: (1 / t,)
    wrong = (none, ModelError), (lambda s, p, t: (1.0, 2.0), ModelError)
    for exact, error in (*wrong, (pole, ZeroDivisionError)):
        model = ne.Model("m", {}, ("x",), lambda s, p, t: (1.0,), exact=exact)
        with pytest.raises(error, match="exact solution"):
            model.solution(0.0, (1.0,))
    model = ne.Model("m", {}, ("x",), lambda s, p, t: (1.0,), {"none": lambda s, p, t: None})
    with pytest.raises(ModelError, match="returns a number"):
        model.invariant("none", (1.0,))


def in_array(x):
    """An array of two such objects: np.array([x, x]) would go into them."""
    array = np.empty(2, object)
    array[0] = array[1] = x
    return array


MOTION = ne.integrate(FALL, 1.0, START)
DECAY = ne.Model(
    "decay", {"k": 2.0}, ("x",), lambda s, p, t: (-p.k * s.x,),
    exact=lambda s, p, t: (s.x * ne.exp(-p.k * t),),
)  # fmt: skip
TAKERS_OF_QUANTITIES = {
    "from and to": lambda q: ne.integrate(FALL, (0.0, q), START),
    "state": lambda q: ne.integrate(FALL, 1.0, (q, 0.0)),
    "state by name": lambda q: ne.integrate(FALL, 1.0, {"h": q, "v": 0.0}),
    "states": lambda q: ne.integrate(FALL, 1.0, (in_array(q), 0.0)),
    "parameter": lambda q: FALL.changed(g=q),
    "parameters": lambda q: FALL.changed(g=in_array(q)),
    "sample": lambda q: ne.integrate(FALL, 1.0, START, samples=[0.5, q]),
    "at": lambda q: MOTION.at([0.5, q]),
    "invariant": lambda q: FALL.invariant("energy", (q, 0.0)),
    "prepared exact": lambda q: ne.prepare(DECAY, method="exact")(1.0, (q,)),
    "prepared exact at": lambda q: ne.prepare(DECAY, method="exact")(q, (1.0,)),
    "prepared dop853": lambda q: ne.prepare(DECAY, method="dop853")(1.0, q),
    "compiled": lambda q: ne.compiled(lambda x: 2 * x)(q),
}


@pytest.mark.parametrize("taker", TAKERS_OF_QUANTITIES)
def test_no_motion_drops_a_unit(taker):
    """A quantity as the argument itself is a case of tests.fuzz; here it is inside something."""
    fractions = np.array([0.1, 0.2])
    span = np.timedelta64(1, "s")
    for quantity in (OfPint(2.0), fractions.view(OfAstropy), span, fractions.astype("m8[s]")):
        with pytest.raises(ne.NewtonEulerError):
            TAKERS_OF_QUANTITIES[taker](quantity)


def test_a_prepared_motion_of_taylor_drops_no_unit():
    pytest.importorskip("heyoka")
    run = ne.prepare(DECAY, method="taylor")
    q = OfPint(2.0)
    for t, start in ((q, (1.0,)), (1.0, (q,)), (1.0, np.ones(1).view(OfAstropy))):
        with pytest.raises(ModelError, match="it has a unit"):
            run(t, start)
    assert run(1, [1]) == run(np.float64(1), np.ones(1)) == run(1.0, (1.0,))


def test_whatever_can_be_read_as_real_numbers_is_accepted():
    for times in ([0.5, 0.25], (0.5, mpmath.mpf(0.25)), np.array([0.5, 0.25], dtype=object)):
        assert MOTION.at(times)["h"].tolist() == MOTION.at(np.array([0.5, 0.25]))["h"].tolist()
        assert ne.integrate(FALL, 1.0, START, samples=times).times.tolist() == [0.5, 0.25]
    assert MOTION.at(1) == MOTION.end
    assert ne.integrate(FALL, 3.0, START, samples=(n for n in range(3))).times.tolist() == [0, 1, 2]
    assert FALL.derivative(iter(START)) == FALL.derivative([1, 0]) == (0.0, -9.81)


def test_a_vector_is_equal_to_itself_there_and_back():
    """Going through another frame rounds, and no frame is better than another."""
    turned = ground.rotate("turned", (1, 2, 3), 0.7)
    for x in (1.0, 1e-200, 1e200, np.array([1.0, 1e-9]), mpmath.mpf(1)):
        v = ground.vector(x, 2 * x, 3 * x)
        back = v.expressed_in(turned).expressed_in(ground)
        assert v == v.expressed_in(turned)
        assert v == back
        assert v != 1.00001 * back
        assert 2 * v != v
    nan = 0.0 * ground.vector(float("inf"), 0, 0)
    assert nan != nan
    assert ground.vector(np.ones(2), 0, 0) != ground.vector(np.ones(3), 0, 0)
    # a small difference at one instant is not hidden by a large vector at another
    assert ground.vector(np.array([1e9, 1.0]), 0, 0) != ground.vector(np.array([1e9, 1.1]), 0, 0)
    q = sympy.Symbol("q")
    assert ground.vector(ne.cos(q) ** 2 + ne.sin(q) ** 2, 0, 0) == ground.i
    assert ground.vector(q, 0, 0) != ground.vector(q + 1, 0, 0)


def chain_of_frames(n):
    """The reaction on a point at the end of n turning frames, in symbols."""
    t, frame = sympy.Symbol("t"), ground
    for k in range(n):
        C = frame.point(f"C{k}", sympy.Symbol(f"a{k}"), 0, sympy.Symbol(f"b{k}"))
        frame = frame.rotate(f"f{k}", "xyz"[k % 3], sympy.Function(f"q{k}")(t), origin=C)
    a = frame.point("P", sympy.Symbol("x"), 0, 0).acceleration(ground).expressed_in(ground)
    return dynamics.reaction(sympy.Symbol("m"), a, weight=-sympy.Symbol("g") * ground.k)


def texts(x):
    """All texts that a vector is written as."""
    return repr(x), str(x), x.latex(), str(x.explain()), repr(x.terms)


def test_a_long_expression_is_printed_as_its_length_and_a_short_one_written_out():
    """Written out it grows fivefold with every frame: to 6 MB with seven frames."""
    for text in texts(chain_of_frames(7)):
        assert len(text) < 2000
        assert "operations" in text
    q = sympy.Symbol("q")
    assert scalars.short_repr(q**2 + 1) == "q**2 + 1"
    assert scalars.operations(q**2 + 1) == 2
    assert scalars.short_repr(sum(q**n for n in range(scalars.LONGEST))).endswith("operations>")
    assert scalars.scalar(q) is q


@pytest.mark.benchmark
def test_the_text_of_a_long_expression_takes_no_longer_than_the_expression():
    R = chain_of_frames(7)
    making, reading = timed(lambda: chain_of_frames(7), lambda: texts(R), runs=1, shortest=0.0)
    assert reading < 50 * making


def test_the_first_call_of_a_checked_function_may_come_from_many_threads():
    for _ in range(50):

        @checked
        def double(
            x: scalars.Scalar, *more: scalars.Scalar, **named: scalars.Scalar
        ) -> scalars.Scalar:
            return 2 * x + sum(more)

        with ThreadPoolExecutor(8) as pool:
            found = list(pool.map(lambda n, f=double: f(n, 1.0), range(8)))
        assert found == [2 * n + 1.0 for n in range(8)]
