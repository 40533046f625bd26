"""Every public name refuses bad values in words: a sample here, all of them with -m slow."""

import inspect
import math

import mpmath
import numpy as np
import pytest

from newton_euler.algebra.scalars import Scalar, ScalarError
from tests.fuzz.bad import quantities
from tests.fuzz.judge import judged, outcome, stripped, table, trials
from tests.fuzz.names import public_callables
from tests.fuzz.valid import valid_calls

# Python itself refuses 10**400 in a sum with floats, and arguments for a function that takes none,
# in these words
PYTHONS_OWN = (
    "int too large to convert to float",
    "integer division result too large",
    "takes 0 positional arguments",
)

SOON = 3.0  # seconds for a refusal
PATIENCE = 30.0  # seconds for a call: the machine may be busy


@pytest.fixture(scope="module")
def public():
    """The public names, and a valid call of each."""
    functions = public_callables()
    return functions, valid_calls(functions)


def unworded(found):
    """The calls that ended in an error from inside, or did not end."""
    return [
        f"{name}({argument}={bad}): {message}"
        for name, rows in found.items()
        for argument, bad, result, message in rows
        if result in ("raw", "slow") and not any(words in message for words in PYTHONS_OWN)
    ]


def test_nearly_every_public_name_has_a_valid_call(public):
    functions, calls = public
    assert len(functions) > 400
    # figures need a drawing function and a notebook, practice its file; choosing writes one;
    # without_rates and cleared have no arguments
    without = {n for n in {*functions} - {*calls} if not n.endswith((".without_rates", ".cleared"))}
    of_a_file = {n for n in without if n.lower().startswith("classroom.practice")}
    shown = {"classroom.interactive_figure", "classroom.show_figure"}
    shown |= {"accuracy.compare", "accuracy.show_chart", "classroom.Prediction.choose"}
    assert without - of_a_file == shown


def test_valid_calls_are_answered(public):
    functions, calls = public
    for name in ("kinematics.frenet", "bodies.tube", "dynamics.audit", "algebra.Vector.dot"):
        positional, named = calls[name]
        assert outcome(functions[name], positional, named)[0] == "answered", name


def room_of(name):
    return name.partition(".")[0]


@pytest.mark.filterwarnings("ignore:.*multi-threaded:DeprecationWarning")
@pytest.mark.parametrize(
    "room", ["algebra", "kinematics", "bodies", "dynamics", "motion", "applications", "classroom"]
)
def test_a_sample_of_bad_values_is_refused_in_words(public, room):
    functions, calls = public
    chosen = {n: f for n, f in functions.items() if room_of(n) == room}
    found = table(chosen, calls, every=250, seconds=PATIENCE)
    assert sum(map(len, found.values())) > 10
    assert not unworded(found)


# their valid call takes seconds
SLOW_CALLS = ("accuracy.timed", "drawing.animate")


@pytest.mark.slow
def test_all_bad_values_are_refused_in_words(public):
    functions, calls = public
    quick = {n: f for n, f in functions.items() if not n.startswith(SLOW_CALLS)}
    assert not unworded(table(quick, calls, seconds=PATIENCE))


def test_no_argument_of_a_model_or_a_motion_takes_a_quantity_and_drops_its_unit(public):
    functions, calls = public
    taken = [
        (name, label, word)
        for name in (n for n in calls if room_of(n) == "motion")
        for label, word, make, with_value in trials(functions[name], calls[name])
        if word in quantities() and outcome(functions[name], *with_value(make()))[0] == "answered"
    ]
    assert taken == []


MECHANICS = "kinematics", "bodies", "dynamics", "applications"
UNREAL = {"1+2j": 1 + 2j, "of NumPy": np.complex128(1j), "of mpmath": mpmath.mpc(1, 2),
          "an array of it": np.array([1j, 2.0]), "an empty array": np.zeros(0)}  # fmt: skip


@pytest.mark.parametrize("unreal", UNREAL)
def test_no_number_of_mechanics_is_complex_and_no_array_of_them_empty(public, unreal):
    functions, calls = public
    answered, tried = [], 0
    for name in (n for n in calls if room_of(n) in MECHANICS):
        kinds = inspect.signature(functions[name]).parameters
        for label, word, _, with_value in trials(functions[name], calls[name]):
            if word == "None" and label in kinds and kinds[label].annotation in ("Scalar", Scalar):
                tried += 1
                found = outcome(functions[name], *with_value(UNREAL[unreal]), PATIENCE)
                answered += [(name, label, found)] * (found[0] != "refused")
    assert tried > 200
    assert not answered


# by the name of the parameter; a tolerance to be reached is not zero and not below round-off
TOLERANCES = "rtol", "atol", "tolerance", "accuracy", "within"
NO_TOLERANCE = {"nan": math.nan, "-1e-9": -1e-9, "text": "1e-9", "array": np.array([1e-9, 1e-6])}
NOT_REACHED = {"zero": 0.0, "no float": 10**400, "below round-off": 1e-30, "infinite": math.inf}


@pytest.mark.parametrize("bad", [*NO_TOLERANCE, *NOT_REACHED])
def test_every_tolerance_that_means_nothing_is_refused_at_once(public, bad):
    functions, calls = public
    found = {}
    for name, call in calls.items():
        for label in inspect.signature(inspect.unwrap(functions[name])).parameters:
            reached = label == "rtol" and not name.endswith(".balances")  # which compares by it
            if label in TOLERANCES and (bad in NO_TOLERANCE or reached):
                found[name] = of_label(
                    functions[name], call, label, (NO_TOLERANCE | NOT_REACHED)[bad]
                )
    assert len(found) > (20 if bad in NO_TOLERANCE else 6)
    assert {name: x for name, x in found.items() if x[0] != "refused"} == {}


def of_label(f, call, label, value):
    """The outcome of a call with this value for an argument."""
    (positional, named), names = call, [*inspect.signature(inspect.unwrap(f)).parameters]
    positional, at = positional[inspect.isclass(f) :], names.index(label)
    if at < len(positional):
        positional = [*positional[:at], value, *positional[at + 1 :]]
    else:
        named = {**named, label: value}
    return outcome(f, positional, named, SOON)


# Python's messages for arguments that do not fit
OF_THE_CALLER = (
    IndexError("tuple index out of range"), TypeError("'int' object is not iterable"),
    ValueError("not enough values to unpack"), ArithmeticError("of a library"),
    StopIteration("no more"),
)  # fmt: skip


def functions_in(positional, named):
    """The places of functions among the arguments of a call."""
    return [
        *(n for n, x in enumerate(positional) if inspect.isfunction(x)),
        *(name for name, x in named.items() if inspect.isfunction(x)),
    ]


@pytest.mark.parametrize("error", OF_THE_CALLER, ids=lambda e: type(e).__name__)
def test_what_a_function_of_the_caller_raises_arrives_as_raised(public, error):
    functions, calls = public
    raised, changed = 0, {}
    for name, (positional, named) in calls.items():
        for place in functions_in(positional, named) if name != "classroom.error_message" else ():

            def own(*_, **more):
                raise error

            given = dict(enumerate(positional)) | named
            own.__signature__ = inspect.signature(given[place])
            given[place] = own
            (*rest,) = (given.pop(n) for n in range(len(positional)))
            try:
                functions[name](*rest[inspect.isclass(functions[name]) :], **given)
            except Exception as found:  # calls that keep the function for later raise nothing
                raised += 1
                if found is not error:
                    changed[name, place] = found
    assert raised > 25
    assert changed == {}


def test_an_error_from_inside_is_distinguished_from_one_in_words():
    bug = lambda x: {}[x]

    def worded(x):
        raise ScalarError("expected a number")

    def endless(x):
        while True:
            pass

    assert outcome(bug, [1], {})[0] == "raw"
    assert outcome(worded, [1], {})[0] == "refused"
    assert outcome(abs, [1], {})[0] == "answered"
    assert outcome(endless, [1], {}, 0.5) == ("slow", "no answer in 0.5 s")


def drops(q):
    """A function that drops a unit."""
    return float(getattr(q, "magnitude", 0.0))


def test_a_unit_that_is_dropped_is_counted():
    assert stripped(judged(drops, ([1.0], {})))
