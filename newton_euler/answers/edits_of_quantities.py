"""Slips in whole quantities: one for another, twice or half of it or its opposite; another length
for a distance, a component for the whole, a density for a mass, rates that turn the other way.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import product
from typing import Any

from ..algebra.language import Words, joined
from ..algebra.trace import Step
from ..algebra.units import Dimension
from .causes import computed
from .edits_of_givens import FORCE, GRAVITY, LENGTH, MASS
from .edits_of_groups import LIKE_IT
from .edits_of_operations import parts_of
from .formulas import LEAST, LESS, RARER, Edit, Stage, Traced, steps_in, users_of
from .typed import Product, described, repeats, terms_of, typed

DimensionOf = Callable[[Step], Dimension | None]
SPEED, RATE = Dimension(0, 1, -1), Dimension(0, 0, -1)
DENSITIES = [Dimension(1, -n) for n in (1, 2, 3)]
BINOMIALS = {
    "plus": Words(
        "leaves the mixed term out of the square of {sum}: (a + b)^2 has 2*a*b as well"
    ).template,
    "signs": Words("squares each term of {sum}: the whole is squared").template,
    "none": Words("does not square {sum}: the formula does").template,
}
SCALED = {
    -1.0: Words("takes {quantity} with the opposite sign: its sense is the other one").template,
    2.0: Words("doubles {quantity}: it counts once").template,
    0.5: Words("halves {quantity}: it counts in full").template,
    0.0: Words("leaves out {quantity}: it is not zero here").template,
}


def of_quantities(
    answers: Mapping[str, Traced], stages: Sequence[Stage], steps: Sequence[Step], of: DimensionOf
) -> Iterator[Edit]:
    """Quantities on the way and answers from which others are computed: one for another, twice or
    half of one, its opposite, none.
    """
    users = users_of(steps)
    named = [(s.means, [*map(_plain, s.parts)]) for s in stages if s.means]
    named += [(key, [*map(_plain, a.parts)]) for key, a in answers.items()]
    for words, parts in named:
        own = {x.number: x for x, _ in parts if isinstance(x, Step) and x.op != "argument"}
        if not any(users.get(x) for x in own.values()):
            continue
        for factor, text in SCALED.items():
            cause = computed(f"{factor} times {[*own]}", Words(text, quantity=words))
            rank = LESS if factor else RARER
            yield Edit(rank, cause, {n: ("*", x, factor) for n, x in own.items()})
        for other, instead in named if len(own) == len(parts) else ():
            pairs = [*zip(parts, instead, strict=False)]
            if len(instead) != len(parts) or not all(_are_alike(x, y, of) for x, y in pairs):
                continue
            text = Words("takes {other} for {own}: each has its own place", other=other, own=words)
            cause = computed(f"{other} for {[*own]}", text)
            signed = {x.number: y if s == t else ("neg", y) for (x, s), (y, t) in pairs}
            yield Edit(LESS, cause, signed)


def of_cross_products(
    answers: Mapping[str, Traced], stages: Sequence[Stage], steps: Sequence[Step]
) -> Iterator[Edit]:
    """The middle component of a cross product with the opposite sign, and sums for its
    differences.
    """
    users = users_of(steps)
    named = [(key, a.parts) for key, a in answers.items()]
    for words, parts in [*named, *((s.means, s.parts) for s in stages if s.means)]:
        if len(parts) == 3 and all(map(_is_of_products, parts)):
            sums = Words("adds the products in {vector}: a cross product has differences")
            turned = Words(
                "has the middle component of {vector} with the opposite sign: the determinant has "
                "a minus there"
            )
            instead = {x.number: ("+", *x.args) for x in parts}
            yield _of_vector(sums, words, instead)
            if users.get(middle := parts[1]):
                yield _of_vector(turned, words, {middle.number: ("neg", middle)})


def _of_vector(text, name, instead):
    words = Words(text.template, vector=name)
    return Edit(LESS, computed(f"{text.template} {[*instead]}", words), instead)


def _is_of_products(x):
    """True of a*b - c*d."""
    return getattr(x, "op", "") == "-" and all(getattr(a, "op", "") == "*" for a in x.args)


def of_binomials(steps: Iterable[Step]) -> Iterator[Edit]:
    """The square of a sum term by term, as a^2 - b^2 for (a - b)^2, or no square; one by one and
    all at once.
    """
    squares = {s: terms_of(s.args[0]) for s in steps if s.op == "*" and s.args[0] is s.args[1]}
    squares = {s: x for s, x in squares.items() if len(x) > 1 and not repeats(s.args[0])}
    groups = [[s] for s in squares] + [[*squares]] * (len(squares) > 1)
    for group in groups:
        if not (named := typed(group[0].args[0])):
            continue
        if len(group) > 1:
            named = Words("{first} and {others}", first=named, others=LIKE_IT)
        has_minus = any(sign < 0 for s in group for sign, _ in squares[s])
        kinds = ["plus", *["none"] * (len(group) > 1), *["signs"] * has_minus]
        for kind in kinds:  # no square of a single one is a slip in the product
            instead = {s.number: _square(s, squares[s], kind) for s in group}
            words = Words(BINOMIALS[kind], sum=named)
            yield Edit(LESS, computed(f"{kind} {[*instead]}", words), instead)


def _square(s, terms, kind):
    if kind == "none":
        return s.args[0]
    signed = [(1 if kind == "plus" else sign, ("*", x, x)) for sign, x in terms]
    whole: Any = 0.0
    for sign, x in signed:
        whole = ("+" if sign > 0 else "-", whole, x)
    return whole


def _plain(x):
    """A step and its sign: the trace moves a minus sign outward."""
    return (x.args[0], -1) if isinstance(x, Step) and x.op == "neg" else (x, 1)


def _are_alike(one, other, of):
    (x, _), (y, _) = one, other
    return isinstance(y, Step) and x is not y and of(x) is not None and of(x) == of(y)


def of_distances(
    given: Mapping[str, Step], products: Iterable[Step], of: DimensionOf
) -> Iterator[Edit]:
    """Another length of the text, or half of it, for one that is computed, in one product."""
    lengths: list[tuple[str, Any]] = [(n, s) for n, s in given.items() if of(s) == LENGTH]
    lengths += [(f"{n}/2", ("*", s, 0.5)) for n, s in lengths]
    for s in products:
        parts = [x for x, n in Product(s).powers.items() if n > 0 and x.op != "argument"]
        for part in (*parts, *(x for x, op in parts_of(s, "/") if op == "/")):
            own = described(part) if of(part) == LENGTH else ""
            for name, length in lengths if own else ():
                words = Words("takes {a} for {b}: look for it in the figure", a=name, b=own)
                cause = computed(f"{name} for {part.number} in {s.number}", words)
                yield Edit(LEAST, cause, {s.number: ("*", s, ("/", length, part))})


def of_components(
    given: Mapping[str, Step], angles: Mapping[str, Step], of: DimensionOf
) -> Iterator[Edit]:
    """A component of a force, a speed or of g for the whole."""
    for name, s in given.items():
        for angle, x in angles.items() if of(s) in (FORCE, GRAVITY, SPEED) else ():
            for f in ("sin", "cos"):
                words = Words(
                    "takes the component {name}*{function}({angle}) for {name}: it counts in full",
                    name=name, function=f, angle=angle,
                )  # fmt: skip
                cause = computed(f"{f} {angle} of {name}", words)
                yield Edit(LEAST, cause, {s.number: ("*", s, (f, x))})


def of_uncancelled(
    given: Mapping[str, Step], products: Iterable[Step], needed: Mapping[str, Step], of: DimensionOf
) -> Iterator[Edit]:
    """A mass, of which no answer depends, in a product or under it."""
    masses = {n: s for n, s in given.items() if of(s) == MASS and n not in needed}
    for (name, m), s in product(masses.items(), products):
        whole = described(s, "the term")
        words = Words("has {mass} in {product}: it cancels", mass=name, product=whole)
        for op in "*/" if whole else "":
            yield Edit(LEAST, computed(f"{op} {name} in {s.number}", words), {s.number: (op, s, m)})


def of_densities(
    given: Mapping[str, Step], steps: Iterable[Step], of: DimensionOf
) -> Iterator[Edit]:
    """A density for the mass that is computed by it."""
    for name, rho in given.items():
        if of(rho) in DENSITIES:
            masses = {s for s in steps if of(s) == MASS and Product(s).powers.get(rho) == 1}
            first = [s for s in masses if not any(a in masses for a in steps_in(s))]
            words = Words(
                "takes {name} for a mass: times a length, area or volume it is one", name=name
            )
            if first:
                yield Edit(LESS, computed(f"{name} as mass", words), {s.number: rho for s in first})


def of_squares(
    products: Iterable[Step], number: Callable[[Step], Any], of: DimensionOf
) -> Iterator[Edit]:
    """A factor, or all rates, not squared in any product."""
    squared: dict[Step, list[Step]] = {}
    for s in products:
        for x, power in Product(s).powers.items():
            if power == 2:
                squared.setdefault(x, []).append(s)
    groups = [[x] for x in squared]
    groups += [[x for x in squared if of(x) == RATE]]
    for group in groups:
        lost: dict[int, Any] = {}
        for x in group:
            for s in squared[x]:
                lost[s.number] = ("/", lost.get(s.number, s), number(x))
        if len(lost) > 1 and all(named := [*map(described, group)]):
            words = Words("does not square {factors}: the formulas do", factors=joined(named))
            yield Edit(LESS, computed(f"no squares {[*lost]} {len(group)}", words), lost)


def of_other_entries(answers: Mapping[str, Traced]) -> Iterator[Edit]:
    """A term of one entry on the diagonal of a matrix in another one, where it does not stand."""
    for key, a in answers.items():
        entries = a.parts[::4] if len(a.parts) == 9 else ()
        terms = [{x for _, x in terms_of(entry) if isinstance(x, Step)} for entry in entries]
        for n, (x, own) in enumerate(zip(entries, terms, strict=True)):
            others = dict.fromkeys(y for other in terms for y in other - own if described(y))
            for y in others if isinstance(x, Step) else ():
                words = Words(
                    "adds {term} to entry {n} on the diagonal of {key}: it belongs to another one",
                    term=described(y, "the term"), n=n + 1, key=key,
                )  # fmt: skip
                cause = computed(f"more {y.number} in {x.number}", words)
                yield Edit(LEAST, cause, {x.number: ("+", x, y)})
