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

from .scalars import FUNCTIONS, ZERO, Moving, _library, _Own

BLOCK = 2048  # instants at a time: the temporaries of a block stay in the processor's cache (measured: 3 times faster)
HEYOKA_PAYS = {True: 60_000, False: 1_500_000}  # instants until its compilation (and, if not yet loaded, import) is earned back


class Step(_Own):
    """One traced scalar: an operation on earlier steps, numbers or the arguments."""

    __slots__ = ("trace", "op", "args", "number")
    rank = 3

    def __init__(self, trace, op, args, number):
        self.trace, self.op, self.args, self.number = trace, op, args, number

    def __add__(self, other):
        return self if _is(other, 0) else self.trace.step("+", self, other)

    def __radd__(self, other):
        return self if _is(other, 0) else self.trace.step("+", other, self)

    def __sub__(self, other):
        return self if _is(other, 0) else self.trace.step("-", self, other)

    def __rsub__(self, other):
        return -self if _is(other, 0) else self.trace.step("-", other, self)

    def __mul__(self, other):
        if other is ZERO:
            return ZERO
        if _is(other, 1) or _is(other, -1):
            return self if other == 1 else -self
        return self.trace.step("*", self, other)

    __rmul__ = __mul__

    def __truediv__(self, other):
        return self if _is(other, 1) else self.trace.step("/", self, other)

    def __rtruediv__(self, other):
        return self.trace.step("/", other, self)

    def __pow__(self, power):
        if power == 2:
            return self * self
        return self if _is(power, 1) else self.trace.step("**", self, power)

    def __neg__(self):
        return self.args[0] if self.op == "neg" else self.trace.step("neg", self)

    def function(self, name, *args):
        return self.trace.step(name, *(args or (self,)))

    def pi(self):
        return self.trace.step("pi")

    def __bool__(self):
        raise TypeError("a formula must not branch on a value: traced scalars are neither true nor false")

    __eq__ = object.__eq__
    __hash__ = object.__hash__


def _is(x, number):
    return x is ZERO and number == 0 or type(x) in (int, float) and x == number


class _Trace:
    def __init__(self):
        self.steps, self.known = [], {}

    def step(self, op, *args):
        if any(isinstance(a, Moving) for a in args):
            return NotImplemented  # the moving number takes over and calls back with its parts
        key = tuple(("#", a.number) if isinstance(a, Step) else a for a in args)
        if op in "+*":
            key = tuple(sorted(key, key=repr))
        found = self.known.get((op, key))
        if found is None:
            found = self.known[op, key] = Step(self, op, args, len(self.steps))
            self.steps.append(found)
        return found


def _leaves(result):
    """The scalars in a result, and a function that puts others in their places. Vectors become triples."""
    if isinstance(result, dict):
        parts = [_leaves(v) for v in result.values()]
        keys = list(result)
        return _joined(parts, lambda values: dict(zip(keys, values, strict=True)))
    if isinstance(result, (tuple, list)) or hasattr(result, "frame"):
        return _joined([_leaves(v) for v in result], tuple)
    return [result], lambda values: values[0]


def _joined(parts, build):
    counts = [len(leaves) for leaves, _ in parts]

    def rebuild(values):
        at, out = 0, []
        for (_, make), n in zip(parts, counts, strict=True):
            out.append(make(values[at : at + n]))
            at += n
        return build(out)

    return [x for leaves, _ in parts for x in leaves], rebuild


def _text(trace, names, outputs):
    """The needed steps as lines of Python, each step used only once written inside its user."""
    used = {}
    needed, stack = set(), [o for o in outputs if isinstance(o, Step)]
    for o in stack:
        used[o.number] = used.get(o.number, 0) + 2  # an output keeps its own line
    while stack:
        s = stack.pop()
        if s.number in needed:
            continue
        needed.add(s.number)
        for a in s.args:
            if isinstance(a, Step):
                used[a.number] = used.get(a.number, 0) + 1
                stack.append(a)
    text, lines = {}, []
    for s in trace.steps:
        if s.number not in needed:
            continue
        if s.op == "argument":
            text[s.number] = s.args[0]
            continue
        written = _write(s.op, [text[a.number] if isinstance(a, Step) else f"({a!r})" for a in s.args])
        if used[s.number] == 1 and len(written) < 120:
            text[s.number] = f"({written})"
        else:
            text[s.number] = f"s{len(lines)}"
            lines.append(f"s{len(lines)} = {written}")
    results = [text[o.number] if isinstance(o, Step) else "0" if o is ZERO else repr(o) for o in outputs]
    return lines, results


def _write(op, args):
    if op in ("+", "-", "*", "/", "**"):
        return f"{args[0]} {op} {args[1]}"
    if op == "neg":
        return f"-{args[0]}"
    return op if op == "pi" else f"{op}({', '.join(args)})"


class Compiled:
    """What :func:`compiled` returns; call it like the formula. ``source`` is its text, ``operations`` how many it takes."""

    def __init__(self, f, constants, backend):
        parameters = [n for n in inspect.signature(f).parameters if n not in constants]
        trace = _Trace()
        arguments = {n: trace.step("argument", n) for n in parameters}
        leaves, self._rebuild = _leaves(f(**arguments, **constants))
        self.parameters, self.backend, self.name = parameters, backend, getattr(f, "__name__", "formula")
        self._lines, self._results = _text(trace, parameters, leaves)
        body = "".join(f"    {line}\n" for line in self._lines)
        self.source = f"def formula({', '.join(parameters)}):\n{body}    return {', '.join(self._results)},\n"
        self.operations = sum(self.source.count(f" {op} ") for op in ("+", "-", "*", "/", "**")) + sum(
            self.source.count(f"{name}(") for name in (*FUNCTIONS, "atan2")
        )
        self._run, self._seen, self._heyoka = {"math": self._on(math)}, 0, None

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
        given = dict(zip(self.parameters, args), **named)
        missing = [n for n in self.parameters if n not in given]
        unknown = [n for n in given if n not in self.parameters]
        if missing or unknown or len(args) > len(self.parameters):
            raise TypeError(
                f"{self.name} takes {', '.join(self.parameters)}"
                + (f"; missing: {', '.join(missing)}" if missing else "")
                + (f"; unknown: {', '.join(unknown)}" if unknown else "")
                + (f"; got {len(args)} values" if len(args) > len(self.parameters) else "")
            )
        return [given[n] for n in self.parameters]

    def _other(self, args):
        if any(isinstance(a, _Own) for a in args):
            return self._rebuild(self._run.setdefault("own", self._on(sys.modules[_Own.__module__]))(*args))
        library = _library(args)
        if library.__name__ == "numpy":
            return self._arrays(library, args)
        if library.__name__ not in self._run:
            self._run[library.__name__] = self._on(library)
        return self._rebuild(self._run[library.__name__](*args))

    def _on(self, library):
        """The text as a function over one library."""
        space = {name: getattr(library, name) for name in (*FUNCTIONS, "atan2", "pi") if hasattr(library, name)}
        if callable(space.get("pi")) and library.__name__.startswith("newton_euler"):
            space["pi"] = math.pi
        exec(compile(self.source, f"<compiled {self.name}>", "exec"), space)
        return space["formula"]

    def _arrays(self, np, args):
        rows = np.broadcast_arrays(*(np.asarray(a, dtype=float) for a in args))
        shape, count = rows[0].shape, rows[0].size
        rows = [r.ravel() for r in rows]
        self._seen += count
        out = self._by_heyoka(np, rows) if self._heyoka_pays() else self._in_blocks(np, rows, count)
        return self._rebuild([r.reshape(shape) for r in out])

    def _in_blocks(self, np, rows, count):
        run = self._run.get("numpy") or self._run.setdefault("numpy", self._on(np))
        out = np.empty((len(self._results), count))
        for start in range(0, count, BLOCK):
            block = slice(start, start + BLOCK)
            for row, value in zip(out, run(*(r[block] for r in rows)), strict=True):
                row[block] = value
        return out

    def _heyoka_pays(self):
        if self.backend == "numpy":
            return False
        if self._heyoka is None:
            if importlib.util.find_spec("heyoka") is None:
                if self.backend == "heyoka":
                    raise ImportError("backend='heyoka' needs heyoka: pip install 'newton-euler[fast]', or use backend='auto'")
                self.backend = "numpy"
                return False
            if self.backend == "auto" and self._seen < HEYOKA_PAYS["heyoka" in sys.modules]:
                return False
            self._heyoka = self._compile_heyoka()
        return True

    def _compile_heyoka(self):
        hy = importlib.import_module("heyoka")
        variables = hy.make_vars(*self.parameters) if len(self.parameters) > 1 else [hy.make_vars(*self.parameters)]
        outputs = [hy.expression(float(o)) if isinstance(o, (int, float)) else o for o in self._on(hy)(*variables)]
        return hy.cfunc(outputs, vars=variables)

    def _by_heyoka(self, np, rows):
        return self._heyoka(np.ascontiguousarray(np.stack(rows)))


def compiled(f, backend="auto", **constants):
    """``f``, traced once into straight-line text, for many fast evaluations.

    f : a function of scalars, without branches on their values; its result is a scalar, a Vector, or tuples and dicts of them
    backend : "auto" (NumPy in blocks, and heyoka as soon as its compile time is earned back), "numpy" or "heyoka"; for arrays only
    constants : parameters of ``f`` to fix now; they are not parameters of the result

    The result takes the same arguments, all floats, arrays that broadcast, or expressions, and returns what ``f`` returns, a Vector as
    a triple of components. **Batches:** an array argument of shape (N,) is N instants; each component of the result has shape (N,).

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
