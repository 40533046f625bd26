"""NumPy's integers overflow silently: the square of an astronomical distance is negative, and 1 - 2
is 255. Wherever integers enter the engine, arrays of them become floats.
"""

import numpy as np
import pytest

from newton_euler import Frame, moving, polar, sin, solve_linear, sqrt, unit, where
from newton_euler.algebra import ScalarError, is_numeric, radians, same
from newton_euler.algebra.scalars import ZERO, promote, scalar
from newton_euler.applications import coriolis_parameter
from newton_euler.bodies import disk, particle
from newton_euler.dynamics import attraction, gravity_at_height, kinetic_energy, spring_potential

WHOLE = (np.int8, np.int16, np.int32, np.int64, np.uint8, np.uint16, np.uint32, np.uint64)
AU = np.array([149_600_000_000])  # m


def test_whole_numbers_become_floats_before_they_wrap():
    assert Frame("ground").vector(AU, 0, 0).norm() == 1.496e11
    assert Frame("ground").vector(AU, AU, 0).norm() == pytest.approx(2**0.5 * 1.496e11, rel=1e-15)
    assert scalar(np.array([2**53 + 1]))[0] == 2.0**53
    assert scalar(np.uint64(2**64 - 1)) == 2**64 - 1  # a single one is not
    x = moving(np.array([2_000_000_000], np.int32), rate=np.array([2_000_000_000], np.int32))
    assert (x * x).value[0] == 4e18
    assert (x * x).rate[0] == 8e18
    P = polar(Frame("ground"), "P", moving(AU, rate=1), moving(0.0, rate=np.array([10])))
    assert P.acceleration(P.ground).x[0] == -1.496e13
    found = solve_linear(lambda x: np.array([100], np.uint8) * x - np.array([200], np.uint8))
    assert found.x[0] == 2
    ground = Frame("ground")
    assert same(ground.vector(np.array([3]), 0, 0), ground.vector(np.array([3.0]), 0, 0))


@pytest.mark.parametrize("kind", WHOLE)
def test_arrays_of_every_whole_kind_become_floats_and_those_of_floats_stay(kind):
    x = scalar(np.array([1, 2, 100], kind))
    assert x.dtype == float
    assert list(x) == [1, 2, 100]
    assert scalar(x) is x


@pytest.mark.parametrize("kind", WHOLE)
def test_one_less_two_is_minus_one(kind):
    ground = Frame("ground")
    one, two = (ground.vector(np.array([n], kind), 0, 0) for n in (1, 2))
    assert list((one - two).x) == [-1]
    assert list((-two).x) == [-2]
    assert list((two * np.array([200], kind if kind != np.int8 else np.uint8)).x) == [400]


@pytest.mark.parametrize("kind", WHOLE)
def test_a_single_whole_number_stays_exact(kind):
    n = scalar(kind(100))
    assert type(n) is int
    assert n**20 == 100**20
    assert scalar(kind(0)) is ZERO
    assert scalar(10**40) == 10**40


def test_truth_values_and_short_floats_become_floats_of_64_bits():
    assert list(scalar(np.array([True, False]))) == [1.0, 0.0]
    for kind in (np.float16, np.float32):
        assert scalar(np.array([0.5, 2.0], kind)).dtype == float
        assert type(scalar(kind(0.5))) is float
    assert scalar(np.array([1j], np.complex64)).dtype == complex
    long = np.array([1.0], np.longdouble)
    assert scalar(long) is long  # it has more digits than asked for


def test_arrays_of_python_numbers_become_floats_and_of_others_are_refused():
    assert scalar(np.array([1, 2.5, 10**30], dtype=object)).dtype == float
    with pytest.raises(ScalarError, match="expected a number"):
        scalar(np.array([1, None], dtype=object))
    with pytest.raises(ScalarError, match="expected a number"):
        scalar(np.array(["1"]))
    with pytest.raises(ScalarError, match="of type matrix"):
        scalar(np.ones((2, 2)).view(np.matrix))  # whose * is a different product


def test_functions_of_whole_numbers_have_all_digits():
    degrees = np.array([30, 200], np.uint8)
    assert sin(degrees).dtype == float  # NumPy: float16
    assert sqrt(np.array([250], np.uint8))[0] == 250**0.5
    assert radians(degrees)[1] == radians(200.0)
    assert unit("km").to_base(np.array([200], np.uint8))[0] == 2e5
    assert promote(np.array([200], np.uint8), 1)[0].dtype == float
    chosen = where(np.array([True]), np.array([1], np.uint8), np.array([2], np.uint8))
    assert (chosen - np.array([2.0]))[0] == -1
    assert is_numeric(np.array([1]))


def test_formulas_of_every_room_take_whole_numbers():
    """Each is compared with itself at the same floats."""
    m, r = np.array([250], np.uint8), np.array([6_371_000], np.int32)
    for f, args in (
        (attraction, (AU, AU, AU)), (gravity_at_height, (r, r)), (spring_potential, (m, m)),

        (coriolis_parameter, (np.array([1], np.uint8),)),
    ):  # fmt: skip
        assert f(*args)[0] == f(*(float(x[0]) for x in args)), f.__name__
    ground = Frame("ground")
    wheel = ground.rotate("wheel", "z", rate=m)
    T, exact = (
        kinetic_energy(disk(radius, body, "z", mass=radius), ground)
        for radius, body in ((m, wheel), (250.0, ground.rotate("wheel", "z", rate=250.0)))
    )
    assert T.value[0] == exact.value
    assert particle(m, ground.point("P", r, 0, 0)).about(ground).moments[1][0] == 250 * 6_371_000**2
