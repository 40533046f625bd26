"""What a right-hand side reads besides its arguments counts as it is at the time of integration: no
motion depends on what ran before.
"""

import math
import sys
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from types import FunctionType, ModuleType, SimpleNamespace

import numpy as np
import pytest

from newton_euler import Event, Model, integrate, prepare, sin
from newton_euler.algebra.reads import Reads
from newton_euler.motion.model import second_order
from newton_euler.motion.prepared import prepared_model
from newton_euler.scenes import scene
from newton_euler.scenes.ladders import Ladder, Rung, observed_states
from tests.honesty.limits import frequent_switches

START, T = (0.0, 0.0), 2.0
RATES = {"G": 9.81, "sin": sin}  # what the cells of a notebook below define


def cell(text, name="rhs", **more):
    """What a cell of a notebook defines, with the globals of the notebook: a dict."""
    space = {**RATES, "__name__": "__main__", **more}
    exec(text, space)
    return space


FALL = "def rhs(s, p, t): return s.v, -G"


def fallen(model, **options):
    """How far a body has fallen after two seconds, for a unit of acceleration."""
    return -2 * integrate(model, T, START, **options).end["h"] / T**2


def model_of(rhs, **more):
    return Model("fall", more.pop("parameters", {}), ("h", "v"), rhs, **more)


@pytest.mark.parametrize("method", ["dop853", "taylor", "verlet", "scipy LSODA", "auto"])
@pytest.mark.parametrize("again", [True, False], ids=["new model", "same model"])
def test_a_global_counts_as_it_is_when_the_model_is_integrated(method, again):
    space = cell(FALL)
    model = model_of(space["rhs"])
    assert fallen(model, method=method, rtol=1e-7) == pytest.approx(9.81, rel=1e-6)
    space["G"] = 1.62
    model = model_of(space["rhs"]) if again else model
    assert fallen(model, method=method, rtol=1e-7) == pytest.approx(1.62, rel=1e-6)
    assert model.derivative(START) == (0.0, -1.62)


def of_cell(text, **more):
    """The right-hand side of a cell that reads the global G, and a function that changes G."""
    space = cell(text, **more)
    return space["rhs"], lambda: space.update(G=1.62)


def of_new_helper():
    space = cell("def pull(): return -9.81\ndef rhs(s, p, t): return s.v, pull()")
    return space["rhs"], lambda: exec("def pull(): return -1.62", space)


def of_closure():
    g = 9.81

    def change():
        nonlocal g
        g = 1.62

    return lambda s, p, t: (s.v, -g), change


def of_closed_helper():
    space = cell("def make(f): return lambda s, p, t: (s.v, f())\ndef pull(): return -G")
    return space["make"](space["pull"]), lambda: space.update(G=1.62)


def of_mutable_default(default):
    rhs = lambda s, p, t, g=default: (s.v, -g[0])
    return rhs, lambda: default.__setitem__(0, 1.62)


def of_default():
    rhs = lambda s, p, t, g=9.81: (s.v, -g)
    return rhs, lambda: setattr(rhs, "__defaults__", (1.62,))


def of_keyword_default():
    rhs = lambda s, p, t, *, g=9.81: (s.v, -g)
    return rhs, lambda: rhs.__kwdefaults__.update(g=1.62)


def of_attribute(constants):
    """An attribute of an object, a class or a module."""
    constants.g = 9.81
    return lambda s, p, t: (s.v, -constants.g), lambda: setattr(constants, "g", 1.62)


def of_dict():
    space = cell("def rhs(s, p, t): return s.v, -CONSTANTS['g']", CONSTANTS={"g": 9.81})
    return space["rhs"], lambda: space["CONSTANTS"].update(g=1.62)


def of_array(g):
    return lambda s, p, t: (s.v, -float(g[0])), lambda: g.fill(1.62)


def of_module(name, text):
    sys.modules[name] = module = ModuleType(name)
    module.g = 9.81
    return cell(text, constants=module)["rhs"], lambda: setattr(module, "g", 1.62)


class Rates:
    """Its bound method and the object itself are right-hand sides."""

    __hash__ = None

    def __init__(self):
        self.g = 9.81

    def __call__(self, s, p, t):
        return s.v, -self.g


def of_object(rates, rhs):
    return rhs, lambda: setattr(rates, "g", 1.62)


def of_partial():
    space = cell("def rates(k, s, p, t): return s.v, -k*G")
    return partial(space["rates"], 1.0), lambda: space.update(G=1.62)


def of_code():
    rhs, other = cell(FALL)["rhs"], cell("def rhs(s, p, t): return s.v, -1.62")["rhs"]
    return rhs, lambda: setattr(rhs, "__code__", other.__code__)


def of_name_that_comes():
    space = cell("def rhs(s, p, t): return s.v, -9.81*abs(1)")
    return space["rhs"], lambda: space.update(abs=lambda x: 1.62 / 9.81)


def of_engine_closure():
    space = cell("def pull(s, p, t): return (-G,)")
    rhs = second_order("fall", {}, ("h",), space["pull"]).rhs
    return lambda s, p, t: rhs(SimpleNamespace(dh=s.v), p, t), lambda: space.update(G=1.62)


CALLED = "def pull(): return -G\ndef rhs(s, p, t): return s.v, pull()"
INNER = "def rhs(s, p, t):\n    pull = lambda: -G\n    return s.v, pull()"
IMPORTED = "def rhs(s, p, t):\n    from constants_inside import g\n    return s.v, -g"
# ways to change what a right-hand side reads: functions without arguments that return a right-hand
# side with the acceleration 9.81, and a function that makes it 1.62
WAYS = {
    "global": lambda: of_cell(FALL),
    "helper": lambda: of_cell(CALLED),
    "new helper": of_new_helper,
    "inner function": lambda: of_cell(INNER),
    "closure": of_closure,
    "closed helper": of_closed_helper,
    "mutable default": lambda: of_mutable_default([9.81]),
    "default": of_default,
    "keyword default": of_keyword_default,
    "attribute": lambda: of_attribute(SimpleNamespace()),
    "dict": of_dict,
    "array": lambda: of_array(np.array([9.81])),
    "class": lambda: of_attribute(type("Moon", (), {})),
    "module": lambda: of_module(
        "constants_of_a_user", "def rhs(s, p, t): return s.v, -constants.g"
    ),
    "module inside": lambda: of_module("constants_inside", IMPORTED),
    "method": lambda: of_object(rates := Rates(), rates.__call__),
    "object": lambda: of_object(rates := Rates(), rates),
    "partial": of_partial,
    "code": of_code,
    "name that comes": of_name_that_comes,
    "eval": lambda: of_cell("def rhs(s, p, t): return s.v, -eval('G')"),
    "closure of the engine": of_engine_closure,
}


@pytest.mark.parametrize("make", WAYS.values(), ids=WAYS)
@pytest.mark.parametrize("ran_before", [True, False])
def test_whatever_a_right_hand_side_reads_it_is_not_stale(make, ran_before):
    """The motion after the change is the same, bit for bit, whether or not one ran before it."""
    rhs, change = make()
    model = model_of(rhs)
    if ran_before:
        assert fallen(model, method="dop853", rtol=1e-6) == pytest.approx(9.81, rel=1e-5)
    change()
    expected = fallen(model_of(lambda s, p, t: (s.v, -1.62)), method="dop853", rtol=1e-6)
    assert fallen(model, method="dop853", rtol=1e-6) == pytest.approx(expected, rel=1e-14)
    assert fallen(model_of(rhs), method="dop853", rtol=1e-6) == pytest.approx(expected, rel=1e-14)


def test_a_law_among_the_parameters_is_not_stale():
    space = cell("def law(s, p, t): return G")
    model = model_of(lambda s, p, t: (s.v, -p.g), parameters={"g": space["law"]})
    assert fallen(model) == pytest.approx(9.81)
    space["G"] = 1.62
    assert fallen(model) == pytest.approx(1.62)
    assert fallen(model.changed(g=space["law"])) == pytest.approx(1.62)


def test_two_laws_of_one_right_hand_side_do_not_mix_in_an_invariant():
    """The rates do not contain the law, so both models have equal texts; the invariant does."""
    rhs, invariants = lambda s, p, t: (s.v, -1.0), {"weight": lambda s, p, t: p.w + 0 * s.v}
    laws = lambda s, p, t: 1.0, lambda s, p, t: 1.0 + t
    models = [model_of(rhs, parameters={"w": law}, invariants=invariants) for law in laws]
    drifts = [integrate(model, T, START).drift["weight"] for model in models]
    assert drifts == [0.0, pytest.approx(2 / 3)]


def test_an_exact_solution_is_not_stale():
    space = cell("def exact(s, p, t): return s.h + s.v*t - G*t*t/2, s.v - G*t\n" + FALL)
    model = model_of(space["rhs"], exact=space["exact"])
    assert fallen(model) == pytest.approx(9.81)
    space["G"] = 1.62
    assert fallen(model) == pytest.approx(1.62)
    motion = integrate(model, T, START)
    assert motion.method.name == "exact"
    space["G"] = 3.7
    # what has been computed stays, and so does what is computed from it later
    assert motion.at(1.0)["h"] == pytest.approx(-1.62 / 2)
    assert motion.end["h"] == pytest.approx(-1.62 * 2)


def test_invariants_belong_to_the_motion_that_they_are_of():
    """The drift is computed on demand, with the globals with which the motion was made."""
    space = cell("def energy(s, p, t): return s.v*s.v/2 + G*s.h\n" + FALL)
    model = model_of(space["rhs"], invariants={"energy": space["energy"]})
    first = integrate(model, T, (1.0, 0.0), 1e-9)
    space["G"] = 1.62
    second = integrate(model, T, (1.0, 0.0), 1e-9)
    assert first.drift["energy"] < 1e-9
    assert second.drift["energy"] < 1e-9
    assert model.invariant("energy", (1.0, 0.0)) == 1.62


def test_an_event_is_not_stale():
    space = cell("def floor(s, p, t): return s.h - HEIGHT", HEIGHT=-1.0)
    model, event = model_of(lambda s, p, t: (s.v, -2.0)), Event(space["floor"], terminal=True)
    assert integrate(model, T, START, events=event).t_end == pytest.approx(1.0)
    space["HEIGHT"] = -2.25
    assert integrate(model, T, START, events=event).t_end == pytest.approx(1.5)


def test_what_is_prepared_stays_as_it_was():
    space = cell(FALL)
    model = model_of(space["rhs"])
    run = prepare(model, method="dop853")
    before = run(T, START)
    space["G"] = 1.62
    assert run(T, START) == before
    assert prepare(model, method="dop853")(T, START)[1] == pytest.approx(-1.62 * T)
    assert before[1] == pytest.approx(-9.81 * T)


def test_a_right_hand_side_that_has_become_wrong_is_refused_in_words():
    space = cell("def rates(s): return s.v, -G\ndef rhs(s, p, t): return rates(s)")
    model_of(space["rhs"])
    exec("def rates(s): return (s.v,)", space)
    with pytest.raises(ValueError, match="returns 1 rates for the 2 states"):
        model_of(space["rhs"])


def test_the_error_of_a_rung_is_not_stale():
    space = cell("def rhs(s, p, t): return s.v, -G")
    observed = observed_states("h")
    rungs = [
        Rung(Model(name, {}, ("h", "v"), rhs), START, observed)
        for name, rhs in (("slow", space["rhs"]), ("full", lambda s, p, t: (s.v, -10.0)))
    ]
    ladder = Ladder("fall", "height, m", T, tuple(rungs))
    assert ladder.error(rungs[0]) == pytest.approx(2 * 0.19)
    space["G"] = 8.0
    assert ladder.error(rungs[0]) == pytest.approx(2 * 2.0)


def test_an_unchanged_model_is_prepared_once():
    for model in (
        scene("free body").make()[0],
        model_of(lambda s, p, t: (s.v, -sin(1.0) * T), invariants={"v": lambda s, p, t: s.v * T}),
        model_of(cell(FALL)["rhs"]),
    ):
        assert prepared_model(model) is prepared_model(model)


def test_equal_texts_share_one_compilation():
    """Lambdas written again in each cell cost heyoka's compilation once."""
    pytest.importorskip("heyoka")
    known = []
    for _ in range(3):
        model = model_of(cell("rhs = lambda s, p, t: (s.v, -sin(s.h)*G - 0.123456)")["rhs"])
        integrate(model, T, START, method="taylor")
        known.append(prepared_model(model).traced)
    assert known[0] is known[1] is known[2]
    other = model_of(cell("rhs = lambda s, p, t: (s.v, -sin(s.h)*G - 0.123457)")["rhs"])
    assert prepared_model(other).traced is not known[0]


@pytest.mark.parametrize(
    ("one", "other"), [("0.0", "-0.0"), ("1", "1.0"), ("2.5", "2.5000000000000004")]
)
def test_texts_with_other_constants_are_distinct(one, other):
    texts = [
        prepared_model(model_of(eval(f"lambda s, p, t: (s.v, {c})"))).traced for c in (one, other)
    ]
    assert texts[0] is not texts[1]


def test_functions_of_the_engine_read_nothing():
    for name in ("free body", "top", "pendulum", "planet"):
        model = scene(name).make()[0]
        for f in (model.rhs, model.exact, *model.invariants.values()):
            if isinstance(f, FunctionType) and f.__closure__ is None:
                reads = Reads(f)
                assert reads.known
                assert not reads.checks


def test_names_of_states_are_not_globals():
    """A notebook with a list x and a state x traces no more often than any other."""
    space = cell("def rhs(s, p, t): return s.v, -s.h", h=[1, 2], v={})
    reads = Reads(space["rhs"])
    space["h"] = [3]
    assert reads.known
    assert reads.hold()


def test_functions_that_call_each_other_are_read_once():
    space = cell(
        "def even(n): return n == 0 or odd(n - 1)\ndef odd(n): return n != 0 and even(n - 1)\n"
        "def rhs(s, p, t): return s.v, -G if even(4) else G"
    )
    reads = Reads(space["rhs"])
    assert reads.hold()
    space["odd"] = lambda n: False
    assert not reads.hold()


def test_threads_that_change_and_integrate_do_not_mix():
    """Each thread has its own constants, and one function makes all right-hand sides."""
    wrong = []

    def work(seed):
        for n in range(40):
            g = 1.0 + (7 * n + seed) % 13
            found = fallen(model_of(lambda s, p, t, g=g: (s.v, -g)), method="dop853", rtol=1e-6)
            if not math.isclose(found, g, rel_tol=1e-5):
                wrong.append((seed, g, found))

    with frequent_switches(), ThreadPoolExecutor(4) as pool:
        list(pool.map(work, range(4)))
    assert wrong == []
