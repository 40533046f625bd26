"""An error in the caller's own function reaches the caller as raised; an error that a wrong
argument causes inside the engine is raised in words.
"""

import operator
from dataclasses import replace
from functools import partial
from typing import Literal

import numpy as np
import pytest
import sympy

from newton_euler import (
    Event,
    Frame,
    Model,
    at,
    composite,
    cos,
    integral,
    integrate,
    moving,
    polar,
    prepare,
    root,
    sin,
    solve_linear,
    solve_rates,
)
from newton_euler.accuracy import timed
from newton_euler.algebra import NewtonEulerError, compiled
from newton_euler.algebra.errors import ArgumentError, checked, checked_words
from newton_euler.algebra.scalars import (
    DivisionError,
    RangeError,
    Scalar,
    ScalarError,
    SingularError,
)
from newton_euler.bodies import integrated
from newton_euler.drawing import svg_of
from newton_euler.dynamics import (
    Potential,
    audit,
    coordinate_accelerations,
    curl,
    degrees_of_freedom,
    find_potential,
    work_along,
    work_in_time,
    work_integral,
)
from newton_euler.kinematics.triads import Triad, roundoff_sensitivity

# errors of Python and NumPy for unsuitable arguments
ERRORS = [
    IndexError("tuple index out of range"),
    TypeError("f() takes 1 positional argument but 2 were given"),
    ValueError("operands could not be broadcast together with shapes (3,) (2,)"),
    AttributeError("the state has no spin"),
    RuntimeError("no more data"),
    KeyError("Step"),  # a class of the engine
    TypeError("loop of ufunc does not support argument 0 of type 'Step'"),
    ValueError("could not convert string to float: '<traced x>'"),
    StopIteration("no more places"),
]

# public functions that call a function of the user
CALLS = {
    "solve_linear": lambda f: solve_linear(f, "a"),
    "solve_rates": lambda f: solve_rates(f, 1),
    "integral": lambda f: integral(f, 0.0, 1.0),
    "root": lambda f: root(f, 0.0, 1.0),
    "compiled": lambda f: compiled(f)(1.0),
    "work_along": lambda f: work_along(lambda x, y, z: (x, 0, 0), f, 0.0, 1.0),
    "work_integral": lambda f: work_integral(f, 0.0, 1.0),
    "audit": lambda f: audit(f, 0.0, 1.0),
}
GROUND, SHEET = Frame("ground"), lambda u, v: (u, v, 0)
LATE = lambda f: lambda s, p, t: f(s.h) if s.h < 0.8 else s.h
FALL = Model("fall", {"g": 9.81}, ("h", "v"), lambda s, p, t: (s.v, -p.g))
OTHERS = {
    "event": lambda f: integrate(FALL, 1.0, (1.0, 0.0), events=Event(lambda s, p, t: f(s.h))),
    "event that branches": lambda f: integrate(FALL, 1.0, (1.0, 0.0), events=Event(LATE(f))),
    "progress": lambda f: integrate(FALL, 1.0, (1.0, 0.0), progress=f),
    "constraint": lambda f: degrees_of_freedom({"P": 1}, {"wall": lambda P: f(P[0])}),
    "limit": lambda f: integrated(SHEET, (0.0, 1.0), (0.0, f), frame=GROUND, density=1.0),
    "exact limit": lambda f: integrated(SHEET, (0, 1), (0, f), frame=GROUND, density=1, exact=True),
    "numpy": lambda f: compiled(lambda x: np.apply_along_axis(f, 0, np.array([x, x]))),
}


@pytest.mark.parametrize("name", ["compiled", "integral", *OTHERS])  # tests/fuzz: all others
@pytest.mark.parametrize("error", ERRORS, ids=lambda e: f"{type(e).__name__}: {e}"[:30])
def test_an_error_of_the_users_function_arrives_as_raised_with_its_place(name, error):
    def own(x):
        raise error

    with pytest.raises(type(error)) as caught:
        {**CALLS, **OTHERS}[name](own)
    assert caught.value is error
    assert "own" in [entry.name for entry in caught.traceback]


class OwnError(NewtonEulerError, ValueError):
    """As a package on top of the engine has."""


ALL = {**CALLS, **OTHERS, "curl": lambda f: curl(f, (1.0, 2.0, 3.0))}


@pytest.mark.parametrize("name", ALL)
@pytest.mark.parametrize("kind", [OwnError, ScalarError, SingularError, DivisionError])
def test_an_error_of_the_engines_kinds_that_a_user_raises_arrives_as_raised(name, kind):
    error = kind("mine")

    def own(*x):
        raise error

    with pytest.raises(kind) as caught:
        ALL[name]((lambda x: own(x)) if name == "compiled" else own)
    assert caught.value is error
    assert len(getattr(error, "__notes__", [])) <= 1


CIRCLE = lambda q: (cos(6.283185307179586 * q), sin(6.283185307179586 * q), 0)
LATER = {  # calls of a function that fails after it has been of use, and one that does not
    "force round a loop": (lambda f: find_potential(f, loops=[CIRCLE]), lambda x, y, z: (x, y, z)),
    "constraint": (
        lambda f: degrees_of_freedom({"P": 2}, {"rod": lambda P: f(*P)}),
        lambda x, y: x * x + y * y - 1,
    ),
}


@pytest.mark.parametrize(("call", "well"), LATER.values(), ids=LATER)
def test_a_StopIteration_arrives_as_raised_at_whichever_call_it_comes_up(call, well):
    def own(*x):
        nonlocal left
        left -= 1
        if left == 0:
            raise error
        return well(*x)

    left, error = 0, StopIteration("no more places")
    call(own)
    for n in {*range(1, -left, max(1, -left // 30)), -left}:
        left = n
        with pytest.raises(StopIteration) as caught:
            call(own)
        assert caught.value is error


@pytest.mark.parametrize("name", ["event", "progress"])
@pytest.mark.parametrize("kind", [ValueError, ZeroDivisionError, OverflowError])
def test_an_error_of_a_function_whose_source_is_unknown_arrives_as_raised(name, kind):
    space = {"error": kind("mine")}
    exec("def own(x):\n    raise error", space)  # as in a console
    with pytest.raises(kind) as caught:
        OTHERS[name](space["own"])
    assert caught.value is space["error"]


@pytest.mark.parametrize("error", [sympy.SympifyError("mine"), ScalarError("mine")])
def test_an_error_of_an_integrand_for_SymPy_arrives_as_raised(error):
    def own(x):
        raise error

    with pytest.raises(type(error)) as caught:
        work_integral(own, 0.0, 1.0, exact=True)
    assert caught.value is error


@pytest.mark.parametrize("space", [{"__name__": "wave"}, {}, {"__name__": None}], ids=str)
def test_a_function_is_the_users_whatever_its_module_is_called(space):
    space = {**space}
    exec(compile("def own(x):\n    return (1, 2, 3)[5]", "/home/ada/wave.py", "exec"), space)
    with pytest.raises(IndexError) as caught:
        integral(space["own"], 0.0, 1.0)
    assert str(caught.value) == "tuple index out of range"
    assert caught.value.__notes__ == ["This came up in own, where x = 0.5."]


class Fixed(Exception):
    def __setattr__(self, name, value):
        raise RuntimeError(name)


class Closed(Exception):
    __dict__ = property(lambda self: 1 / 0)


class Shy:
    def __repr__(self):
        raise RuntimeError

    def __truediv__(self, other):
        raise KeyError("shy")


def inner(y):
    return {}[y]


def fixed(x):
    raise Fixed


def closed(x):
    raise Closed


class Unlike(float):
    def __rmul__(self, other):
        raise TypeError("no product")

    __mul__ = __truediv__ = __rtruediv__ = __rmul__


SHY = Shy()
EMPTY = {}.__getitem__
OWN = {"E": lambda s, p, t: {}[s.h]}
AXES = ((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0))


class Reader(float):
    def __call__(self, x):
        return [{}[y] for y in [x]]

    def __mul__(self, other=None):
        raise ValueError("no product")

    __float__ = __mul__


class Counted:
    count = 0

    def __repr__(self):
        Counted.count += 1
        return "1"


def far(s, p, t):
    raise TypeError("of a law")


MANY = [Counted()] * 1000


@pytest.mark.parametrize(("call", "error", "place"), [
    (lambda: root(inner, 0.0, 1.0), KeyError, "inner, where y = 0.5"),
    (lambda: at(inner, 2.0), KeyError, "inner, where y = moving(2.0, rate=1, "),
    (lambda: integral(lambda x: integral(inner, 0.0, x), 0.0, 1.0), KeyError, "inner, where y = 0.25"),
    (lambda: integral(operator.itemgetter(5), 0.0, 1.0), TypeError, "operator.itemgetter(5)"),
    (lambda: solve_linear(EMPTY, "a"), KeyError, "in dict.__getitem__."),
    (lambda: work_in_time(EMPTY, lambda t: (t,), 0.0, 1.0), KeyError, "in dict.__getitem__."),
    (lambda: integral(lambda x, k=SHY: k / x, 0.0, 1.0), KeyError, "k = an object of Shy"),
    (lambda: integral(lambda *x, **k: {}[x], 0.0, 1.0), KeyError, "where x = (0.5,), k = {}"),
    (lambda: replace(FALL, rhs=lambda s, p, t: (1,)[5]), IndexError, "where s = (h = <traced h>, v = "),
    (lambda: replace(FALL, invariants=OWN).invariant("E", (1.0, 0.5)), KeyError, "s = (h = 1.0, v = 0.5)"),
    (lambda: integrate(FALL, 1.0, (1.0, 0.0), progress=EMPTY), KeyError, "in dict.__getitem__."),
    (lambda: integral(Reader(), 0.0, 1.0), KeyError, "in Reader.__call__, where x = 0.5."),
    (lambda: integral(lambda x, k=inner: k(x), 0.0, 1.0), KeyError, "x = 0.5, k = inner."),
    (lambda: integral(lambda x, k=MANY: {}[x], 0.0, 1.0), KeyError, "k = [1, 1, 1, "),
    (lambda: svg_of(lambda ax: {}[0]), KeyError, "in <lambda>, where ax = an object of Panel."),
    (lambda: timed(lambda: {}[0]), KeyError, "in <lambda>."),
    (lambda: Potential(lambda *x: {}[x], (0.0, 0.0, 0.0))(1.0, 0.0, 0.0), KeyError, "where x = (0.03"),
    (lambda: Triad("A", GROUND, AXES, lambda: {}[0]).angular_velocity(GROUND), KeyError, "<lambda>."),
    (lambda: roundoff_sensitivity(inner, (2.0,)), KeyError, "in inner, where y = 2.0."),
    (lambda: integrate(replace(FALL, invariants={"E": far}), 1.0, (1.0, 0.5)).drift, TypeError, "in far, "),
    (lambda: prepare(replace(FALL, exact=far))(1.0, (1.0, 0.5)), TypeError, "in far, where s = (h = 1.0, "),
    (lambda: compiled(lambda x: x * x)(Reader(2.0)), ValueError, "in Reader.__mul__, where other = 2.0"),
])  # fmt: skip
def test_an_error_of_the_users_function_has_a_note_of_the_place(call, error, place):
    with pytest.raises(error) as caught:
        call()
    (note,) = caught.value.__notes__
    assert place in note
    assert Counted.count < 100  # of 1000: the text is cut while it is made


def test_an_error_that_takes_no_note_arrives_as_raised():
    with pytest.raises(Fixed):
        integral(fixed, 0.0, 1.0)
    with pytest.raises(Closed):
        integral(closed, 0.0, 1.0)


def test_names_that_a_function_takes_are_not_blamed_for_an_error_in_a_number():
    P = polar(GROUND, "P", moving(2.0, rate=0.5), moving(0.0, rate=3.0))
    with pytest.raises(TypeError, match="no product"):
        coordinate_accelerations(Unlike(4.0), P, cord=(-72.0, 12.0, 0.0))


def four(a, b, c, d):
    return 0.0


class Four:
    __call__ = four


WRONG = {"an object": Four(), "a method": Four().__call__, "partial": partial(four, d=1.0)}


@pytest.mark.parametrize("name", [*CALLS, *WRONG])
def test_a_function_with_other_parameters_than_are_passed_is_refused_in_words(name):
    call, wrong = CALLS.get(name, CALLS["root"]), WRONG.get(name, four)
    with pytest.raises(ScalarError if name == "compiled" else NewtonEulerError, match="missing"):
        call(wrong)


@checked
def ratio(a: Scalar, b: Scalar = 2.0, *more: Scalar, f=None, **others: Scalar) -> Scalar:
    return a / b if f is None else f(a)


def test_an_error_in_the_engine_names_the_function_and_its_arguments():
    # this file stands in for the engine: `ratio` calls no function of the user
    ratio.__wrapped__.__globals__["__name__"] = "newton_euler.of_a_test"
    try:
        with pytest.raises(DivisionError, match=r"ratio\(1.0, 0.0\) has no value: float division"):
            ratio(1.0, 0.0)
        with pytest.raises(RangeError, match=r"ratio\(1\.0, f=<lambda>\) has no value"):
            ratio(1.0, f=lambda a: 10.0**400)
        with pytest.raises(ArgumentError, match=r"ratio\(1\.0, f=x\) cannot be computed with"):
            ratio(1.0, f=type("x", (), {"__name__": "x"})())
    finally:
        ratio.__wrapped__.__globals__["__name__"] = __name__


ENGINES = {
    "method of an argument": (lambda x: x.index(5.0), r"5.0 is not in list"),
    "NumPy's own code": (lambda x: np.max(x[:0]), r"zero-size array"),
    "a function of NumPy": (lambda x, f=np.add: f(x[0]), r"add\(\) takes from 2 to 3"),
    "result of a function in C": (lambda x, get={}.get: get(x[0]) + 1.0, r"unsupported operand"),
}


@pytest.mark.parametrize("name", ENGINES)
def test_a_call_of_the_engine_that_fails_in_c_is_not_the_callers(name, monkeypatch):
    call, words = ENGINES[name]
    monkeypatch.setitem(globals(), "__name__", "newton_euler.of_a_test")
    with pytest.raises(ArgumentError, match=f"cannot be computed with these arguments: {words}"):
        checked(call)([1.0])


def test_arguments_are_checked_wherever_they_stand():
    for given, named in (
        (("1",), {}),
        ((1.0, 2.0, "3"), {}),
        ((1.0,), {"b": "2"}),
        ((1.0,), {"c": "2"}),
    ):
        with pytest.raises(TypeError, match=r"ratio: \w+ is a number .* got '\d' of type str"):
            ratio(*given, **named)


@pytest.mark.parametrize(("call", "words"), [
    (lambda: composite("shaft", ["disk"]), r"parts is a sequence, each a Body.* got \['disk'\]"),
    (lambda: integral(lambda x: (x,) * (1 + (x > 0.5)), 0.0, 1.0), "a tuple of 1 at one place, and 2"),
    (lambda: integral(lambda x: x if x > 0.5 else (x,), 0.0, 1.0), "a tuple of 1 at .* and no tuple"),
])  # fmt: skip
def test_what_does_not_fit_is_named_with_what_would(call, words):
    with pytest.raises(NewtonEulerError, match=words):
        call()


@checked_words
class Scale:
    def weigh(self, name: str, unit: Literal["kg", "g"] = "kg", where: tuple = ()):
        return name, unit

    def _read(self, name: str):
        return name


def test_the_public_methods_of_a_class_are_checked():
    assert Scale().weigh("a", "g", 5) == ("a", "g")
    assert Scale()._read(()) == ()
    for given in ((), 1j, {}, np.zeros(0)):
        with pytest.raises(ArgumentError, match="name is a text"):
            Scale().weigh(given)
        with pytest.raises(ArgumentError, match="weigh: unit is one of 'kg', 'g'; got "):
            Scale().weigh("a", given)
