"""Traced steps as Python source: lines in order, each step that is used only once written inside
its user. On floats, what only one side of a choice needs is computed under an ``if``.
"""

import math
import operator
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from itertools import takewhile
from types import ModuleType
from typing import Any

from .integrals import integrals, over_cube
from .roots import root
from .scalars import FUNCTIONS, Scalar, ScalarError, _root, to_plain, where
from .trace import COMPARISONS, Step, Trace

# what is done with a formula ``f`` inside a text, of the arguments x and ``outer``
WITHIN: dict[str, Callable[..., Any]] = {
    "integral": lambda f, start, end, *outer: integrals(lambda x: f(x, *outer), start, end),
    "over_cube": lambda f, n, *outer: over_cube(lambda *places: f(*places, *outer), n),
    "root": lambda f, low, high, *outer: (root(lambda x: f(x, *outer)[0], low, high),),
}
WITHOUT_HEYOKA = {*WITHIN, "table"}
# names in the text that no argument can have
RESERVED = {*FUNCTIONS, *COMPARISONS, "atan2", "pi", "pow", "abs", "where", *WITHIN}


def generate(
    trace: Trace, names: Mapping[str, str], outputs: Sequence[Scalar], lazy: bool
) -> tuple[str, dict[str, Scalar], int]:
    """The text of a function ``formula`` of the arguments ``names`` that returns the outputs, lazy
    or not; its constants that have no literal, by name; and the number of its operations.
    """
    used = uses(trace, outputs)
    steps = [s for s in trace.steps if s.number in used]
    branches = _branches(steps, outputs) if lazy else {}
    text: dict[int, str] = {}
    lines: list[tuple[tuple, str]] = []
    constants: dict[str, Scalar] = {}
    operations = 0
    line_letter, constant_letter = unused("s", names.values()), unused("c", names.values())

    def spelled(a):
        if isinstance(a, Step):
            return text[a.number]
        a = a.item() if _root(type(a)) == "numpy" else to_plain(a)
        if type(a) in (int, float, bool) and abs(a) < math.inf:
            return f"({a!r})"
        name = f"{constant_letter}{len(constants)}"  # mpf, Fraction, inf, nan, symbols
        constants[name] = a
        return name

    for s in steps:
        if s.op == "argument":
            text[s.number] = names[s.args[0]]
            continue
        operations += s.op not in ("neg", "pi")
        written = _written(s.op, [spelled(a) for a in s.args], lazy)
        # a line stays readable, and within the 200 nested parentheses that Python allows
        if used[s.number] == 1 and len(written) < 120:
            text[s.number] = f"({written})"
        else:
            text[s.number] = f"{line_letter}{len(lines)}"
            lines.append((branches.get(s.number, ()), f"{text[s.number]} = {written}"))
    result = f"return {', '.join(map(spelled, outputs))}{',' if outputs else '()'}"
    body = "".join(f"    {line}\n" for line in [*_indented(lines, text), result])
    return f"def formula({', '.join(names.values())}):\n{body}", constants, operations


def uses(trace: Trace, outputs: Iterable[Scalar]) -> dict[int, int]:
    """How often each step that the outputs need is used, by its number."""
    used = {o.number: 2 for o in outputs if isinstance(o, Step)}  # an output has a line of its own
    for s in reversed(trace.steps):
        for a in s.args if s.number in used else ():
            if isinstance(a, Step):
                # a condition counts twice, to have a line: several branches can test it
                twice = s.op == "where" and a is s.args[0]
                used[a.number] = used.get(a.number, 0) + 1 + twice
    return used


def _branches(steps, outputs):
    """For each step the branches that alone need it, outermost first: pairs (condition, value)."""
    branches = {o.number: () for o in outputs if isinstance(o, Step)}
    for s in reversed(steps):
        own = branches[s.number]
        for i, a in enumerate(s.args):
            if isinstance(a, Step):
                path = (*own, (s.args[0].number, i == 1)) if s.op == "where" and i else own
                path = tuple(takewhile(lambda choice, n=a.number: choice[0] < n, path))
                branches[a.number] = _shared(branches.get(a.number, path), path)
    return branches


def _shared(a, b):
    """The beginning that two sequences have in common."""
    return tuple(x for x, _ in takewhile(lambda pair: pair[0] == pair[1], zip(a, b, strict=False)))


def _indented(lines, text):
    """The lines, each under the conditions of its branch."""
    before = ()
    for branch, line in lines:
        for depth in range(len(_shared(before, branch)), len(branch)):
            number, side = branch[depth]
            yield f"{depth * '    '}if {'' if side else 'not '}{text[number]}:"
        yield len(branch) * "    " + line
        before = branch


def named_apart(names: Iterable[str]) -> dict[str, str]:
    """{name: the same, or with underscores behind it where it means something else in the text}."""
    behind = "_"
    while any(f"{name}{behind}" in names for name in RESERVED.intersection(names)):
        behind += "_"
    return {name: name + behind * (name in RESERVED) for name in names}


def unused(letter: str, names: Collection[str]) -> str:
    """The letter, with as many underscores before it as make no name equal to it with digits."""
    while any(n.startswith(letter) and n[len(letter) :].isdigit() for n in names):
        letter = "_" + letter
    return letter


def _written(op, args, lazy):
    if op in ("+", "-", "*", "/", "**"):
        return f"{args[0]} {op} {args[1]}"
    if op == "neg":
        return f"-{args[0]}"
    if op == "table":
        return f"{args[1]}({args[0]})"
    if op == "item":  # one of the values of a formula inside this one
        return f"{args[0]}[{args[1].strip('()')}]"
    if lazy and op == "where":
        return f"{args[1]} if {args[0]} else {args[2]}"
    if lazy and op in COMPARISONS:
        return f"{args[0]} {COMPARISONS[op]} {args[1]}"
    return op if op == "pi" else f"{op}({', '.join(args)})"


def operations(library: ModuleType) -> dict[str, Any]:
    """The function of each operation of a trace, over math or NumPy."""
    functions = {n: getattr(library, n) for n in (*FUNCTIONS, "atan2") if hasattr(library, n)}
    return {
        "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv,
        "**": operator.pow, "pow": operator.pow, "neg": operator.neg, "abs": abs,
        "item": operator.getitem, "pi": lambda: library.pi, **functions, **runtime_names(library),
    }  # fmt: skip


def runtime_names(library: ModuleType) -> dict[str, Callable[..., Any]]:
    """``where``, ``lt`` … of a text over this library; for heyoka also ``abs`` and ``pow``."""
    if library.__name__ != "heyoka":
        choice = library.where if library.__name__ == "numpy" else where
        comparisons = {name: getattr(operator, name) for name in COMPARISONS}
        return {"where": choice, **WITHIN, **comparisons}
    hy = library

    def over(f):
        return lambda *args: f(
            *(a if isinstance(a, hy.expression) else hy.expression(float(a)) for a in args)
        )

    def refused(*_):
        raise ScalarError("heyoka has no integrals and roots inside a formula")

    return {
        **dict.fromkeys(WITHIN, refused),
        "lt": over(hy.lt),
        "le": over(hy.lte),
        "gt": over(hy.gt),
        "ge": over(hy.gte),
        "where": over(hy.select),
        "abs": over(lambda x: hy.select(hy.lt(x, hy.expression(0.0)), -x, x)),
        "pow": lambda base, x: hy.expression(float(base)) ** x,
    }
