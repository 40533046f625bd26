"""Slips that are made in several places at once: one term wherever it stands, all terms of one
shape, a factor in all products.
"""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from newton_euler.algebra.language import Words
from newton_euler.algebra.trace import Step
from newton_euler.answers.causes import LEFT_OUT, REVERSED
from newton_euler.answers.near import LEAST, LESS

from .facts import AREA, INERTIA, Facts
from .formulas import PRODUCT, SUM, Edit, edit, steps_needed
from .typed import Product, described, typed

LIKE_IT = Words("the other terms like it")
ALIKE = 8  # terms of one shape: more are not a single slip
LARGE = 7  # a number from here on is not taken for the next one
FRACTIONS = {Fraction(1, n) for n in (2, 3, 4, 12)}  # one is taken for another
INNER = Words("leaves out the inner derivative {name}: each chain rule brings it in")
EXCHANGED = Words("exchanges the factors 1/2 and 1/4: each belongs to its own axis")


def of_terms(f: Facts) -> Iterator[Edit]:
    """A term that several sums have, and all terms of one shape, as m*x_1^2 and m*x_2^2: left out,
    or with the opposite sign.
    """
    alike: dict[Any, list[Step]] = {}
    for s in f.users:
        ends = _sums(s, f.users) if s.op in (*PRODUCT, "sqrt") and described(s) else 0
        if ends > 1:
            yield from _of_terms([s], described(s, "the term"))
        if ends and (shape := _shape(s, f.formulas.units)):
            alike.setdefault(shape, []).append(s)
    for terms in alike.values():
        if 1 < len(terms) <= ALIKE and (first := typed(terms[0])):
            others = typed(terms[1]) if len(terms) == 2 else ""
            words = Words("{first} and {others}", first=first, others=others or LIKE_IT)
            yield from _of_terms(terms, words)


def _of_terms(terms, words):
    name = " ".join(str(s.number) for s in terms)
    left_out = Words("leaves out {term}: it matters here", term=words)
    zero = {s.number: 0.0 for s in terms}
    yield edit(LESS, f"no terms {name}", left_out, zero, LEFT_OUT, words)
    turned = Words("has {term} with the opposite sign: it points the other way", term=words)
    instead = {s.number: ("neg", s) for s in terms}
    yield edit(LEAST, f"turned {name}", turned, instead, REVERSED, words)


def _sums(s, users):
    """The number of sums of which a step, times a number, is a term; 0 if it is anything else."""
    count = 0
    for user in users[s]:
        scaled = user.op in PRODUCT and user.args[0] is s and not isinstance(user.args[1], Step)
        found = _sums(user, users) if scaled or user.op == "neg" else user.op in SUM
        if not found:
            return 0
        count += found
    return count


def _shape(s, units):
    """The shape that terms share if they differ by givens of one unit; None of any other."""
    product = Product(s)
    factors = [(units.get(x.args[0]) if x.op == "argument" else x.op, p)
               for x, p in product.powers.items()]  # fmt: skip
    simple = all(x.op in ("argument", "pi") for x in product.powers)
    return (abs(product.coefficient), *sorted(factors)) if product.is_exact and simple else None


def of_factors(f: Facts) -> Iterator[Edit]:
    """A factor that is left out of all products."""
    used: dict[Step, list[int]] = {}
    for s in f.products:
        for x, power in Product(s).powers.items():
            used.setdefault(x, []).append(power)
    for x, powers in used.items():
        if (len(powers) > 1 or x.op == "pi") and x.op != "argument" and (named := described(x)):
            words = Words("leaves out the factor {factor}: the formula has it", factor=named)
            if max(powers) < 0:
                words = Words("does not divide by {factor}: the formula does", factor=named)
            yield edit(LESS, f"no {x.number}", words, {x.number: ("/", x, f.number(x))})
    yield from _of_chain_rule(f)


def _of_chain_rule(f):
    """A given that each differentiation of sin(n*t) brings in as a factor, left out of all."""
    turning = [x for s in f.products for x in Product(s).powers if x.op in ("sin", "cos")]
    inside = dict.fromkeys(steps_needed(turning))
    for x in (x for x in inside if x.op == "argument"):
        lost = {
            s.number: ("/", s, ("**", f.number(x), float(n)))
            for s in f.products if s not in inside and (n := Product(s).powers.get(x, 0)) > 0
        }  # fmt: skip
        if len(lost) > 1:
            yield edit(LESS, f"chain rule {x.number}", Words(INNER, name=x.args[0]), lost)


def neighbours(c: Fraction) -> list[Fraction]:
    """The factors with the next numbers, as 1/4 and 1/6 for 1/5; none of large numbers."""
    n, d = c.numerator, c.denominator
    above = [Fraction(n + k, d) for k in (1, -1) if n != 1 < n + k] if n < LARGE else []
    return above + ([Fraction(n, d + k) for k in (1, -1) if d != 1 < d + k] if d < LARGE else [])


def of_constants(f: Facts) -> Iterator[Edit]:
    """One constant left out, or taken for another, wherever it is a factor, as both halves of
    (x/2, y/2).
    """
    found: dict[tuple, dict[int, Step]] = {}
    for s in f.steps:
        if s.op in PRODUCT and isinstance(s.args[0], Step) and not isinstance(s.args[1], Step):
            found.setdefault((s.op, abs(float(s.args[1]))), {})[s.number] = s
    yield from _of_halves(found, {s.number for s in f.steps if f.of(s) in (INERTIA, AREA)})
    for (op, x), places in found.items():
        c = Fraction(x).limit_denominator(999) if x else Fraction(1)
        if len(places) < 2 or c == 1 or abs(c - Fraction(x)) > 1e-12 * c:
            continue
        own = c if op == "*" else 1 / c
        others = {Fraction(1), 2 * own, own / 2, *(FRACTIONS if own in FRACTIONS else ())}
        formula = next(filter(None, (_in_full(s, f.users) for s in places.values())), "")
        there = Words(" in several places, as in {formula}", formula=formula)
        there = there if formula else Words(" in several places")
        for other in sorted({*others, *neighbours(own)} - {own}):
            words = Words(
                "takes the factor {other} for {own}{there}: the formulas have {own}",
                other=other, own=own, there=there,
            )  # fmt: skip
            if other == 1:
                words = Words(
                    "leaves out the factor {own}{there}: the formulas have it", own=own, there=there
                )
            instead = {n: ("*", s, float(other / own)) for n, s in places.items()}
            yield edit(LESS, f"{other} everywhere {op} {x}", words, instead)


def _of_halves(places, inertias):
    """1/2 and 1/4 exchanged, as in the moments of inertia of a disk."""
    halves, quarters = (places.get(("/", float(n)), {}) for n in (2, 4))
    if inertias & {*halves} and inertias & {*quarters}:
        instead = {n: ("/", s, 2.0) for n, s in halves.items()}
        instead |= {n: ("*", s, 2.0) for n, s in quarters.items()}
        yield edit(LESS, "halves and quarters", EXCHANGED, instead)


def _in_full(s, users):
    """The product of which a step is a part, as it is typed; "" for none that is short."""
    while len(users[s]) == 1 and users[s][0].op in PRODUCT and typed(users[s][0]):
        (s,) = users[s]
    return typed(s)
