"""Checks of what is passed to the public functions, by their annotations, in words.

>>> @checked
... def weight(m: Scalar, g: Scalar = 9.81) -> Scalar:
...     return m * g
>>> weight("2")
Traceback (most recent call last):
    ...
newton_euler.algebra.scalars.ScalarError: weight: m is a number (float, array, mpf or expression); \
got '2' of type str; write numbers without quotation marks

Functions that are called millions of times, as the methods of vectors, have checks of their own.
"""

import types
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import wraps
from inspect import Parameter, signature
from typing import Annotated, Any, Literal, TypeVar, Union, get_args, get_origin

from . import scalars
from .names import ArgumentError, misfit
from .places import note_place
from .scalars import ZERO, NewtonEulerError, Scalar, ScalarError, _Own, clipped
from .vectors import FrameError, Vector

F = TypeVar("F", bound=Callable)
# the difference that two numbers may have; and the relative error of an integral
Tolerance = Annotated[float, "one real number that is not negative"]
Accuracy = Annotated[float, "a relative error that floats can reach, from 1e-14 to below 1"]


def checked(f: F, unchecked: tuple[str, ...] = ()) -> F:
    """The function ``f`` with its arguments checked by their annotations, except those named in
    ``unchecked``; of a class, its constructor.

    Scalars become what :func:`~newton_euler.algebra.scalars.scalar` makes of them. An error that
    Python or a library raises in the engine's own code, as for arrays that do not fit together, is
    raised with the arguments; what a function of the caller raises is left as it is, with a note
    of the place.
    """
    if isinstance(f, type):
        f.__init__ = checked(f.__init__, unchecked)  # type: ignore[misc]
        return f
    plan: Any = None

    @wraps(f)
    def call(*args, **named):
        nonlocal plan
        if plan is None:  # read at the first call, when all names in annotations exist
            plan = _plan(f, unchecked)
        by_name, by_position, several = plan
        given = [check(x) if check else x for check, x in zip(by_position, args, strict=False)]
        if len(args) > len(given):
            rest = args[len(given) :]
            given += [several(x) for x in rest] if several else rest
        if named:
            others = by_name.get("**")
            for name, x in named.items():
                if check := by_name.get(name, others):
                    named[name] = check(x, name)
        try:
            return f(*given, **named)
        except Exception as error:
            if isinstance(error, TypeError) and (words := misfit(f, args, named)):
                raise ArgumentError(words) from None
            engines = isinstance(error, (ArithmeticError, ValueError, TypeError, LookupError))
            if note_place(error) or isinstance(error, NewtonEulerError) or not engines:
                raise
            given = [*map(_brief, given), *(f"{n}={_brief(x)}" for n, x in named.items())]
            raise _in_words(f"{f.__name__}({', '.join(given)})", error) from error

    return call  # type: ignore[return-value]


def checked_words(cls: type) -> type:
    """A class decorator: :func:`checked` for texts, choices and bools of the public methods."""
    for name, f in list(vars(cls).items()):
        if isinstance(f, types.FunctionType) and not name.startswith("_"):
            kinds = f.__annotations__.items()
            rest = [n for n, k in kinds if k not in (str, bool) and get_origin(k) is not Literal]
            setattr(cls, name, checked(f, tuple(rest)))
    return cls


def checked_but(*unchecked: str) -> Callable[[F], F]:
    """:func:`checked` as a decorator that leaves these arguments to the function."""
    return lambda f: checked(f, unchecked)


def _in_words(called, error):
    """The error of the engine for one of Python or a library."""
    if isinstance(error, ZeroDivisionError):
        return scalars.DivisionError(f"{called} has no value: {error}")
    if isinstance(error, OverflowError):
        return scalars.RangeError(f"{called} has no value: {error}")
    return ArgumentError(f"{called} cannot be computed with these arguments: {error}")


def _brief(x):
    """The name of a function, or the text of a value."""
    return getattr(x, "__name__", None) or clipped(x)


# -- the check of each parameter


def _plan(f, unchecked):
    """(checks by name, by position, of what a * gathers); what ** gathers has the name "**"."""
    where = f.__qualname__[:-9] if f.__name__ == "__init__" else f.__name__
    by_name, by_position, several = {}, [], None
    for p in signature(f).parameters.values():
        check = None if p.name in unchecked else _check_of(p, f, where)
        if p.kind is Parameter.VAR_POSITIONAL:
            several = check
            continue
        if p.kind in (Parameter.POSITIONAL_ONLY, Parameter.POSITIONAL_OR_KEYWORD):
            by_position.append(check)
        if p.kind is not Parameter.POSITIONAL_ONLY:
            by_name["**" if p.kind is Parameter.VAR_KEYWORD else p.name] = check
    return by_name, by_position, several


def _check_of(p, f, where):
    """The check of one parameter: from the argument to the value to pass on, or None."""
    kind = f.__annotations__.get(p.name)
    if isinstance(kind, str):
        kind = eval(kind, f.__globals__)
    if (convert := _converter(kind)) is None:
        return None
    error, none_is_fine = _error_for(_members(kind)), p.default is None

    def check(x, name=p.name):
        if x is None and none_is_fine:
            return x
        y = convert(x)
        if y is REFUSED:
            raise error(
                f"{where}: {name} is {annotation_in_words(kind)}; got {clipped(x)} of type "
                f"{type(x).__name__}{scalars.advice(x) if error is ScalarError else ''}"
            )
        return y

    if convert is not _number:
        return check
    # the usual case, by the shortest way
    return lambda x, name=p.name: x if type(x) is float or isinstance(x, _Own) else check(x, name)


def _error_for(members):
    """The error for an argument of another kind than these."""
    if {Scalar, float, Tolerance, Accuracy}.intersection(members):
        return ScalarError
    of_frames = {getattr(k, "__name__", "") for k in members} & {"Frame", "Point", "Vector"}
    return FrameError if of_frames else ArgumentError


def _members(kind):
    """The kinds of which a union is made, or the one."""
    if get_origin(kind) in (Union, types.UnionType):
        return get_args(kind)
    return (kind,)


# -- conversions: functions of a value that return the value to pass on, or REFUSED

REFUSED = object()


def _converter(kind):
    """The conversion to what an annotation asks for; None if everything fits."""
    members = _members(kind)
    names = {getattr(k, "__name__", "") for k in members}
    if {"Point", "Frame"} <= names <= {"Point", "Frame", "NoneType"}:
        return None  # place() asks which of them it is, in words of its own
    if len(members) > 1:
        converters = [_converter(k) for k in members]
        if None in converters:
            return None
        return lambda x: next((y for c in converters if (y := c(x)) is not REFUSED), REFUSED)
    if kind in _OF_KIND:
        return _OF_KIND[kind]
    container, parts = get_origin(kind) or kind, get_args(kind)
    if container is Literal:
        return lambda x: x if isinstance(x, str) and x in parts else REFUSED
    if container is tuple:
        parts = parts[:1] if len(parts) == 2 and parts[1] is ... else ()
    if container in (Sequence, tuple, Iterable):
        fits = _is_iterable if container is Iterable else _is_sequence
        return _each(fits, _converter(parts[0]) if parts else None)
    if container is Callable:
        return lambda x: x if callable(x) and not isinstance(x, type) else REFUSED
    if isinstance(container, type) and container not in (object, Any):
        return lambda x: x if isinstance(x, container) else REFUSED
    return None


def _number(x):
    try:
        y = scalars.real_scalar(x)
    except ScalarError:
        return REFUSED
    return x if x is ZERO else scalars.to_plain(y)


def _real(x):
    if type(x) is float:
        return x
    y = _number(x)
    if y is REFUSED or (isinstance(y, _Own) and y is not ZERO):
        return REFUSED
    return y if scalars.is_numeric(y) and not getattr(y, "shape", ()) else REFUSED


def _whole(x):
    y = _real(x)
    return int(y) if y is not REFUSED and abs(y) < 2**53 and y == int(y) else REFUSED


def _true_or_false(x):
    of_numpy = getattr(getattr(x, "dtype", None), "kind", "") == "b" and not x.shape
    return bool(x) if of_numpy or type(x) is bool else REFUSED


def _tolerance(x):
    try:
        return scalars.allowed(x)
    except ScalarError:
        return REFUSED


def _accuracy(x):
    y = _real(x)
    return y if y is not REFUSED and 1e-14 <= y < 1 else REFUSED


_OF_KIND = {Scalar: _number, float: _real, int: _whole, bool: _true_or_false}
_OF_KIND |= {Tolerance: _tolerance, Accuracy: _accuracy}

LONGEST_SEQUENCE = 10**7  # entries: the most that are iterated over


def _is_iterable(x):
    iterable = hasattr(x, "__iter__") and not isinstance(x, (str, bytes))
    return iterable and 0 <= _length(x) <= LONGEST_SEQUENCE


def _is_sequence(x):
    unordered = isinstance(x, (Mapping, set, frozenset))
    return _is_iterable(x) and hasattr(x, "__getitem__") and not unordered


def _each(fits, convert):
    """The conversion of a container that ``fits``, with each entry converted."""

    def of_container(x):
        if not fits(x):
            return REFUSED
        if hasattr(x, "dtype") and convert:
            x = _number(x)  # an array of anything else is refused
        if convert is None or x is REFUSED or not hasattr(x, "__len__"):
            return x
        if convert is _number and hasattr(x, "dtype"):
            return x
        entries = [convert(entry) for entry in x]
        if any(entry is REFUSED for entry in entries):
            return REFUSED
        same = hasattr(x, "dtype") or all(a is b for a, b in zip(entries, x, strict=True))
        return x if same else tuple(entries)

    return of_container


def _length(x):
    """The length; 0 if it is not known; infinite if it has none, as an array without an axis."""
    try:
        return len(x) if hasattr(x, "__len__") else 0
    except (TypeError, OverflowError):
        return float("inf")


# what to write, for kinds by the name of their class
_EXAMPLES = {
    "Frame": "a Frame, as Frame('ground') or ground.rotate('arm', 'z')",
    "Point": "a Point, as ground.point('P', 1.0, 0, 0)",
    "Vector": "a Vector, as ground.vector(1.0, 0, 0)",
    "Body": "a Body, as disk(0.5, frame, mass=2.0)",
    "CoordinatePoint": "a point in coordinates, as polar(ground, 'P', r, theta)",
    "Amount": "an Amount",
    "Scalar": "a number (float, array, mpf or expression)",
    "float": "one real number",
    "int": "a whole number",
    "str": "a text",
    "bool": "True or False",
    "Callable": "a function",
    "NoneType": "None",
}


def annotation_in_words(kind: Any) -> str:
    """What an annotation asks for, in words."""
    members = _members(kind)
    if len(members) > 1:
        return " or ".join(dict.fromkeys(annotation_in_words(k) for k in members))
    if kind in (Tolerance, Accuracy):
        return kind.__metadata__[0]
    container, parts = get_origin(kind) or kind, get_args(kind)
    if container is Literal:
        return f"one of {', '.join(map(repr, parts))}"
    if container in (Sequence, Iterable, tuple):
        inner = {Scalar: " of numbers", Vector: " of Vectors"}
        if parts and parts[0] not in inner and _converter(parts[0]):
            return f"a sequence, each {annotation_in_words(parts[0])}"
        return "a sequence" + (inner.get(parts[0], "") if parts else "")
    name = getattr(container, "__name__", str(container))
    return _EXAMPLES.get(name, f"a {name}")
