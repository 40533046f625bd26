"""Run a formula once and keep what it did: straight-line text that then runs fast on every kind of number.

``compiled(f)`` calls ``f`` with traced scalars. Every operation becomes a step; equal steps are one step, so common subexpressions
are shared, and steps that no result needs are dropped. The text of the steps is Python, and it is run on floats with ``math``,
on arrays with NumPy in blocks that stay in the cache, or through heyoka, on mpmath and on symbols.
"""

import importlib
import importlib.util
import inspect
import math
import sys

from .jets import Moving
from .scalars import FUNCTIONS, ScalarError, Scaled, _Own, _root, library_of, pi, scalar, without_rates
from .steps import NO_VALUE, Step, Trace
from .straight_line import COMPARISONS, choices, written

BLOCK = 8192  # instants at a time: the temporaries of a block stay in the processor's cache (1024 to 32768 measured)
HEYOKA_BLOCK = 1 << 15  # the same for heyoka, whose inputs are copied together (measured: 4096 costs half as much again)
HEYOKA_BREAK_EVEN = {True: 60_000, False: 1_500_000}  # instants until its compilation (and, if not yet loaded, import) is earned back


def _leaves(result):
    """The scalars in a result, and a function that puts others in their places. Vectors become triples."""
    if hasattr(result, "tolist"):
        result = result.tolist()
    if isinstance(result, Moving):
        parts = result.value, result.rate, result.acceleration
        return _joined([_leaves(part) for part in parts], lambda values: Moving(*map(scalar, values)))
    if isinstance(result, dict):
        parts = [_leaves(v) for v in result.values()]
        keys = list(result)
        return _joined(parts, lambda values: dict(zip(keys, values, strict=True)))
    if isinstance(result, (tuple, list, Scaled)):
        return _joined([_leaves(v) for v in result], tuple)
    try:
        return [scalar(result)], _only
    except ScalarError as error:
        raise ScalarError(f"a compiled formula returns scalars, Vectors, or tuples and dicts of them, got {result!r}") from error


def _only(values):
    return values[0]


def _joined(parts, build):
    if build is tuple and all(make is _only for _, make in parts):
        return [x for leaves, _ in parts for x in leaves], tuple  # a vector, or a plain tuple: nothing to build
    counts = [len(leaves) for leaves, _ in parts]

    def rebuild(values):
        at, out = 0, []
        for (_, make), n in zip(parts, counts, strict=True):
            out.append(make(values[at : at + n]))
            at += n
        return build(out)

    return [x for leaves, _ in parts for x in leaves], rebuild


class Compiled:
    """What :func:`compiled` returns; call it like the formula. ``source`` is its text, ``operations`` how many it takes."""

    def __init__(self, f, constants, backend):
        signature = inspect.signature(f).parameters
        if any(p.kind in (p.VAR_POSITIONAL, p.VAR_KEYWORD) for p in signature.values()):
            raise TypeError(f"a formula to compile names all its arguments; {f!r} takes any number of them")
        parameters = [n for n in signature if n not in constants]
        names = {n: f"{n}_" if n in (*FUNCTIONS, *COMPARISONS, "atan2", "pi", "pow", "abs", "where") else n for n in parameters}
        trace = Trace()
        values = {**constants, **{n: trace.new("argument", n) for n in parameters}}
        by_place = [values.pop(n) for n, p in signature.items() if p.kind is p.POSITIONAL_ONLY]
        try:
            leaves, self._rebuild = _leaves(f(*by_place, **values))
        except TypeError as error:
            if "ufunc" not in str(error):
                raise
            raise TypeError(NO_VALUE) from error  # a function of NumPy, which has only words of its own for a number that it does not know
        self.parameters, self.backend, self.name = parameters, backend, getattr(f, "__name__", "formula")
        self._defaults = {n: signature[n].default for n in parameters if signature[n].default is not inspect.Parameter.empty}
        self.source, self._constants, self.operations, self._results = written(trace, names, leaves, lazy=False)
        chooses = any(s.op == "where" for s in trace.steps)
        self._lazy = written(trace, names, leaves, lazy=True)[0] if chooses else self.source
        self._run, self._seen, self._heyoka, self._buffer = {}, 0, None, None
        self._run["math"] = self._on(math)

    def __repr__(self):
        return f"<compiled {self.name}({', '.join(self.parameters)}), {self.operations} operations>"

    def __call__(self, *args, **named):
        if named or len(args) != len(self.parameters):
            args = self._in_order(args, named)
        for a in args:
            if type(a) is not float:
                return self._other(args)
        return self._rebuild(self._run["math"](*args))

    def _in_order(self, args, named):
        first = dict(zip(self.parameters, args, strict=False))  # too few or too many: told below
        given = {**self._defaults, **first, **named}
        troubles = {
            "missing": [n for n in self.parameters if n not in given],
            "unknown": [n for n in named if n not in self.parameters],
            "given twice": [n for n in named if n in first],
            "left over": [repr(a) for a in args[len(self.parameters) :]],
        }
        if any(troubles.values()):
            told = "; ".join(f"{trouble}: {', '.join(names)}" for trouble, names in troubles.items() if names)
            raise TypeError(f"{self.name} takes {', '.join(self.parameters) or 'no arguments'}; {told}")
        return [given[n] for n in self.parameters]

    def _other(self, args):
        for a in args:
            scalar(a)  # or it is no number, and the error says so
        if any(isinstance(a, _Own) for a in args):
            return self._own(args)
        library = library_of(args)
        if library.__name__ == "numpy":
            return self._arrays(library, args)
        if library.__name__ not in self._run:
            self._run[library.__name__] = self._on(library)
        return self._rebuild(self._run[library.__name__](*args))

    def _own(self, args):
        """The value on the kinds of number defined in this package; pi has the kind and the digits of the most exact number among them."""
        run = self._run.get("own") or self._run.setdefault("own", self._on(sys.modules[_Own.__module__], "pi, "))
        values = [without_rates(a) for a in args]
        traced = [v for v in values if isinstance(v, Step)]
        others = [v for v in values if not isinstance(v, _Own) and _root(type(v)) != "builtins"]
        return self._rebuild(run(pi((traced or others or [0.0])[0]), *args))

    def _on(self, library, first=""):
        """The text as a function over one library; ``first`` is an argument before the others, for what differs from call to call."""
        space = {name: getattr(library, name) for name in (*FUNCTIONS, "atan2", "pi") if hasattr(library, name)}
        rounded = library.__name__ in ("math", "numpy", "heyoka")
        space.update(choices(library))
        space.update({name: _float(c) if rounded else c for name, c in self._constants.items()})
        text = self._lazy if library.__name__ in ("math", "mpmath") else self.source  # these take one number at a time
        exec(compile(text.replace("(", f"({first}", 1), f"<compiled {self.name}>", "exec"), space)
        return space["formula"]

    def _arrays(self, np, args):
        args = [np.asarray(a) for a in args]
        if any(a.dtype.kind not in "biuf" for a in args):
            raise ScalarError(f"{self.name} takes arrays of real numbers, got {', '.join(str(a.dtype) for a in args)}")
        try:
            shape = np.broadcast_shapes(*(a.shape for a in args))
        except ValueError as error:
            shapes = ", ".join(f"{n} {a.shape}" for n, a in zip(self.parameters, args, strict=True))
            raise ScalarError(f"the arrays have shapes that do not fit together: {shapes}") from error
        args = [a.astype(float, copy=False) for a in args]
        if not shape:
            return self._rebuild(self._numpy(np)(*(a[()] for a in args)))
        count = math.prod(shape)
        self._seen += count
        rows = [np.broadcast_to(a, shape).reshape(-1) if a.shape else a[()] for a in args]
        out = self._by_heyoka(np, rows, count) if count and self._heyoka_pays() else self._in_blocks(np, rows, count)
        return self._rebuild([r.reshape(shape) for r in out])

    def _numpy(self, np):
        return self._run.get("numpy") or self._run.setdefault("numpy", self._on(np))

    def _in_blocks(self, np, rows, count):
        run = self._numpy(np)
        out = np.empty((len(self._results), count))
        for start in range(0, count, BLOCK):
            block = slice(start, start + BLOCK)
            for row, value in zip(out, run(*(r[block] if r.shape else r for r in rows)), strict=True):
                row[block] = value
        return out

    def _heyoka_pays(self):
        if self.backend == "numpy":
            return False
        if self._heyoka is None:
            if self.backend == "auto" and self._seen < HEYOKA_BREAK_EVEN["heyoka" in sys.modules]:
                return False
            if importlib.util.find_spec("heyoka") is None:
                if self.backend == "heyoka":
                    raise ImportError("backend='heyoka' needs heyoka: pip install 'newton-euler[fast]', or use backend='auto'")
                self.backend = "numpy"
                return False
            self._heyoka = self._compile_heyoka()
        return True

    def _compile_heyoka(self):
        hy = importlib.import_module("heyoka")
        variables = [hy.expression(n) for n in self.parameters]
        outputs = [hy.expression(float(o)) if isinstance(o, (int, float)) else o for o in self._on(hy)(*variables)]
        return hy.cfunc(outputs, vars=variables)

    def _by_heyoka(self, np, rows, count):
        """Block by block through a buffer that is kept between calls: fresh memory of this size costs more than the arithmetic."""
        size = min(count, HEYOKA_BLOCK)
        buffer, self._buffer = self._buffer, None  # a call in another thread meanwhile makes its own
        if buffer is None or buffer[0].shape[1] != size:
            buffer = np.empty((len(rows), size)), np.empty((len(self._results), size))
        inputs, results = buffer
        out = np.empty((len(self._results), count))
        for start in range(0, count, size):
            n = min(size, count - start)
            if n < size:
                inputs, results = np.empty((len(rows), n)), np.empty((len(self._results), n))
            np.concatenate([r[start : start + n] if r.shape else np.broadcast_to(r, n) for r in rows], out=inputs.reshape(-1))
            out[:, start : start + n] = self._heyoka(inputs, outputs=results)
        self._buffer = buffer
        return out


def _float(constant):
    try:
        return float(constant)
    except TypeError:  # a symbol
        return constant


def compiled(f, backend="auto", **constants):
    """``f``, traced once into straight-line text, for many fast evaluations.

    f : a function of scalars, without branches on their values (it chooses by ``where``); it returns a scalar, a Vector, or tuples and dicts of them
    backend : "auto" (NumPy in blocks, and heyoka as soon as its compile time is earned back), "numpy" or "heyoka"; for arrays only
    constants : parameters of ``f`` to fix now; they are not parameters of the result

    The result takes the same arguments (floats, arrays that broadcast, mpf, expressions), by place or by name, and returns what ``f``
    returns, a Vector as a triple of components. **Batches:** an array argument of shape (N,) is N instants; each component of the
    result has shape (N,).

    >>> from newton_euler import compiled, sin
    >>> height = compiled(lambda v, elevation, g: (v*sin(elevation))**2/(2*g))
    >>> round(height(20.0, 0.5, 9.81), 3)
    4.686
    >>> height.operations
    5
    """
    if backend not in ("auto", "numpy", "heyoka"):
        raise ValueError(f"backend must be 'auto', 'numpy' or 'heyoka', got {backend!r}")
    return Compiled(f, constants, backend)
