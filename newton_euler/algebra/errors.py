"""Errors in words: checks of what is passed to the public functions, by their annotations.

>>> @checked
... def weight(m: Scalar, g: Scalar = 9.81) -> Scalar:
...     return m * g
>>> weight("2")
Traceback (most recent call last):
    ...
newton_euler.algebra.scalars.ScalarError: weight: m is a number (float, array, mpf or expression); \
got '2' of type str; write numbers without quotation marks

What enters as an array of whole numbers goes on as one of floats, see
:func:`~newton_euler.algebra.scalars.scalar`. Functions that are called millions of times, as the
methods of vectors, frames and scalars, have checks of their own.
"""

import types
import typing
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import wraps
from typing import Any, TypeVar

from .scalars import (
    ZERO,
    DivisionError,
    NewtonEulerError,
    RangeError,
    Scalar,
    ScalarError,
    _Own,
    advice,
    clipped,
    is_numeric,
    scalar,
    to_plain,
)
from .vectors import FrameError, Vector


class ArgumentError(NewtonEulerError, TypeError):
    """An argument is not of the kind that is expected: a number where a function belongs."""


F = TypeVar("F", bound=Callable)

# what to write, for kinds of the mechanics by the name of their class
_EXAMPLES = {
    "Frame": "a Frame, as Frame('ground') or ground.rotate('arm', 'z')",
    "Point": "a Point, as ground.point('P', 1.0, 0, 0)",
    "Vector": "a Vector, as ground.vector(1.0, 0, 0)",
    "Body": "a Body, as disk(0.5, frame, mass=2.0)",
    "CoordinatePoint": "a point in coordinates, as polar(ground, 'P', r, theta)",
    "Amount": "an Amount",
    "str": "a text",
    "bool": "True or False",
    "int": "a whole number",
}


def checked(f: F, leave: tuple = ()) -> F:
    """The function ``f`` with its arguments checked by their annotations; of a class, its
    constructor.

    leave : the names of arguments that the function checks itself, in words of its own

    Scalars become what :func:`~newton_euler.algebra.scalars.scalar` makes of them; a division by
    zero, an overflow and arrays that do not fit together are told with the arguments.
    """
    if isinstance(f, type):
        f.__init__ = checked(f.__init__, leave)  # type: ignore[misc]
        return f
    plan: Any = None

    @wraps(f)
    def door(*args, **named):
        nonlocal plan
        if plan is None:  # read at the first call, when all names in annotations exist
            plan = _plan(f, leave)
        checks, order, several = plan
        given = [check(x) if check else x for check, x in zip(order, args, strict=False)]
        if len(args) > len(given):
            rest = args[len(given) :]
            given += [several(x) for x in rest] if several else rest
        if named:
            rest = checks.get("**")
            for name, x in named.items():
                check = checks.get(name, rest)
                if check:
                    named[name] = check(x, name)
        try:
            return f(*given, **named)
        except (ArithmeticError, ValueError, TypeError, LookupError) as error:
            told = _told(error)
            if told is None:
                raise
            given = [*map(clipped, given), *(f"{n}={clipped(x)}" for n, x in named.items())]
            raise told[0](f"{f.__name__}({', '.join(given)}) {told[1]}: {error}") from error

    return door  # type: ignore[return-value]


# What arithmetic itself raises with numbers, shapes and functions that do not fit: a part of its
# message, the error in words, and what is to be said. All other errors are bugs, and stay.
_NO_VALUE, _LENGTHS = "has no value", "has arguments whose lengths do not fit"
_RESULT = "has an argument, or a function that returns something, of a form that does not fit"
_TOLD = (
    ("broadcast", ScalarError, _LENGTHS),
    ("values to unpack", ArgumentError, _LENGTHS),
    ("zip() argument", ArgumentError, _LENGTHS),
    ("index out of range", ArgumentError, _LENGTHS),
    ("Relational", ScalarError, "needs numbers that can be compared"),
    ("between instances of", ScalarError, "needs numbers that can be compared"),
    ("out of bounds", ArgumentError, _LENGTHS),
    ("real number, not", ScalarError, "needs plain numbers"),
    ("convert expression", ScalarError, "needs numbers in place of symbols"),
    ("multiply sequence", ScalarError, "has numbers of kinds that do not go together"),
    ("operand type", ScalarError, "has numbers of kinds that do not go together"),
    ("positional argument", ArgumentError, "calls a function with other arguments than it has"),
    ("is not iterable", ArgumentError, _RESULT),
    ("cannot unpack", ArgumentError, _RESULT),
    ("not subscriptable", ArgumentError, _RESULT),
)


def _told(error):
    """(kind, sentence) of the error in words for an error of arithmetic; None for another."""
    if type(error).__module__.startswith("newton_euler"):
        return None
    if isinstance(error, ZeroDivisionError):
        return DivisionError, _NO_VALUE
    if isinstance(error, OverflowError):
        return RangeError, _NO_VALUE
    text = str(error)
    return next(((kind, said) for part, kind, said in _TOLD if part in text), None)


def _plan(f, leave):
    """(checks by name, a list of them by position, that of what a * gathers); what ** gathers has
    the name "**".
    """
    code, where = f.__code__, f.__name__ if f.__name__ != "__init__" else f.__qualname__[:-9]
    names, count = code.co_varnames, code.co_argcount
    defaults = dict(zip(reversed(names[:count]), reversed(f.__defaults__ or ()), strict=False))
    defaults |= f.__kwdefaults__ or {}

    def of(name):
        none = name in defaults and defaults[name] is None
        return None if name in leave else _check_of(f, where, name, none)

    rest = count + code.co_kwonlyargcount
    checks = {name: of(name) for name in names[:rest]}
    order = [checks[name] for name in names[:count]]
    several = of(names[rest]) if code.co_flags & 4 else None
    checks["**"] = of(names[rest + bool(code.co_flags & 4)]) if code.co_flags & 8 else None
    return checks, order, several


def _check_of(f, where, name, may_be_none):
    """The check of one parameter: a function of what is passed, that returns what goes on."""
    kind = f.__annotations__.get(name)
    if isinstance(kind, str):
        kind = eval(kind, f.__globals__)
    take = _taker(kind)
    if take is None:
        return None

    members = _members(kind)
    error = ArgumentError
    if Scalar in members or float in members:
        error = ScalarError
    elif {getattr(k, "__name__", "") for k in members} & {"Frame", "Point", "Vector"}:
        error = FrameError

    def check(x, name=name):
        if x is None and may_be_none:
            return x
        y = take(x)
        if y is NOT_TAKEN:
            raise error(
                f"{where}: {name} is {words(kind)}; got {clipped(x)} of type {type(x).__name__}"
                f"{advice(x) if error is ScalarError else ''}"
            )
        return y

    if take is _number:  # the usual case, by the shortest way

        def check_number(x, name=name):
            return x if type(x) is float or isinstance(x, _Own) else check(x, name)

        return check_number
    return check


NOT_TAKEN = object()


def _members(kind):
    """The kinds of which a union is made, or the one."""
    if typing.get_origin(kind) in (typing.Union, types.UnionType):
        return typing.get_args(kind)
    return (kind,)


def _taker(kind):
    """A function of a value that returns what goes on, or NOT_TAKEN; None where all is taken."""
    members = _members(kind)
    names = {getattr(k, "__name__", "") for k in members}
    if {"Point", "Frame"} <= names <= {"Point", "Frame", "NoneType"}:
        return None  # place() asks which of them it is, in words of its own
    if len(members) > 1:
        takers = [_taker(k) for k in members if k is not types.NoneType]
        if None in takers:
            return None
        none = types.NoneType in members

        def one_of(x):
            if none and x is None:
                return x
            return next((y for take in takers if (y := take(x)) is not NOT_TAKEN), NOT_TAKEN)

        return one_of
    if kind is Scalar:
        return _number
    if kind is float:
        return _real
    if kind is int:
        return _whole
    if kind is bool:
        return _yes_or_no
    container, parts = typing.get_origin(kind) or kind, typing.get_args(kind)
    if container is Sequence:
        return _sequence_of(_taker(parts[0]) if parts else None)
    if container is tuple:
        return _sequence_of(_taker(parts[0]) if len(parts) == 2 and parts[1] is ... else None)
    if container is Iterable:
        return _iterable_of(_taker(parts[0]) if parts else None)
    if container is Callable:
        return lambda x: x if callable(x) and not isinstance(x, type) else NOT_TAKEN
    if isinstance(container, type) and container not in (object, Any):
        return lambda x: x if isinstance(x, container) else NOT_TAKEN
    return None


def _number(x):
    try:
        y = scalar(x)
    except ScalarError:
        return NOT_TAKEN
    return x if x is ZERO else to_plain(y)


def _real(x):
    if type(x) is float:
        return x
    y = _number(x)
    if isinstance(y, _Own) and y is not ZERO:
        return NOT_TAKEN
    if y is NOT_TAKEN or not is_numeric(y) or getattr(y, "shape", ()) or isinstance(y, complex):
        return NOT_TAKEN
    return y


def _whole(x):
    y = _real(x)
    return int(y) if y is not NOT_TAKEN and abs(y) < 2**53 and y == int(y) else NOT_TAKEN


def _yes_or_no(x):
    return bool(x) if type(x).__name__ in ("bool", "bool_") else NOT_TAKEN


def checked_but(*leave: str) -> Callable[[F], F]:
    """:func:`checked` as a decorator that leaves these arguments to the function."""
    return lambda f: checked(f, leave)


def _text(x):
    return isinstance(x, (str, bytes))


LONGEST_SEQUENCE = 10**7  # of what is meant to be gone through


def _sequence_of(take):
    """A taker of sequences, each entry by ``take``."""

    def sequence(x):
        if _text(x) or isinstance(x, (Mapping, set, frozenset)) or not hasattr(x, "__getitem__"):
            return NOT_TAKEN
        if not hasattr(x, "__iter__") or _length(x) > LONGEST_SEQUENCE:
            return NOT_TAKEN
        if hasattr(x, "dtype") and take:
            x = _number(x)  # of an array of other things: NOT_TAKEN
        if x is NOT_TAKEN or take is None or (take is _number and hasattr(x, "dtype")):
            return x
        return _each(take, x)

    return sequence


def _iterable_of(take):
    """A taker of what can be gone through; a list or tuple with each entry by ``take``."""

    def iterable(x):
        if _text(x) or not hasattr(x, "__iter__") or not 0 <= _length(x) <= LONGEST_SEQUENCE:
            return NOT_TAKEN
        return _each(take, x) if take and hasattr(x, "__len__") else x

    return iterable


def _each(take, x):
    """The sequence ``x`` with each entry as ``take`` leaves it."""
    entries = [take(entry) for entry in x]
    if any(entry is NOT_TAKEN for entry in entries):
        return NOT_TAKEN
    if hasattr(x, "dtype") or all(a is b for a, b in zip(entries, x, strict=True)):
        return x
    return tuple(entries)


def _length(x):
    """The length; 0 where it is not known; infinite of what has none, as an array of no axis."""
    try:
        return len(x) if hasattr(x, "__len__") else 0
    except (TypeError, OverflowError):
        return float("inf")


def words(kind):
    """What an annotation asks for, in words."""
    members = _members(kind)
    if len(members) > 1:
        return " or ".join(dict.fromkeys(words(k) for k in members))
    if kind is Scalar:
        return "a number (float, array, mpf or expression)"
    if kind is types.NoneType:
        return "None"
    container, parts = typing.get_origin(kind) or kind, typing.get_args(kind)
    if container is float:
        return "one real number"
    if container in (Sequence, Iterable, tuple):
        inner = {Scalar: " of numbers", Vector: " of Vectors"}
        return "a sequence" + (inner.get(parts[0], "") if parts else "")
    if container is Callable:
        return "a function"
    name = getattr(container, "__name__", str(container))
    return _EXAMPLES.get(name, f"a {name}")
