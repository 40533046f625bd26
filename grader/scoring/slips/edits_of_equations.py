"""Slips in linear equations that are solved together: an unknown or a right side with the opposite
sign, or left out, in one of them, or in finding one unknown from the others.
"""

import re
from collections.abc import Iterator
from functools import lru_cache
from itertools import permutations
from typing import Any

from newton_euler.algebra.language import Words
from newton_euler.algebra.late import np
from newton_euler.algebra.trace import Step
from newton_euler.answers.near import LEAST, LESS, SIMPLE

from .edits_of_operations import COFUNCTIONS
from .facts import LENGTH, Facts, entries, to_float
from .formulas import Edit, edit, total
from .typed import Product, described, is_given, typed

SLIPS = {
    -1.0: Words("has {term} reversed in one equation: check which way it points"),
    0.0: Words("leaves out {term} in one equation: it acts there, too"),
}
ARMS = {
    1.0: Words("leaves out {arm} beside {term} in one equation: a moment needs an arm"),
    2.0: Words("takes twice {arm} beside {term} in one equation: look for it in the figure"),
    0.5: Words("takes half of {arm} beside {term} in one equation: look for it in the figure"),
}
LATER = {
    -1.0: Words("has {term} reversed in finding {unknown}: check which way it points"),
    0.0: Words("leaves out {term} in finding {unknown}: it acts there, too"),
    2.0: Words("doubles what stands beside {term} in finding {unknown}: look for its arm"),
    0.5: Words("halves what stands beside {term} in finding {unknown}: look for its arm"),
}
TURNED = Words(
    "takes {twin} for {own} beside {term} in finding {unknown}: check where the angle is"
)
ALONE = Words("has {unknown} in one equation only: it acts in the others, too")
EQUAL = Words("takes {unknown} and {other} as equal: they are two unknowns")
FEW = 3  # unknowns: of more, none is found from the others
NAMELESS = re.compile(r"u_\d+")  # unknowns without a name of their own


def of_equations(f: Facts) -> Iterator[Edit]:
    """The slips in the entries of each system."""
    for system in f.systems:
        width, inside = len(system.names) + 1, entries(system)
        for place, x in enumerate(inside):
            name = _name(place % width, x, system.names)
            if not name or (not isinstance(x, Step) and x == 0):
                continue
            slips: list[tuple[int, Any, Words]] = [
                (SIMPLE, factor, Words(words, term=name)) for factor, words in SLIPS.items()
            ]
            arms = [a for a, n in Product(x).powers.items() if n == 1 and f.of(a) == LENGTH]
            for arm, named in ((a, described(a)) for a in arms):
                for factor, text in ARMS.items() if named else ():
                    times = ("/", 1.0, f.number(arm)) if factor == 1 else factor
                    slips.append((LESS, times, Words(text, arm=named, term=name)))
            for n, (rank, factor, words) in enumerate(slips):
                instead = _solutions(system, float(place), factor, inside)
                yield edit(rank, f"equations {[*instead]} {place} {n}", words, instead)
        yield from _of_one_equation(system)
        yield from _of_one_unknown(system, f.of)


def _solutions(system, place, factor, inside):
    """{unknown: its expression} where the entry at this place is ``factor`` times its own."""
    width, unknowns = float(len(system.names) + 1), [system.values[n] for n in system.names]
    return {
        s.number: ("equations", width, float(k), place, factor, *inside)
        for k, s in enumerate(unknowns)
        if isinstance(s, Step)
    }


def _of_one_equation(system):
    """An unknown left out of all equations but one, of three or more that it is in."""
    width, rows = len(system.names) + 1, range(len(system.names))
    for k, name in enumerate(system.names):
        x, inside = system.values[name], entries(system)
        there = [n for n in rows if isinstance(c := inside[n * width + k], Step) or c != 0]
        is_named = isinstance(x, Step) and not NAMELESS.fullmatch(name)
        for kept in there if is_named and len(there) > 2 else ():
            alone = [*inside]
            for n in {*there} - {kept}:
                alone[n * width + k] = 0.0
            instead = _solutions(system, 0.0, 1.0, alone)
            yield edit(LEAST, f"{x.number} in {kept} alone", Words(ALONE, unknown=name), instead)


def _of_one_unknown(system, of):
    """An unknown found from the others, with a slip in a term, or taken as equal to one."""
    names, values = system.names, [to_float(system.values[n]) for n in system.names]
    known = {y.number: y for y in values if isinstance(y, Step)}
    for n, (row, right) in enumerate(system.equations if len(names) <= FEW else ()):
        a, terms = [*map(to_float, row)], [to_float(right)]
        terms += [("*", ("neg", c), x) for c, x in zip(a, values, strict=True)]
        there = [k for k, c in enumerate([terms[0], *a]) if isinstance(c, Step) or c != 0]
        for k, other in permutations(there, 2):
            x, name = values[k - 1], names[k - 1]
            if k == 0 or not isinstance(x, Step) or NAMELESS.fullmatch(name):
                continue
            rest = [terms[m] for m in there if m not in (k, other)]
            term = _name((other - 1) % (len(names) + 1), right, names)
            beside = a[other - 1] if other else right
            for words, times in _of_term(beside, term, name, bool(rest)) if term else ():
                whole = ("/", total([*rest, ("*", terms[other], times)]), a[k - 1])
                instead = {**known, x.number: whole}
                yield edit(LEAST, f"{x.number} of {n} {other} {times}", words, instead)
            y = values[other - 1]
            if other and isinstance(y, Step) and of(x) is not None and of(x) == of(y) and rest:
                both = ("/", total(rest), ("+", a[k - 1], a[other - 1]))
                words = Words(EQUAL, unknown=name, other=names[other - 1])
                instead = {**known, x.number: both, y.number: both}
                yield edit(LESS, f"equal {n} {x.number} {y.number}", words, instead)


def _of_term(beside, term, unknown, has_rest):
    """(words, factor) of the slips in a term; ``has_rest``: it is one of several."""
    for times, words in LATER.items():
        if times < 0 or has_rest or (isinstance(beside, Step) and times):
            yield Words(words, term=term, unknown=unknown), times
    for x, power in Product(beside).powers.items():
        if abs(power) == 1 and x.op in COFUNCTIONS and is_given(x):
            twin = (COFUNCTIONS[x.op], *x.args)
            own, other = typed(x), f"{twin[0]}({typed(x.args[0])})"
            if own:
                words = Words(TURNED, own=own, twin=other, term=term, unknown=unknown)
                yield words, ("/", twin, x) if power > 0 else ("/", x, twin)


def _name(column, x, names):
    if column == len(names):
        return described(x, "the term") or Words("the right side")
    return "" if NAMELESS.fullmatch(names[column]) else names[column]


def solution(width: float, unknown: float, place: float, factor: float, *inside: float) -> Any:
    """An unknown of the equations in which the entry at this place is ``factor`` times its own."""
    x, inverse = _solved(int(width), inside)
    if x is None:
        return float("nan")
    i, j = divmod(int(place), int(width))
    k, change = int(unknown), (factor - 1) * inside[int(place)]
    if j == int(width) - 1:
        return x[k] + change * inverse[k, i]
    return x[k] - change * x[j] / (1 + change * inverse[j, i]) * inverse[k, i]


@lru_cache(maxsize=16)
def _solved(width, inside):
    """(solution, inverse matrix); (None, None) of singular equations."""
    rows = np.array(inside).reshape(-1, width)
    try:
        inverse = np.linalg.inv(rows[:, :-1])
    except np.linalg.LinAlgError:
        return None, None
    return inverse @ rows[:, -1], inverse
