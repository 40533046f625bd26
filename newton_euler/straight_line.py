"""Traced steps as text: lines of Python in order, each step that is used only once written inside its user.

On floats what only one side of a choice needs stands under an ``if``; arrays and heyoka take both sides.
"""

import math
import operator
from itertools import takewhile

from .scalars import _root, plain, where
from .steps import Step

COMPARISONS = {"lt": "<", "le": "<=", "gt": ">", "ge": ">="}


def _text(trace, names, outputs, lazy):
    """The needed steps as lines of Python, each step used only once written inside its user.

    Returns the lines, the results, the constants that have no plain spelling by name, and the number of operations. Lazy text computes what only one
    side of a choice needs under an ``if``; arrays and heyoka take both sides.
    """
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
                used[a.number] = used.get(a.number, 0) + (2 if s.op == "where" and a is s.args[0] else 1)  # a condition is asked again
                stack.append(a)
    steps = [s for s in trace.steps if s.number in needed]
    places = _places(steps, outputs) if lazy else {}
    text, lines, constants, operations = {}, [], {}, 0
    mark = unused("s", names)

    def spelled(a):
        if isinstance(a, Step):
            return text[a.number]
        a = a.item() if _root(type(a)) == "numpy" else plain(a)
        if type(a) in (int, float, bool) and abs(a) < math.inf:
            return f"({a!r})"
        name = f"{unused('c', names)}{len(constants)}"  # mpf, Fraction, inf, nan, symbols
        constants[name] = a
        return name

    for s in steps:
        if s.op == "argument":
            text[s.number] = names[s.args[0]]
            continue
        operations += s.op not in ("neg", "pi")
        written = _write(s.op, [spelled(a) for a in s.args], lazy)
        if used[s.number] == 1 and len(written) < 120:
            text[s.number] = f"({written})"
        else:
            text[s.number] = f"{mark}{len(lines)}"
            lines.append((places.get(s.number, ()), f"{text[s.number]} = {written}"))
    return _indented(lines, text), [spelled(o) for o in outputs], constants, operations


def _places(steps, outputs):
    """For each step the sides of choices that alone need it, outermost first: pairs of the number of a condition known by then, and True or False."""
    places = {o.number: () for o in outputs if isinstance(o, Step)}
    for s in reversed(steps):
        own = places[s.number]
        for i, a in enumerate(s.args):
            if isinstance(a, Step):
                path = (*own, (s.args[0].number, i == 1)) if s.op == "where" and i else own
                path = tuple(takewhile(lambda choice, n=a.number: choice[0] < n, path))
                places[a.number] = _shared(places[a.number], path) if a.number in places else path
    return places


def _shared(a, b):
    """The beginning that two sequences have in common."""
    return tuple(x for x, _ in takewhile(lambda pair: pair[0] == pair[1], zip(a, b, strict=False)))


def _indented(lines, text):
    """The lines, each under the conditions of its place."""
    out, before = [], ()
    for place, line in lines:
        for depth in range(len(_shared(before, place)), len(place)):
            number, side = place[depth]
            out.append(f"{depth * '    '}if {'' if side else 'not '}{text[number]}:")
        out.append(len(place) * "    " + line)
        before = place
    return out


def unused(letter, names):
    """The letter, behind as many underscores as keep letter and digits apart from the names of the arguments."""
    while any(n.startswith(letter) and n[len(letter) :].isdigit() for n in names.values()):
        letter = "_" + letter
    return letter


def _write(op, args, lazy):
    if op in ("+", "-", "*", "/", "**"):
        return f"{args[0]} {op} {args[1]}"
    if op == "neg":
        return f"-{args[0]}"
    if lazy and op == "where":
        return f"{args[1]} if {args[0]} else {args[2]}"
    if lazy and op in COMPARISONS:
        return f"{args[0]} {COMPARISONS[op]} {args[1]}"
    return op if op == "pi" else f"{op}({', '.join(args)})"


def written(trace, names, leaves, lazy):
    """The text of the function, its constants, the number of its operations, and the results as they stand in it."""
    lines, results, constants, operations = _text(trace, names, leaves, lazy)
    body = "".join(f"    {line}\n" for line in lines)
    return f"def formula({', '.join(names.values())}):\n{body}    return {', '.join(results)},\n", constants, operations, results


def choices(library):
    """What the text calls ``where``, ``lt`` … over this library, and the powers of a number in heyoka."""
    if library.__name__ != "heyoka":
        chosen = library.where if library.__name__ == "numpy" else where
        return {"where": chosen, **{name: getattr(operator, name) for name in COMPARISONS}}
    hy = library

    def over(f):
        return lambda *args: f(*(a if isinstance(a, hy.expression) else hy.expression(float(a)) for a in args))

    names = {"where": over(hy.select), "lt": over(hy.lt), "le": over(hy.lte), "gt": over(hy.gt), "ge": over(hy.gte)}
    size = over(lambda x: hy.select(hy.lt(x, hy.expression(0.0)), -x, x))
    return {**names, "abs": size, "pow": lambda base, x: hy.expression(float(base)) ** x}
