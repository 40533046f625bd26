"""Whole answers with one factor too many or too few, or on the wrong side of a fraction."""

from collections.abc import Iterator
from itertools import permutations, product
from typing import Any

from newton_euler.algebra.language import Words
from newton_euler.algebra.trace import Step
from newton_euler.answers.causes import RESCALED
from newton_euler.answers.near import LEAST, LESS

from .edits_of_operations import CANCELS
from .facts import FORCE, GRAVITY, MASS, Facts
from .formulas import SUM, Edit, edit, steps_needed
from .typed import Product, described, is_given, terms_of

IN_TERMS = {"+", "-", "sqrt", "asin", "acos", "atan"}
MANY = 24  # places: in more, no given is left
SIDE = Words("has {name} on the wrong side of the fraction: put your units into the whole formula")
SUMS = {
    "+": Words("adds {name} to {key}: {key} alone is asked for"),
    "-": Words("subtracts {name} from {key}: the whole is asked for"),
}
TIMES = {
    "*": Words("multiplies {key} by {quantity}: look up what {key} stands for"),
    "/": Words("divides {key} by {quantity}: look up what {key} stands for"),
}


def of_wholes(f: Facts) -> Iterator[Edit]:
    """Whole answers with one factor of a given too many or too few."""
    components = [x for a in f.answers.values() for x in _steps(a)]
    for name, step in f.given.items():
        powers = {Product(x).powers.get(step, 0) for x in components}
        for op, change in (("/", -1), ("*", 1)):
            if -change in powers:
                continue  # would cancel the factor itself: a slip in the product
            words = _of_power(name, max(powers, key=abs), change)
            instead = {x.number: (op, x, f.number(step)) for x in components if x is not step}
            # nameless in a pair: one that mends the units of another is not a mistake
            yield edit(LESS, f"whole {op} {name}", words, instead, RESCALED)


def _of_power(name, power, change):
    """The words for a whole formula with another power of a given."""
    if power * change > 0:
        square = Words("squares {name}", name=name) if abs(power) == 1 else ""
        more = square or Words("has too high a power of {name}", name=name)
        return Words("{power}: put your units into the whole formula", power=more)
    few = Words("has one factor {name} too few: put your units into the whole formula", name=name)
    many = Words("has one factor {name} too many: put your units into the whole formula", name=name)
    return few if change < 0 else many


def of_sides(f: Facts) -> Iterator[Edit]:
    """Answers with a given on the other side: it has one power in all components."""
    for (key, a), (name, step) in product(f.answers.items(), f.given.items()):
        parts = _steps(a)
        powers = {Product(x).powers.get(step, 0) for x in parts}
        p = powers.pop() if len(powers) == 1 else 0
        if p and (len(parts) > 1 or abs(p) > 1):
            factor = ("**", f.number(step), float(2 * p))
            instead = {x.number: ("/", x, factor) for x in parts}
            yield edit(LEAST, f"side {name} {key}", Words(SIDE, name=name), instead)


def of_unneeded(f: Facts) -> Iterator[Edit]:
    """Masses, weights and g that an answer does not need, left in one term of a sum, in a root or
    an angle, or in the whole: they cancel.
    """
    kinds = {n: f.of(s) for n, s in f.anything.items()}
    heavy = [n for n, kind in kinds.items() if kind in (MASS, FORCE) or (n, kind) == ("g", GRAVITY)]
    for a in f.answers.values():
        steps = steps_needed(a.parts)
        places = {x.number: x for s in steps if s.op in IN_TERMS for x in s.args if is_given(x)}
        places |= {x.number: x for x in _steps(a)}
        idle = {n: f.anything[n] for n in heavy if all(f.anything[n] is not x for x in steps)}
        for name, step in idle.items() if len(places) <= MANY else ():
            for (n, x), op in product(places.items(), "*/"):
                instead = {n: (op, x, f.number(step))}
                yield edit(LEAST, f"{n} {op} {name}", Words(CANCELS, name=name), instead)


def of_quantities_in_wholes(f: Facts) -> Iterator[Edit]:
    """Whole answers times a quantity from which they are computed, or over it."""
    scalars = [(words, x) for words, (x, *others) in f.named if not others and isinstance(x, Step)]
    for key, a in f.answers.items():
        parts = _steps(a)
        inside = {s.number for s in steps_needed(parts)} - {x.number for x in parts}
        for words, q in scalars:
            if q.number not in inside or q.op == "argument" or f.of(q) is None:
                continue
            for op, text in TIMES.items():
                instead = {x.number: (op, x, f.number(q)) for x in parts}
                why = Words(text, key=key, quantity=words)
                yield edit(LEAST, f"{key} {op} {q.number}", why, instead)


def of_single_terms(f: Facts) -> Iterator[Edit]:
    """One term of three or more for an answer that is a sum."""
    for key, a in f.answers.items():
        x, *others = a.parts
        terms = [] if others else _expanded(x)
        for n, (term, whole) in enumerate(terms if len(terms) > 2 else ()):
            if named := described(term, "the term"):
                words = Words("gives {terms} alone: the sum has more terms", terms=named)
                yield edit(LESS, f"{n} alone for {key}", words, {x.number: whole})


def _expanded(x):
    """[(term, the term with its factor and sign)] of a sum, of a multiple of a sum."""
    found = list[tuple[Any, Any]]()
    for sign, term in terms_of(x):
        product = Product(term)
        inside = next(iter(product.powers), None)
        is_scaled = [*product.powers.values()] == [1]
        if is_scaled and isinstance(inside, Step) and inside.op in SUM:
            factor = sign * float(product.coefficient)
            found += [(t, ("*", own * factor, t)) for own, t in terms_of(inside)]
        else:
            found.append((term, ("*", float(sign), term)))
    return found


def of_sums(f: Facts) -> Iterator[Edit]:
    """The sum, or the difference, of two answers of one unit in place of one of them."""
    for (key, a), (other, b) in permutations(f.answers.items(), 2):
        pairs = [(x, y) for x, y in zip(a.parts, b.parts, strict=False) if isinstance(x, Step)]
        alike = a.unit == b.unit and a.points == b.points and len(a.parts) == len(b.parts)
        for op, text in SUMS.items() if alike and pairs else ():
            words, instead = (
                Words(text, key=key, name=other),
                {x.number: (op, x, y) for x, y in pairs},
            )
            yield edit(LEAST, f"{key} {op} {other}", words, instead)


def _steps(answer):
    return [x for x in answer.parts if isinstance(x, Step)]
