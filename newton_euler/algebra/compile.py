"""``compiled(f)`` runs a formula once on traced scalars and keeps its operations as straight-line
text, which is fast on every kind of number.

Every operation is a step (:mod:`newton_euler.algebra.trace`); equal steps are one, and steps that
no result needs are left out. The text is Python (:mod:`newton_euler.algebra.source`). It runs on
floats with ``math``, on arrays with NumPy in blocks that stay in the cache, or through heyoka, and
on the numbers of mpmath, on symbols and on this package's own kinds.
"""

import inspect
import math
import sys
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from functools import cached_property
from importlib import import_module, util
from itertools import takewhile
from operator import itemgetter
from types import ModuleType
from typing import Any, NamedTuple

from . import scalars
from .errors import checked
from .jets import Moving
from .places import GENERATED, callers_line, note_place, package_of
from .scalars import FUNCTIONS, Scalar, ScalarError, Scaled, _Own, _root, pi, scalar
from .source import WITHOUT_HEYOKA, generate, named_apart, runtime_names
from .trace import NO_VALUE, Inner, NoNumberError, Step, Trace, asked_by, keys_of, packed, unpacked

# instants at a time: the temporaries of a block stay in the processor's cache (1024 to 32768
# measured)
BLOCK = 8192
# the same for heyoka, whose inputs are copied together (measured: 4096 costs half as much again)
HEYOKA_BLOCK = 1 << 15
# instants (heyoka loaded: True, or not) from which on heyoka, with its compilation and import,
# takes less time in all than NumPy (measured)
HEYOKA_BREAK_EVEN = {True: 60_000, False: 1_500_000}
# packages whose functions may ask a traced value for its number
_LIBRARIES = {"numpy", "scipy", "mpmath", *sys.stdlib_module_names}


def _shape(result, leaves, keys):
    """The text that rebuilds a result from the tuple ``r`` of its scalars, the ``leaves``."""

    def several(parts):
        return f"({''.join(f'{_shape(part, leaves, keys)}, ' for part in parts)})"

    if hasattr(result, "tolist"):
        result = result.tolist()
    if isinstance(result, Moving):
        parts = several((result.value, result.rate, result.acceleration))
        return f"Moving(*map(scalar, {parts}))"
    if isinstance(result, dict):
        keys += result
        names = f"keys[{len(keys) - len(result)}:{len(keys)}]"
        return f"dict(zip({names}, {several(result.values())}))"
    if isinstance(result, (tuple, list, Scaled)):  # a Vector becomes the triple of its components
        return several(result)
    try:
        leaves.append(scalar(result))
    except ScalarError as error:
        raise ScalarError(
            "a compiled formula returns scalars, Vectors, or tuples and dicts of them, got "
            f"{result!r}"
        ) from error
    return f"r[{len(leaves) - 1}]"


def _builder(shape, keys, count):
    """The function of ``count`` scalars that builds the result described by :func:`_shape`."""
    if shape == "r[0]":
        return itemgetter(0)
    if shape == f"({''.join(f'r[{n}], ' for n in range(count))})":
        return tuple  # returns a tuple itself
    return eval(f"lambda r: {shape}", {"Moving": Moving, "scalar": scalar, "keys": keys})


class Recording(NamedTuple):
    """One formula that was traced, not yet written as text: the arguments of :class:`Compiled`."""

    name: str
    parameters: Any
    trace: Trace
    leaves: Any
    shape: str
    keys: Any
    defaults: dict


def content(formula: "Recording | Compiled") -> tuple:
    """Steps and result of a :class:`Recording` or :class:`Compiled`, without its name: a key that
    is equal for equal formulas, which give equal texts and equal results.
    """
    steps, leaves = keys_of(formula.trace), tuple(map(formula.trace.key, formula.leaves))
    return tuple(formula.parameters), steps, leaves, formula.shape, tuple(formula.keys)


def text_of(formula: "Recording | Compiled") -> "Compiled":
    """The :class:`Compiled` of a :class:`Recording`; one that is compiled as it is."""
    return formula if isinstance(formula, Compiled) else Compiled(*formula)


class Compiled:
    """A compiled formula, by :func:`compiled`; call it like the formula. ``source`` is its text,
    ``operations`` the number of its operations.

    trace, leaves : the steps, and those that are the scalars in the result
    shape, keys : how the result is built from these, see :func:`_shape`; default: a tuple
    """

    def __init__(
        self,
        name: str,
        parameters: Sequence[str],
        trace: Trace,
        leaves: Sequence[Scalar],
        shape: str = "",
        keys: Sequence[str] = (),
        defaults: Mapping[str, Scalar] | tuple[()] = (),
    ):
        self.name, self.parameters, self.trace, self.leaves = name, parameters, trace, leaves
        self._defaults, self.shape, self.keys = dict(defaults), shape, keys
        self._build = _builder(shape, keys, len(leaves)) if shape else tuple
        names = named_apart(parameters)
        self.source, self._constants, self.operations = generate(trace, names, leaves, lazy=False)
        chooses = any(s.op == "where" for s in trace.steps)
        self._lazy = generate(trace, names, leaves, lazy=True)[0] if chooses else self.source
        self._functions: dict[str, Callable[..., Any]] = {}
        self._heyoka, self._buffer = None, None
        self.seen = 0  # instants of arrays so far
        self.on_floats = self.on(math)

    def __repr__(self):
        return f"<compiled {self.name}({', '.join(self.parameters)}), {self.operations} operations>"

    def __reduce__(self):
        """Its steps: the text, and what was compiled from it, are made again from them."""
        steps, leaves = packed(self.trace, self.leaves)
        rest = self.shape, self.keys, self._defaults
        return _from_steps, (self.name, list(self.parameters), steps, leaves, *rest)

    def __call__(self, /, *args: Scalar, **named: Scalar) -> Any:
        if named or len(args) != len(self.parameters):
            args = self._in_order(args, named)
        for a in args:
            if type(a) is not float:
                return self._other(args)
        try:
            return self._build(self.on_floats(*args))
        except (ZeroDivisionError, OverflowError, ValueError) as error:
            self._refuse(args, error)

    @cached_property
    def dependencies(self) -> list[set[str]]:
        """For each scalar in the result the set of names of the arguments on which it depends."""
        known: list[set[str]] = []

        def union(values):
            return set().union(*(known[x.number] for x in values if isinstance(x, Step)))

        for s in self.trace.steps:
            known.append({s.args[0]} if s.op == "argument" else union(s.args))
        return [union([leaf]) for leaf in self.leaves]

    def on(self, library: ModuleType) -> Callable[..., tuple[Scalar, ...]]:
        """The text as a function over one library, from the arguments (over this package pi first)
        to the tuple of all scalars in the result.
        """
        name = library.__name__
        if name not in self._functions:
            names = (*FUNCTIONS, "atan2", "pi")
            space = {n: getattr(library, n) for n in names if hasattr(library, n)}
            space["__name__"] = GENERATED
            space.update(runtime_names(library))
            rounded = name in ("math", "numpy", "heyoka")
            space.update({n: _running(c, rounded) for n, c in self._constants.items()})
            # only on one number at a time can a branch be skipped
            text = self._lazy if name in ("math", "mpmath") else self.source
            if library is scalars:  # whose pi differs from call to call
                text = text.replace("(", "(pi, ", 1)
            exec(compile(text, f"<compiled {self.name}>", "exec"), space)
            self._functions[name] = space["formula"]
        return self._functions[name]

    def _refuse(self, args, error):
        """Raise the error of the engine for an arithmetic error, but one of the caller as it is."""
        if isinstance(error, scalars.NewtonEulerError) or note_place(error):
            raise error
        kinds = {ZeroDivisionError: scalars.DivisionError, OverflowError: scalars.RangeError}
        given = ", ".join(f"{n} = {x!r}" for n, x in zip(self.parameters, args, strict=True))
        kind = kinds.get(type(error), scalars.SingularError)
        raise kind(f"{self.name} has no value: {given}: {error}") from error

    def _in_order(self, args, named):
        first = dict(zip(self.parameters, args, strict=False))  # too few or too many: see wrong
        given = {**self._defaults, **first, **named}
        wrong = {
            "missing": [n for n in self.parameters if n not in given],
            "unknown": [n for n in named if n not in self.parameters],
            "given twice": [n for n in named if n in first],
            "left over": [repr(a) for a in args[len(self.parameters) :]],
        }
        if any(wrong.values()):
            lists = (f"; {what}: {', '.join(names)}" for what, names in wrong.items() if names)
            raise ScalarError(
                f"{self.name} takes {', '.join(self.parameters) or 'no arguments'}{''.join(lists)}"
            )
        return [given[n] for n in self.parameters]

    def _other(self, args):
        if all(isinstance(a, float) for a in args):  # np.float64, as in an array
            with suppress(ArithmeticError, ValueError):  # where NumPy has inf or nan
                return self._build(self.on_floats(*map(float, args)))
        for a in args:
            if getattr(a, "size", 1):  # an empty array has an empty array of values
                scalar(a)  # raises ScalarError if it is not a number
        # pi has the kind and the digits of the most exact number among them
        if any(isinstance(a, _Own) for a in args):
            values = [scalars.without_rates(a) for a in args]
            traced = [v for v in values if isinstance(v, Step)]
            others = [v for v in values if not isinstance(v, _Own) and _root(type(v)) != "builtins"]
            return self._build(self.on(scalars)(pi((traced or others or [0.0])[0]), *args))
        library = scalars.library_of(args)
        if library.__name__ == "numpy":
            return self._arrays(library, args)
        try:
            return self._build(self.on(library)(*args))
        except (ZeroDivisionError, OverflowError, ValueError) as error:
            self._refuse(args, error)

    def _arrays(self, np, args):
        args = [np.asarray(a) for a in args]
        if any(a.dtype.kind not in "biuf" for a in args):
            raise ScalarError(
                f"{self.name} takes arrays of real numbers, got "
                f"{', '.join(str(a.dtype) for a in args)}"
            )
        try:
            shape = np.broadcast_shapes(*(a.shape for a in args))
        except ValueError as error:
            shapes = ", ".join(f"{n} {a.shape}" for n, a in zip(self.parameters, args, strict=True))
            raise ScalarError(f"arrays have shapes that do not fit together: {shapes}") from error
        args = [a.astype(float, copy=False) for a in args]
        if not shape:
            return self._build(self.on(np)(*(a[()] for a in args)))
        count = math.prod(shape)
        self.seen += count
        rows = [np.broadcast_to(a, shape).reshape(-1) if a.shape else a[()] for a in args]
        out = np.empty((len(self.leaves), count))
        if count and self._heyoka_pays():
            self._by_heyoka(np, rows, out)
        else:
            run = self.on(np)
            for start in range(0, count, BLOCK):
                block = slice(start, start + BLOCK)
                values = run(*(r[block] if r.shape else r for r in rows))
                for row, value in zip(out, values, strict=True):
                    row[block] = value
        return self._build([row.reshape(shape) for row in out])

    def _heyoka_pays(self):
        if self.seen < HEYOKA_BREAK_EVEN["heyoka" in sys.modules]:
            return False
        if self._heyoka is None:
            without = any(s.op in WITHOUT_HEYOKA for s in self.trace.steps)
            if without or util.find_spec("heyoka") is None:
                self.seen = -math.inf
                return False
            hy = import_module("heyoka")
            variables = [hy.expression(n) for n in self.parameters]
            outputs = [
                hy.expression(float(o)) if isinstance(o, (int, float)) else o
                for o in self.on(hy)(*variables)
            ]
            self._heyoka = hy.cfunc(outputs, vars=variables)
        return True

    def _by_heyoka(self, np, rows, out):
        """Writes the results into ``out``, in blocks: new memory costs more than the arithmetic."""
        count = out.shape[1]
        size = min(count, HEYOKA_BLOCK)
        # a call in another thread meanwhile makes its own
        buffer, self._buffer = self._buffer, None
        if buffer is None or buffer[0].shape[1] != size:
            buffer = np.empty((len(rows), size)), np.empty((len(out), size))
        inputs, results = buffer
        for start in range(0, count, size):
            n = min(size, count - start)
            if n < size:
                inputs, results = np.empty((len(rows), n)), np.empty((len(out), n))
            np.concatenate(
                [r[start : start + n] if r.shape else np.broadcast_to(r, n) for r in rows],
                out=inputs.reshape(-1),
            )
            out[:, start : start + n] = self._heyoka(inputs, outputs=results)
        self._buffer = buffer


def _from_steps(name, parameters, steps, leaves, *rest):
    """The :class:`Compiled` formula that was pickled as these steps."""
    return Compiled(name, parameters, *unpacked(steps, leaves), *rest)


def _running(constant, rounded):
    """A constant as a text uses it: a formula compiled, a number as a float if all are."""
    if isinstance(constant, Inner):
        return Compiled("the formula inside", constant.parameters, constant.trace, constant.leaves)
    with suppress(TypeError):  # a symbol has no float
        return float(constant) if rounded else constant
    return constant


@checked
def compiled(f: Callable[..., Any], /, **constants: Scalar) -> Compiled:
    """The formula ``f``, traced once into straight-line text, for many fast evaluations. The result
    takes the same arguments (floats, arrays that broadcast, mpf, expressions), by place or by name,
    and returns what ``f`` returns, a Vector as a triple of components. Arrays are computed by NumPy
    in blocks, and by heyoka, if installed, as soon as that saves more time than its compilation
    takes.

    f : a function of scalars that does not branch on their values (it chooses by ``where``); it
        returns a scalar, a Vector, or tuples and dicts of them
    constants : parameters of ``f`` to fix now; they are not parameters of the result

    >>> from newton_euler import compiled, sin
    >>> height = compiled(lambda v, elevation, g: (v*sin(elevation))**2/(2*g))
    >>> round(height(20.0, 0.5, 9.81), 3), height.operations
    (4.686, 5)
    """
    return Compiled(*recorded(f, **constants))


def _lacked_values(error):
    """True if this error arose because a traced value has no number, whichever raised it: the value
    itself, the code that asked for its number, or a function of NumPy, SciPy or mpmath.
    """
    if isinstance(error, scalars.NewtonEulerError):
        return isinstance(error, NoNumberError)
    *_, last = _tracebacks(error)
    if asked_by(last.tb_frame, last.tb_lasti):
        return True
    # errors of s.real_part, np.sqrt([s, 1]), data[s]
    if any(map(_traced, (getattr(error.__cause__ or error, "obj", None), *error.args))):
        return True
    frames = [at.tb_frame for at in _tracebacks(error)]
    raised = takewhile(lambda frame: package_of(frame) in _LIBRARIES, reversed(frames))
    return any(_traced(x) for frame in raised for x in frame.f_locals.values())


def _tracebacks(error):
    at = error.__traceback__
    while at:
        yield at
        at = at.tb_next


def _traced(x):
    """True for traced values, also in lists and arrays."""
    x = x.ravel().tolist() if getattr(getattr(x, "dtype", None), "kind", "") == "O" else x
    return isinstance(x, Step) or (isinstance(x, (list, tuple)) and any(map(_traced, x)))


def recorded(f: Callable[..., Any], /, **constants: Scalar) -> Recording:
    """The :class:`Recording` of ``f``, see :func:`compiled`, without a text, in half the time."""
    try:
        signature = inspect.signature(f).parameters
    except (TypeError, ValueError) as error:  # max, for example
        raise ScalarError(f"a formula to compile names its arguments: {error}") from error
    if any(p.kind in (p.VAR_POSITIONAL, p.VAR_KEYWORD) for p in signature.values()):
        raise ScalarError(f"a formula to compile names all its arguments, but {f!r} does not")
    if unknown := [n for n in constants if n not in signature]:
        raise ScalarError(
            f"{f!r} has no argument {unknown[0]!r}; it takes {', '.join(signature) or 'none'}"
        )
    trace, parameters = Trace(), [n for n in signature if n not in constants]
    values = {**constants, **{n: trace.new("argument", n) for n in parameters}}
    by_place = [values.pop(n) for n, p in signature.items() if p.kind is p.POSITIONAL_ONLY]
    leaves: list[Scalar] = []
    keys: list[str] = []
    try:
        shape = _shape(f(*by_place, **values), leaves, keys)
    except (TypeError, ValueError, LookupError, AttributeError) as error:
        if not _lacked_values(error):
            raise
        line = callers_line(error)
        place = f"in {scalars.clipped(line)}: " if line else ""
        raise ScalarError(place + NO_VALUE) from error
    given = {n: signature[n].default for n in parameters}
    defaults = {n: x for n, x in given.items() if x is not inspect.Parameter.empty}
    name = getattr(f, "__name__", "formula")
    return Recording(name, parameters, trace, leaves, shape, keys, defaults)
