"""Whole answers with one factor too many or too few, or on the wrong side of a fraction."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import permutations, product
from typing import Any

from newton_euler.algebra.language import Words
from newton_euler.algebra.trace import Step
from newton_euler.answers.causes import RESCALED, computed
from newton_euler.answers.near import LEAST, LESS

from .edits_of_givens import FORCE, GRAVITY, MASS, DimensionOf
from .edits_of_operations import CANCELS
from .edits_of_quantities import Named
from .formulas import Edit, Traced, needed
from .typed import Product, described, is_given, terms_of

IN_TERMS = {"+", "-", "sqrt", "asin", "acos", "atan"}
MANY = 24  # places: in more, no given is left
SIDE = Words("has {name} on the wrong side of the fraction: put your units into the whole formula")
SUMS = {
    "+": Words("adds {name} to {key}: {key} alone is asked for").template,
    "-": Words("subtracts {name} from {key}: the whole is asked for").template,
}
TIMES = {
    "*": Words("multiplies {key} by {quantity}: look up what {key} stands for").template,
    "/": Words("divides {key} by {quantity}: look up what {key} stands for").template,
}


def of_wholes(
    answers: Mapping[str, Traced], given: Mapping[str, Step], number: Callable[[Step], Any]
) -> Iterator[Edit]:
    """Whole answers with one factor of a given too many or too few."""
    components = [x for a in answers.values() for x in _steps(a)]
    for name, step in given.items():
        powers = {Product(x).powers.get(step, 0) for x in components}
        for op, change in (("/", -1), ("*", 1)):
            if -change in powers:
                continue  # would cancel the factor itself: a slip in the product
            text = _of_power(name, max(powers, key=abs), change)
            # without a name in a pair: one that mends the units of another is not a mistake
            cause = computed(f"whole {op} {name}", text, does=RESCALED)
            instead = {x.number: (op, x, number(step)) for x in components if x is not step}
            yield Edit(LESS, cause, instead)


def _of_power(name, power, change):
    """The words for a whole formula with another power of a given."""
    if power * change > 0:
        square = Words("squares {name}", name=name) if abs(power) == 1 else ""
        more = square or Words("has too high a power of {name}", name=name)
        return Words("{power}: put your units into the whole formula", power=more)
    few = Words("has one factor {name} too few: put your units into the whole formula", name=name)
    many = Words("has one factor {name} too many: put your units into the whole formula", name=name)
    return few if change < 0 else many


def of_sides(
    answers: Mapping[str, Traced], given: Mapping[str, Step], number: Callable[[Step], Any]
) -> Iterator[Edit]:
    """Answers in all whose components a given has one power, with the opposite one."""
    for key, a in answers.items():
        parts = _steps(a)
        for name, step in given.items():
            powers = {Product(x).powers.get(step, 0) for x in parts}
            p = powers.pop() if len(powers) == 1 else 0
            if p and (len(parts) > 1 or abs(p) > 1):
                factor = ("**", number(step), float(2 * p))
                cause = computed(f"side {name} {key}", Words(SIDE.template, name=name))
                yield Edit(LEAST, cause, {x.number: ("/", x, factor) for x in parts})


def of_unneeded(
    given: Mapping[str, Step],
    answers: Mapping[str, Traced],
    number: Callable[[Step], Any],
    of: DimensionOf,
) -> Iterator[Edit]:
    """Masses, weights and g that an answer does not need, left in one term of a sum, in a root or
    an angle, or in the whole: they cancel.
    """
    kinds = {n: of(s) for n, s in given.items()}
    heavy = {n for n, kind in kinds.items() if kind in (MASS, FORCE) or (n, kind) == ("g", GRAVITY)}
    for a in answers.values():
        steps = needed(a.parts)
        places = {x.number: x for s in steps if s.op in IN_TERMS for x in s.args if is_given(x)}
        places |= {x.number: x for x in _steps(a)}
        idle = {n: given[n] for n in heavy if all(given[n] is not x for x in steps)}
        for name, step in idle.items() if len(places) <= MANY else ():
            words = Words(CANCELS, name=name)
            for (n, x), op in product(places.items(), "*/"):
                yield Edit(LEAST, computed(f"{n} {op} {name}", words), {n: (op, x, number(step))})


def of_quantities_in_wholes(
    answers: Mapping[str, Traced],
    named: Iterable[Named],
    number: Callable[[Step], Any],
    of: DimensionOf,
) -> Iterator[Edit]:
    """Whole answers times a quantity from which they are computed, or over it."""
    scalars = [(words, x) for words, (x, *others) in named if not others and isinstance(x, Step)]
    for key, a in answers.items():
        parts = _steps(a)
        inside = {s.number for s in needed(parts)} - {x.number for x in parts}
        for words, q in scalars:
            if q.number not in inside or q.op == "argument" or of(q) is None:
                continue
            for op, text in TIMES.items():
                cause = computed(f"{key} {op} {q.number}", Words(text, key=key, quantity=words))
                yield Edit(LEAST, cause, {x.number: (op, x, number(q)) for x in parts})


def of_single_terms(answers: Mapping[str, Traced]) -> Iterator[Edit]:
    """One term of three or more for an answer that is a sum."""
    for key, a in answers.items():
        x, *others = a.parts
        terms = [] if others else _expanded(x)
        for n, (term, whole) in enumerate(terms if len(terms) > 2 else ()):
            if named := described(term, "the term"):
                words = Words("gives {terms} alone: the sum has more terms", terms=named)
                yield Edit(LESS, computed(f"{n} alone for {key}", words), {x.number: whole})


def _expanded(x):
    """[(term, the term with its factor and sign)] of a sum; those of a sum with a number in front
    are terms of its own.
    """
    found = list[tuple[Any, Any]]()
    for sign, term in terms_of(x):
        product = Product(term)
        inside = next(iter(product.powers), None)
        is_scaled = [*product.powers.values()] == [1]
        if is_scaled and isinstance(inside, Step) and inside.op in ("+", "-"):
            factor = sign * float(product.coefficient)
            found += [(t, ("*", own * factor, t)) for own, t in terms_of(inside)]
        else:
            found.append((term, ("*", float(sign), term)))
    return found


def of_sums(answers: Mapping[str, Traced]) -> Iterator[Edit]:
    """The sum, or the difference, of two answers of one unit in place of one of them."""
    for (key, a), (other, b) in permutations(answers.items(), 2):
        pairs = [(x, y) for x, y in zip(a.parts, b.parts, strict=False) if isinstance(x, Step)]
        alike = a.unit == b.unit and a.points == b.points and len(a.parts) == len(b.parts)
        for op, text in SUMS.items() if alike and pairs else ():
            words = Words(text, key=key, name=other)
            instead = {x.number: (op, x, y) for x, y in pairs}
            yield Edit(LEAST, computed(f"{key} {op} {other}", words), instead)


def _steps(answer):
    return [x for x in answer.parts if isinstance(x, Step)]
