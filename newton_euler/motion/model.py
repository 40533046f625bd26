"""Models: the equations of motion of one scene in state-variable form (chapters 6, 8).

A :class:`Model` says which states there are and how fast they change; it integrates nothing. Its
functions all take ``(s, p, t)``: the states by name, the parameters by name, and the time, over
scalars of every kind, so that a formula reads as it is printed: ``s.v*cos(s.gamma)``.
"""

import math
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence, Set
from contextlib import suppress
from dataclasses import dataclass, field, replace
from inspect import Parameter, Signature
from itertools import islice
from keyword import iskeyword
from types import FunctionType, MappingProxyType
from typing import Any, NoReturn
from unicodedata import normalize
from warnings import warn

from ..algebra import scalars
from ..algebra.compile import Compiled, Recording, compiled, content, recorded, text_of
from ..algebra.errors import LONGEST_SEQUENCE, NewtonEulerError, checked
from ..algebra.late import np
from ..algebra.names import guided, misfit
from ..algebra.places import at_a_place, note_place, raised_by_the_engine
from ..algebra.portable import Formula, Formulas, Portable, Values
from ..algebra.reads import Reads
from ..algebra.scalars import Scalar, ScalarError, advice, clipped, real_scalar, scalar, to_plain
from ..algebra.tables import Table

# a state: its values in the order of the states, or by name
State = Iterable[Scalar] | Mapping[str, Scalar]

KEPT = 64  # entries of a cache: functions that are made at each call, like lambdas, would pile up
MOST_VALUES = 1000  # values of a state of wrong length that are counted for the message
# texts of right-hand sides: by function, and by content, since equal texts share one compilation
_BY_FUNCTION: dict = {}
_BY_CONTENT: dict = {}


class ModelError(NewtonEulerError, ValueError):
    """Raised for a model whose parts do not fit together, and for requests that it cannot meet."""


def expect(fits: object, what: str, got: object) -> None:
    """Raise :class:`ModelError` with what was expected unless it ``fits``."""
    if not fits:
        raise ModelError(f"{what}, got {clipped(got)}")


class Named:
    """Values by name, as ``s.v``; an AttributeError for an unknown name lists the known ones."""

    def __init__(self, what: str, values: Mapping[str, Scalar]):
        vars(self).update({**values, "": what})  # a name that no state and no parameter has

    def __repr__(self):
        return f"({', '.join(f'{n} = {clipped(x)}' for n, x in vars(self).items() if n)})"

    def __getattr__(self, name: str) -> Scalar:
        if name.startswith("__"):
            raise AttributeError(name)
        known = ", ".join(filter(None, vars(self))) or "none"
        raise AttributeError(f"there is no {vars(self)['']} {name!r}; there are {known}")

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise AttributeError(f"the {vars(self)['']}s are only read, but {name!r} was set")

    def __iter__(self) -> NoReturn:
        what = vars(self)[""]
        known = [f"{what[0]}.{n}" for n in vars(self) if n]
        raise TypeError(f"the {what}s are read by name, as {', '.join(known) or 'none'}")

    def __getitem__(self, *_: object, **__: object) -> NoReturn:
        self.__iter__()

    __array__ = __getitem__


@checked
@dataclass(frozen=True)
class Neglected(Portable):
    """An effect that a model neglects, with a bound on the resulting error.

    what : in words, as "the rotation of the earth"
    bound : an upper bound of the error, ``(s, p, t)`` of start, parameters and time passed; or None
    of : the quantity whose error is bounded, with its unit, as "position, m"

    >>> air = Neglected("the air", lambda s, p, t: 0.01 * t**2, "position, m")
    >>> air.bound(None, None, 2.0)
    0.04
    """

    what: str
    bound: Formula | None
    of: str


@guided
@dataclass(frozen=True, eq=False)
class Model(Portable):
    """The equations of motion of a scene: ``s' = rhs(s, p, t)``.

    name : of the scene and of the rung of its ladder
    parameters : by name, a scalar each, or a *law*: a function ``(s, p, t)`` of states, scalar
        parameters and time, as a thrust; or a :func:`~newton_euler.table`, read as p.thrust(t)
    states : their names, in the order of all tuples of states
    rhs : a function ``(s, p, t)`` that returns their rates in this order, without branches
    invariants : by name, functions ``(s, p, t)`` that keep their value during the motion
    exact : a function ``(s, p, t)``, the exact states at the time t after ``s`` at t = 0; or None
    neglects : the neglected effects, a tuple of :class:`Neglected`

    The right-hand side is tried at once, without values: :class:`ModelError` says what is wrong.

    A model stores functions, not their values: what they read besides (s, p, t), as a global of a
    notebook, is read at each call, and by :func:`~newton_euler.integrate` at the beginning of each
    integration. So a change takes effect from the next call on, for every model; a motion, and what
    :func:`~newton_euler.prepare` returned, stay as they were computed. In a pickle, functions of a
    module are names; lambdas and functions of a notebook are steps, with what they read then.

    >>> def thrown(s, p, t):
    ...     return s.h + s.v * t - p.g * t * t / 2, s.v - p.g * t
    >>> rates = lambda s, p, t: (s.v, -p.g)
    >>> fall = Model("free fall", {"g": 9.81}, ("h", "v"), rates, exact=thrown)
    >>> fall.derivative((100.0, 0.0)), fall.solution(2.0, (100.0, 0.0))
    ((0.0, -9.81), (80.38, -19.62))
    >>> fall.changed(g=1.62).compiled_rhs()(0.0, 100.0, -3.0)
    (-3.0, -1.62)
    """

    name: str
    parameters: Mapping[str, Scalar | Formula]
    states: tuple[str, ...]
    rhs: Formulas
    invariants: Mapping[str, Formula] = field(default_factory=dict)
    exact: Formulas | None = None
    neglects: tuple[Neglected, ...] = ()

    def __post_init__(self):
        for what in ("parameters", "invariants"):
            object.__setattr__(self, what, MappingProxyType(_by_name(what, getattr(self, what))))
        for what in ("states", "neglects"):
            object.__setattr__(self, what, _several(what, getattr(self, what)))
        self._check_names()
        self._check_functions()
        self._check_rhs()

    def __repr__(self):
        return f"Model({self.name!r}: {', '.join(self.states)}; {', '.join(self.parameters)})"

    def derivative(self, state: State, t: Scalar = 0) -> tuple[Scalar, ...]:
        """The rates, a tuple in the order of states, at a ``state`` in that order or by name."""
        try:
            return tuple(self._value(self.rhs, state, t))
        except (ZeroDivisionError, OverflowError) as error:
            singular = isinstance(error, ZeroDivisionError)
            advice = "; the coordinates are singular there" if singular else ""
            what = f"{self.name} has no rates at {clipped(self._state(state))}"
            at_a_place(error, ModelError, what, advice)
            raise
        except Exception as error:
            note_place(error)
            raise

    def compiled_rhs(self, *free: str) -> Compiled:
        """The right-hand side as fast straight-line code, see :func:`newton_euler.compiled`: a
        function ``(t, *states, *free)`` of scalars.

        free : names of parameters that stay arguments; the others are fixed now

        For SciPy take its text on floats, which checks nothing and is faster than a function that
        is written by hand on NumPy's numbers: ``f = rhs.on_floats``, and then
        ``lambda t, y: f(t, *y.tolist())``.

        >>> fall = Model("fall", {"g": 9.81}, ("h", "v"), lambda s, p, t: (s.v, -p.g))
        >>> fall.compiled_rhs().on_floats(0.0, 100.0, -3.0)
        (-3.0, -9.81)
        """
        self._expect("parameter", free, self.parameters)
        return compiled(self._formula(self._rates, free))

    def _rates(self, s, p, t):
        rates = self.rhs(s, p, t)
        if not isinstance(rates, Iterable) or isinstance(rates, (str, Mapping, Set)):
            raise ModelError(
                f"the right-hand side of {self.name!r} returns the rates of its states, a tuple in "
                f"the order {', '.join(self.states)}; got one {type(rates).__name__}"
            )
        return tuple(rates)

    def _formula(self, f, free):
        """A function ``f(s, p, t)`` of this model as one to compile, ``(t, *states, *free)``."""

        def values(**named):
            parameters = {**self.parameters, **{n: named[n] for n in free}}
            return self._call(f, {n: named[n] for n in self.states}, parameters, named["t"])

        values.__name__ = self.name
        kind, names = Parameter.POSITIONAL_OR_KEYWORD, ("t", *self.states, *free)
        values.__signature__ = Signature([Parameter(n, kind) for n in names])
        return values

    def _rhs_text(self, free, fixed, laws):
        """What the right-hand side and the laws read, and its text: a pair; see :func:`current`.
        Parameters are its arguments if their names are ``free``; others are ``fixed``, pairs (name,
        value), of which the functions are ``laws``.
        """

        def text():
            return shared(recorded(self._formula(self._rates, free)))

        return current(_BY_FUNCTION, (self.rhs, self.states, free, fixed), (self.rhs, *laws), text)

    def solution(self, t: Scalar, start: State) -> tuple[Scalar, ...]:
        """The states at time ``t`` after ``start`` at t = 0, exactly, as a tuple;
        :class:`ModelError` where no exact solution is known.
        """
        if self.exact is None:
            raise ModelError(f"no exact solution of {self.name!r} is known; integrate it")
        found = self._value_of("exact solution", self.exact, start, t)
        states = tuple(found) if is_iterable(found) else ()
        what = f"the exact solution of {self.name!r} returns a value for each of "
        expect(len(states) == len(self.states), what + ", ".join(self.states), found)
        return states

    def invariant(self, name: str, state: State, t: Scalar = 0) -> Scalar:
        """The value of one invariant at a state."""
        self._expect("invariant", [name], self.invariants)
        found = self._value_of(f"invariant {name!r}", self.invariants[name], state, t)
        what = f"the invariant {name!r} of {self.name!r} returns a number"
        expect(_is_scalar(found), what, found)
        return found

    def _value_of(self, what, f, state, t):
        """:meth:`_value`; an error names ``what``."""
        try:
            return self._value(f, state, t)
        except (ZeroDivisionError, OverflowError) as error:
            divided = isinstance(error, ZeroDivisionError)
            kind = scalars.DivisionError if divided else scalars.RangeError
            place = f"at t = {clipped(t)}, {clipped(state)}"
            at_a_place(error, kind, f"the {what} of {self.name!r} has no value {place}")
            raise
        except Exception as error:
            note_place(error)
            raise

    def neglected(self, t: Scalar, start: State) -> dict[Neglected, Scalar]:
        """{:class:`Neglected`: the bound on its error at ``t`` from ``start``, inf if unknown}."""
        start, t = self._state(start), self._time(t)  # checked even if no bound needs them
        return {
            n: self._value_of("bound on what it neglects", n.bound, start, t)
            if n.bound
            else math.inf
            for n in self.neglects
        }

    def changed(self, /, **parameters: Scalar) -> "Model":
        """The same model with some parameters changed; ``self`` stays as it is."""
        self._expect("parameter", parameters, self.parameters)
        return replace(self, parameters={**self.parameters, **parameters})

    def _expect(self, what, names, known):
        for name in names:
            if not isinstance(name, str) or name not in known:
                names = ", ".join(known) or "none"
                raise ModelError(f"{self.name} has no {what} {clipped(name)}; it has {names}")

    def _state(self, state):
        """A state, given in order or by name, as a dict by name."""
        names = self.states
        if isinstance(state, Mapping):
            missing = ", ".join(n for n in names if n not in state)
            if missing:
                raise ModelError(
                    f"the state of {self.name!r} has no {missing}; give all of {', '.join(names)}"
                )
            return {n: state[n] for n in names}
        if type(state) is not tuple:
            state = self._in_order(state)
        if len(state) != len(names):
            count = f"{len(state)} values" if len(state) <= MOST_VALUES else "more values"
            raise ModelError(
                f"{self.name} has the {len(names)} states {', '.join(names)}; got {count}: "
                f"{clipped(state)}"
            )
        return dict(zip(names, state, strict=True))

    def _in_order(self, state):
        """A state given in order as a tuple, of no more values than a message needs."""
        if type(state) is list:
            return tuple(state)
        unordered = isinstance(state, (str, bytes, set, frozenset))
        if unordered or not is_iterable(state) or has_unit(state):
            raise ModelError(
                f"a state of {self.name!r} is a value for each of {', '.join(self.states)}, in "
                f"this order or by name; got {clipped(state)}{unit_advice(state)}"
            )
        return tuple(islice(state, max(len(self.states), MOST_VALUES) + 1))

    def _time(self, t):
        """The time ``t`` as a number of any kind; :class:`ModelError` for anything else."""
        try:
            return t if type(t) is float else to_plain(real_scalar(t))
        except ScalarError as error:
            raise ModelError(
                f"t is a time of {self.name!r}, a number (float, array, mpf or expression); got "
                f"{clipped(t)} of type {type(t).__name__}{advice(t)}"
            ) from error

    def _call(self, f, state, parameters, t):
        """``f(s, p, t)``, with the value of each law at this state in p."""
        s = Named("state", {n: scalar(x) for n, x in state.items()})
        p = Named("parameter", {n: scalar(x) for n, x in parameters.items() if not is_law(x)})
        laws = {n: x for n, x in parameters.items() if is_law(x)}
        tables = {n: x for n, x in laws.items() if isinstance(x, Table)}
        # evaluated before any is added: a law sees numbers and tables only, not other laws
        vars(p).update(tables)
        vars(p).update({n: scalar(x(s, p, t)) for n, x in laws.items() if n not in tables})
        return f(s, p, t)

    def _value(self, f, state, t):
        """``f(s, p, t)`` at a state, a tuple for several scalars."""
        x = self._call(f, self._state(state), self.parameters, self._time(t))
        return tuple(map(to_plain, x)) if isinstance(x, (tuple, list)) else to_plain(x)

    def _check_names(self):
        names = [*self.states, *self.parameters]
        for name in names:
            usual = isinstance(name, str) and name.isidentifier() and not iskeyword(name)
            # Python reads s.ﬁ as s.fi
            if not usual or name == "t" or name != normalize("NFKC", name):
                raise ModelError(
                    f"{name!r} cannot name a state or parameter of {self.name!r}: take a Python "
                    "name other than t, the time"
                )
            if names.count(name) > 1:
                raise ModelError(
                    f"{name!r} occurs twice in {self.name!r}; each state and parameter needs a "
                    "name of its own"
                )
        for name, x in self.parameters.items():
            wrong = isinstance(x, FunctionType) and misfit(x, (None,) * 3, {})
            data = type(x).__module__.startswith("scipy.")
            if wrong or data or (not callable(x) and not _is_scalar(x)):
                instead = f"; of data make a table(ts, values), for p.{name}(t)" if data else ""
                raise ModelError(
                    f"the parameter {name} of {self.name!r} is a number or a function (s, p, t), "
                    f"not {x!r}{instead if callable(x) else advice(x)}"
                )

    def _check_functions(self):
        expect(isinstance(self.name, str), "the name of a model is a text", self.name)
        takes = "is a function (s, p, t)"
        expect(_is_function(self.rhs), f"rhs of {self.name!r} {takes}", self.rhs)
        fits = self.exact is None or _is_function(self.exact)
        expect(fits, f"exact of {self.name!r} {takes}", self.exact)
        what = f"an invariant of {self.name!r} has a name, and {takes}"
        for name, f in self.invariants.items():
            expect(isinstance(name, str) and _is_function(f), what, (name, f))
        what = f"what {self.name!r} neglects is a tuple of Neglected(what, bound, of)"
        for x in self.neglects:
            expect(isinstance(x, Neglected), what, x)

    def _check_rhs(self):
        """One call without values: it reaches every name, as the formula has no branches."""
        what, states = f"the right-hand side of {self.name!r}", self.states
        laws = {n: x for n, x in self.parameters.items() if is_law(x)}
        free = tuple(n for n in self.parameters if n not in laws)
        try:
            reads, text = self._rhs_text(free, tuple(laws.items()), laws.values())
            again = text if reads.known else recorded(self._formula(self._rates, free))
        except (AttributeError, TypeError, ZeroDivisionError) as error:
            if not raised_by_the_engine(error):
                raise
            raise ModelError(f"{what} fails when it is tried: {error}") from error
        if len(text.leaves) != len(states):
            raise ModelError(
                f"{what} returns {len(text.leaves)} rates for the {len(states)} states "
                f"{', '.join(states)}"
            )
        if content(again) != content(text):
            raise ModelError(
                f"{what} is not the same at each call, as with random numbers or the time of day, "
                "but it is a formula: draw the numbers before, and make them parameters or a "
                "table(ts, values)"
            )
        if reads.prints:
            warn(
                f"{what} prints when it is traced, without values, not during the motion; print "
                "what integrate returns",
                stacklevel=4,
            )


def cached(cache: dict, key: Hashable, make: Callable[[], Any]) -> Any:
    """The value of a key in the cache, made if it is missing; the ``KEPT`` last used ones are kept.
    Safe for threads: two may make the same value, each for itself.
    """
    missing = cache  # a value that is certainly not in it
    found = cache.pop(key, missing)
    return _keep(cache, key, make() if found is missing else found)


def shared(formula: Recording | Compiled, cache: dict = _BY_CONTENT) -> Compiled:
    """The compiled text of a formula that is recorded or compiled; equal ones share it."""
    return cached(cache, content(formula), lambda: text_of(formula))


def current(
    cache: dict, key: Hashable, functions: Iterable[Callable], make: Callable[[], Any]
) -> tuple[Reads, Any]:
    """The :class:`~newton_euler.algebra.reads.Reads` of these functions and the value of a key in
    the cache, a pair; made again where something that the functions read has changed.
    """
    try:
        found = cache.pop(key, None)
    except TypeError:  # an object with __call__ that cannot be a key
        return Reads(*functions), make()
    if found is None or not found[0].hold():
        found = Reads(*functions), make()
    return _keep(cache, key, found) if found[0].known else found


def _keep(cache, key, value):
    cache[key] = value
    if len(cache) > KEPT:
        # another thread may add or drop one meanwhile
        with suppress(RuntimeError, StopIteration):
            cache.pop(next(iter(cache)), None)
    return value


def _is_scalar(x):
    try:
        real_scalar(x)
    except ScalarError:
        return False
    return True


def _is_function(x):
    return type(x) is FunctionType or (is_law(x) and not isinstance(x, type))


def _by_name(what, x):
    """A dict from a mapping or pairs; ``what`` names it in the message."""
    try:
        return dict(None if isinstance(x, (str, bytes)) else x)
    except (TypeError, ValueError) as error:
        what = f"the {what} of a model are a dict of values by name"
        raise ModelError(f"{what}, got {clipped(x)}") from error


def _several(what, x):
    """A tuple from an ordered sequence; ``what`` names it in the message."""
    if type(x) is tuple:
        return x
    unordered = isinstance(x, (str, bytes, set, frozenset, range)) or not is_iterable(x)
    expect(not unordered, f"the {what} of a model are a tuple of them", x)
    return tuple(x)


def is_iterable(x: object) -> bool:
    """True for what has entries, which an array without an axis has not."""
    return hasattr(x, "__iter__") and getattr(x, "shape", None) != ()


def is_law(x: object) -> bool:
    """True for a parameter that is a function; a callable symbolic expression is a number."""
    return callable(x) and not _is_scalar(x)


def is_absent(x: Scalar | Formula) -> bool:
    """True for a number that is 0, as a force that is neglected; False for a law."""
    return not is_law(x) and scalars.is_zero(scalar(x))


def comparable(what: str, *values: Scalar) -> tuple[Scalar, ...]:
    """The values, as :func:`~newton_euler.algebra.scalars.promote` returns them, of an exact
    solution of the body ``what`` that branches on them; :class:`ModelError` for expressions.
    """
    values = scalars.promote(*values)
    if not all(map(scalars.is_comparable, values)):
        raise ModelError(f"the exact solution of the {what} needs numbers; put values in first")
    return values


def has_unit(x: object) -> bool:
    """True for a quantity of pint or astropy, or a time of NumPy: a float would have no unit."""
    kind = getattr(getattr(x, "dtype", None), "kind", "")
    if kind and type(x).__module__ == "numpy":
        return kind in "mM"
    return hasattr(x, "unit") or (hasattr(x, "magnitude") and hasattr(x, "to"))


def unit_advice(x: object) -> str:
    """What to do with a quantity, as the end of a message; "" for anything else."""
    return advice(x) if has_unit(x) else ""


def finite_number(x: Any, what: str, no_number: str) -> float:
    """``x`` as a finite float; else :class:`ModelError`, whose message begins with ``what`` for inf
    and nan, and with ``no_number`` for anything else.
    """
    try:
        if not isinstance(x, (float, int)) and has_unit(x):
            raise TypeError
        x = float(x)
    except (TypeError, ValueError, OverflowError, RuntimeError) as error:  # the last of SymEngine
        raise ModelError(f"{no_number}{unit_advice(x)}") from error
    if not math.isfinite(x):
        raise ModelError(f"{what} {x!r}; a motion needs finite numbers")
    return x


def real_numbers(x: Any, what: str) -> "np.ndarray":
    """One real number, or an array or sequence of them, as an array of floats; :class:`ModelError`,
    which says ``what`` is expected, for anything else and for quantities, whose unit would be lost.
    """
    try:
        if has_unit(x) or hasattr(x, "mask"):
            raise TypeError
        if isinstance(x, (list, tuple)):
            if not set(map(type, x)) <= {float, int}:
                x = [real_numbers(entry, what) for entry in x]
        elif isinstance(x, range) and len(x) > LONGEST_SEQUENCE:
            raise TypeError
        given = np.asarray(x)
        if given.dtype.kind not in "iufO":
            raise TypeError
        if given.dtype.kind == "O":
            x = [real_numbers(entry, what) for entry in given] if given.ndim else float(x)
            return np.asarray(x, dtype=float)
        return np.asarray(given, dtype=float)
    except (TypeError, ValueError, OverflowError, RuntimeError) as error:
        if isinstance(error, ModelError):
            raise  # the error of an entry
        raise ModelError(f"{what}; got {clipped(x)}{unit_advice(x)}") from error


@guided
def second_order(
    name: str,
    parameters: Mapping[str, Scalar | Formula],
    coordinates: Sequence[str],
    accelerations: Formulas,
    **more: Any,
) -> Model:
    """The :class:`Model` whose states are coordinates and rates, for second-order equations.

    coordinates : their names; the rate of ``x`` is the state ``dx``
    accelerations : a function ``(s, p, t)`` that returns the second rates of the coordinates
    more : other arguments of :class:`Model`

    >>> acceleration = lambda s, p, t: (-p.k * s.x / p.m,)
    >>> spring = second_order("spring", {"m": 2.0, "k": 8.0}, ("x",), acceleration)
    >>> spring.states, spring.derivative((0.5, 1.0))
    (('x', 'dx'), (1.0, -2.0))
    """
    coordinates = _several("coordinates", coordinates)
    what = f"accelerations of {name!r} is a function (s, p, t)"
    expect(_is_function(accelerations), what, accelerations)
    rates = tuple(f"d{q}" for q in coordinates)
    rhs = StateVariables(rates, accelerations)
    return Model(name, parameters, (*coordinates, *rates), rhs, **more)


@dataclass(frozen=True)
class StateVariables(Portable):
    """The right-hand side of :func:`second_order`: the rates, and the accelerations."""

    rates: tuple[str, ...]
    accelerations: Formulas

    def __call__(self, s: Values, p: Values, t: Scalar) -> tuple[Scalar, ...]:
        return *(getattr(s, rate) for rate in self.rates), *self.accelerations(s, p, t)
