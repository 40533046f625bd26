"""A student's slip in typing is answered with what to write."""

import importlib
import inspect
import math

import numpy as np
import pytest

import newton_euler
from newton_euler import Frame, NewtonEulerError, moving, unit
from newton_euler.algebra.names import ArgumentError, nearest
from newton_euler.bodies import disk
from newton_euler.dynamics import resultant_force

m = moving(1.0, rate=2.0)
ground = Frame("ground")
arm = ground.rotate("arm", "z", rate=2.0)
P, Q = arm.point("P", m, 0, 0), ground.point("Q", m, 0, 0)
v, a = P.velocity(ground), P.acceleration(ground)
F = resultant_force(2.0, a)

REFUSED = [
    # what the engine knows about a vector
    (lambda: v.explain("m/s^2"), "the velocity of P in ground.*, in m/s: .* in 'm/s\\^2'"),
    (lambda: v + a, "cannot add the acceleration of P .*, in m/s\\^2, to the velocity of P"),
    (lambda: a - v, "cannot add the velocity of P .*, in m/s, to the acceleration of P"),
    (lambda: -v + a.expressed_in(ground), "cannot add the acceleration"),
    (lambda: Q.velocity(ground) - Q.acceleration(ground), "cannot add the acceleration, in m/s"),
    # not a number
    (lambda: moving(1.0, rate=None), "the rate is None, which is not a number.* leave rate= out"),
    (lambda: moving(np.float64("nan")), "the value is nan"),
    (lambda: ground.vector(0, None, 0), "the value is None"),
    # functions of other libraries
    (lambda: np.sin(m), r"np.sin .*: write sin\(...\) of newton_euler"),
    (lambda: np.arccos(m), r"np.arccos .*: write acos\("),
    (lambda: np.arctan2(m, 1.0), r"np.arctan2 .*: write atan2\("),
    (lambda: math.sqrt(m), r"write sin\(x\) of newton_euler for math.sin\(x\)"),
    # names
    (lambda: a.terms["Coriolis"], "Did you mean 'coriolis'"),
    (lambda: a.without("centripital"), "Did you mean 'centripetal'"),
    (lambda: a.terms.coriolis, r"the term is \['coriolis'\]"),
    (lambda: unit("m/sec^2"), "Did you mean 's'"),
    (lambda: newton_euler.disk, "write from newton_euler.bodies import disk"),
    (lambda: newton_euler.integrat, "Did you mean 'integrate'.* from newton_euler import integrate"),
    (lambda: newton_euler.kinematics.moving, "write from newton_euler import moving"),
    # calls
    (lambda: ground.vector([1, 2, 3]), r"one by one: write vector\(1, 2, 3\)"),
    (lambda: ground.vector(np.array([1.0, 2.0, 3.0])), r"write vector\(1.0, 2.0, 3.0\)"),
    (lambda: ground.point("A", (1, 2, 3)), r"write point\('A', 1, 2, 3\)"),
    (lambda: ground.vector(1, 2), r"needs z. Write vector\(x, y, z\)"),
    (lambda: ground.vector(1, 2, 3, 4), "takes 3 arguments by place, got 4"),
    (lambda: ground.vector(1, 2, 3, x=1), "was given x twice"),
    (lambda: ground.rotate("b", "z", accel=1.0), "Did you mean acceleration="),
    (lambda: moving(1.0, accel=2.0), "Did you mean acceleration=.* Write moving"),
    (lambda: disk(0.5, arm, masss=2.0), "Did you mean mass="),
    (lambda: Frame("g", paren=ground), "Did you mean parent="),
]  # fmt: skip


@pytest.mark.parametrize(("f", "words"), REFUSED, ids=range(len(REFUSED)))
def test_a_slip_is_answered_with_what_to_write(f, words):
    with pytest.raises((NewtonEulerError, AttributeError), match=words):
        f()


@pytest.mark.parametrize("line", [
    "from newton_euler import disk", "from newton_euler.scenes import disk",
    "from newton_euler.dynamics import dsk",
])  # fmt: skip
def test_an_import_says_where_the_name_lives(line):
    with pytest.raises(ImportError, match=r"from newton_euler\.bodies import disk"):
        exec(line, {"__name__": "notebook"})
    assert not hasattr(newton_euler, "disk")


def test_what_has_a_meaning_stays():
    """A product may have any meaning: velocity times time, or acceleration times mass."""
    s, other = 0.5, ground.rotate("arm", "z", rate=1.0).point("P", 1.0, 0, 0)
    total = (v * s + a * s**2 / 2).expressed_in(arm)
    assert total == arm.vector(3.0 - 3.0, 0, 0) + v * s + a * s * s / 2 - arm.vector(0.0, 0, 0)
    assert (F - 2.0 * a).norm() < 1e-12
    assert v + other.velocity(ground) == other.velocity(ground) + v
    assert "mm/s" in str(v.explain("mm/s"))
    assert "furlong" in str(a.explain("furlong"))
    assert np.arange(2.0) * m * v is not None
    assert (np.float64(2.0) * m).value == 2 * m.value
    assert moving(math.inf).value == math.inf
    assert moving(1.0).rate == 0


def public_functions():
    for room in sorted(newton_euler.ROOMS):
        for name, f in vars(importlib.import_module(f"newton_euler.{room}")).items():
            if (
                inspect.isfunction(f)
                and f.__module__.startswith("newton_euler.")
                and name[0] != "_"
            ):
                yield name, f


def in_words(f):
    """Whether a call with an unknown argument is refused in the engine's words."""
    try:
        f(zzz=1)
    except NewtonEulerError:
        return True
    except TypeError:
        return False
    return False


def test_every_public_function_but_the_simplest_names_the_arguments_that_it_takes():
    assert {name for name, f in public_functions() if not in_words(f)} <= SIMPLE


SIMPLE = {
    "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "sqrt",
    "atan2", "where", "radians", "pi", "moving", "compiled", "is_numeric", "is_zero", "cross", "dot",
    "same", "unit", "explain", "judge", "sentence", "scene", "ladder",
}  # fmt: skip


@pytest.mark.parametrize(("wrong", "names", "meant"), [
    ("Coriolis", ["origin", "coriolis"], "coriolis"), ("accel", ["rate", "acceleration"], "acceleration"),
    ("Euler term", ["euler_term", "euler"], "euler_term"), ("wieght", ["weight"], "weight"),
    ("x", ["mass", "density"], ""), ("", ["a"], ""), (3, ["a"], ""), ("m", ["a", "mass"], "mass"),
])  # fmt: skip
def test_the_nearest_name(wrong, names, meant):
    assert nearest(wrong, names) == meant


def test_an_argument_error_is_a_type_error():
    with pytest.raises(TypeError):
        ground.vector()
    assert issubclass(ArgumentError, TypeError)
