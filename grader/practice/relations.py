"""How later quantities of a problem follow from earlier ones: the traced computation, with
everything that depends only on the givens evaluated for one variant. The rest starts from the
values of quantities, which may be a student's own.
"""

import math
from typing import Any

from exercises.catalogue import Problem
from exercises.catalogue.steps import repeated
from exercises.catalogue.tracing import traced_quantities
from newton_euler.algebra.source import WITHIN
from newton_euler.algebra.trace import Step
from newton_euler.algebra.units import unit
from newton_euler.classroom.practising.programs import OPERATIONS

from ..assignment.cells import Values
from ..assignment.names import unsigned, value_of


def relations(p: Problem, values: Values) -> dict[str, Any] | None:
    """{"operations": [[name, *arguments]], "quantities": {key: [component]}, "earlier": {key:
    [keys]}} for :class:`~newton_euler.classroom.practising.programs.Program`; None if the
    computation cannot be traced.

    An argument is a number, or [n] for operation n. A component is [n, factor] for a multiple of
    operation n, or a number, or None if undefined.
    """
    try:
        components = _traced(p)
    except (TypeError, ValueError, ArithmeticError, AttributeError):
        return None  # it branches on values
    trace = next((x.trace for parts in components.values() for x, _ in parts if _is_step(x)), None)
    if trace is None:
        return None
    numbers = _evaluated(trace, p.base(values))
    starts = {x.number for parts in components.values() for x, _ in parts if _is_step(x)}
    program: list[Any] = []
    place: dict[int, int] = {}
    reached: dict[Any, Any] = {}
    for s in trace.steps:
        if s.op in ("item", *WITHIN) or not isinstance(numbers[s.number], float):
            continue
        from_quantities = _reached(s, reached, starts)
        if s.number in starts or from_quantities:
            place[s.number] = len(program)
            known = s.op in OPERATIONS and from_quantities
            arguments = [_argument(a, numbers, place) for a in s.args] if known else []
            known = known and None not in arguments
            program.append([s.op, *arguments] if known else ["value", numbers[s.number]])
            reached[s.number] = from_quantities if known else frozenset()
    where = {
        key: [
            [place[x.number], factor]
            if _is_step(x) and x.number in place
            else _constant_part(x, factor, numbers)
            for x, factor in parts
        ]
        for key, parts in components.items()
    }
    return {"operations": program, "quantities": where, "earlier": _earlier(components, reached)}


def _is_step(x):
    return isinstance(x, Step)


def _traced(p):
    """{key: [(traced component in base units, factor to the unit of the text)]}."""
    found = traced_quantities(p)
    factors = {key: unit(u).from_base(1.0, p.system) for key, u in found.units.items()}
    parts = {k: map(unsigned, x) for k, x in found.components.items() if k not in repeated(p)}
    return {key: [(x, sign * factors[key]) for x, sign in pairs] for key, pairs in parts.items()}


def _evaluated(trace, g):
    """The number of each traced operation for these values, or None."""
    memo: dict[int, float | None] = {}
    found = [value_of(s, g, memo) for s in trace.steps]
    return [None if x is None or not math.isfinite(x) else x for x in found]


def _constant_part(x, factor, numbers):
    """A component that does not depend on the quantities."""
    value = numbers[x.number] if _is_step(x) else float(x)
    return None if value is None else factor * value


def _argument(a, numbers, place):
    if not _is_step(a):
        return float(a)
    return [place[a.number]] if a.number in place else numbers[a.number]


def _reached(s, reached, starts):
    """The numbers of the quantities that an operation is computed from."""
    found = frozenset()
    for a in s.args:
        if _is_step(a):
            found |= {a.number} if a.number in starts else reached.get(a.number, frozenset())
    return found


def _earlier(components, reached):
    """{key: keys of the earlier quantities that it is computed from}."""
    owners, found = {}, {}
    for key, parts in components.items():
        own = [x.number for x, _ in parts if _is_step(x)]
        through = {n for x in own for n in ({x} if x in owners else reached.get(x, ()))}
        found[key] = sorted({owners[n] for n in through if n in owners})
        for n in own:
            owners.setdefault(n, key)
    return {key: earlier for key, earlier in found.items() if earlier}
