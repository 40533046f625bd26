"""Slips in whole quantities: one for another, twice or half of it or its opposite; another length
for a distance, a density for a mass, rates that turn the other way.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from itertools import combinations, combinations_with_replacement, product
from math import pi
from typing import Any

from newton_euler.algebra.language import Words, joined
from newton_euler.algebra.trace import Step
from newton_euler.algebra.units import Dimension, Unit
from newton_euler.answers.causes import FACTOR_2, LEFT_OUT, computed
from newton_euler.answers.near import LEAST, LESS, RARER

from .edits_of_givens import FORCE, GRAVITY, LENGTH, MASS, TIME, DimensionOf, Slip
from .edits_of_operations import PRODUCT, parts_of
from .formulas import Edit, Stage, Traced, needed, steps_in, users_of
from .typed import Product, described, repeats, terms_of

Named = tuple[str, Sequence[Any]]  # the words for a quantity, and its components
INERTIA, MOMENT = Dimension(1, 2), Dimension(1, 1)
FEW = 3  # moments of inertia: to more, no parallel-axis term is added
DENSITIES = [Dimension(1, -n) for n in (1, 2, 3)]
HALF_RIGHT = Words("takes {quantity} as 45 degrees: it follows from the text").template
OF_SQUARES = Words(
    "takes the difference of the squares for the square of {sum}: it is squared as a whole"
).template
TANGENT = Words(
    "takes {over}/{own}, a tangent, for {own} over the slant side: look at the triangle"
).template
EACH = Words("squares each term of {sum} separately: twice their product is missing").template
IN_PRODUCT = Words("takes {other} for {name} in {product}: look which of them it is").template
MEAN_RATE = Words("takes {a} over {t} for {b}: that is a mean value, it changes").template
GROWN = Words("takes {a} times {t} for {b}: it does not grow evenly").template
ANGULAR = {"sin", "cos", "tan"}
TRANSFERS = {
    "+": Words("adds {term} to a moment of inertia: it is about this axis already").template,
    "-": Words("subtracts {term} from a moment of inertia: it is about this axis already").template,
}
OTHER_POWERS = (
    ("/", LESS, Words("does not square {factors}: the formulas do")),
    ("*", LEAST, Words("takes the third power of {factors}: the formulas have the square")),
)
TIMES = (
    (-1.0, "", Words("takes {quantity} with the opposite sign: it points the other way")),
    (2.0, FACTOR_2, Words("doubles {quantity}, or has a 2 too many beside it: it counts once")),
    (0.5, FACTOR_2, Words("halves {quantity}, or lacks a factor 2 beside it: it counts in full")),
    (0.0, LEFT_OUT, Words("leaves out {quantity}: it is not zero here")),
)

OWN = Words("the part about the centre of mass").template
# the numbers of rods, and of two alike, about the middle; the same about an end
MIDDLE, END = {Fraction(1, 12), Fraction(1, 6)}, {Fraction(1, 3), Fraction(2, 3)}
OF_RODS = (
    (MIDDLE, 4.0, Words("has 1/3 for 1/12 in {part}: look up about which point it is")),
    (END, 0.25, Words("has 1/12 for 1/3 in {part}: look up about which point it is")),
)


def of_quantities(
    answers: Mapping[str, Traced], stages: Sequence[Stage], steps: Sequence[Step], of: DimensionOf
) -> Iterator[Edit]:
    """Intermediate quantities, and answers from which others are computed: one for another, twice
    or half of one, reversed, left out.
    """
    users = users_of(steps)
    named = [(s.means, [*map(_plain, s.parts)]) for s in stages if s.means]
    named += [(key, [*map(_plain, a.parts)]) for key, a in answers.items()]
    for words, parts in named:
        own = {x.number: x for x, _ in parts if isinstance(x, Step) and x.op != "argument"}
        if not any(users.get(x) for x in own.values()):
            continue
        kinds = {of(x) for x in own.values()}
        for factor, does, text in TIMES:
            if factor < 0 and kinds <= {MASS, INERTIA}:
                continue  # has no direction
            wording = Words(text.template, quantity=words)
            cause = computed(f"{factor} times {[*own]}", wording, "", does, words)
            rank = LESS if factor or words in answers else RARER
            yield Edit(rank, cause, {n: ("*", x, factor) for n, x in own.items()})
        if len(parts) == 1 and len(own) == 1 and of(parts[0][0]) == Dimension():
            text = Words("takes {quantity} as 1: it is another number here", quantity=words)
            yield Edit(LESS, computed(f"1 for {[*own]}", text), dict.fromkeys(own, 1.0))
            if {user.op for x in own.values() for user in users.get(x, ())} & ANGULAR:
                text = Words(HALF_RIGHT, quantity=words)
                yield Edit(LESS, computed(f"45 for {[*own]}", text), dict.fromkeys(own, pi / 4))
        for other, instead in named if len(own) == len(parts) else ():
            pairs = [*zip(parts, instead, strict=False)]
            if len(instead) != len(parts) or not all(_are_alike(x, y, of) for x, y in pairs):
                continue
            if {s.number for s in needed(y for y, _ in instead)} & own.keys():
                continue  # computed from what it would stand for
            text = Words("takes {other} for {own}: each has its own place", other=other, own=words)
            cause = computed(f"{other} for {[*own]}", text)
            signed = {x.number: y if s == t else ("neg", y) for (x, s), (y, t) in pairs}
            yield Edit(LESS, cause, signed)


def of_rods(stages: Sequence[Stage]) -> Iterator[Edit]:
    """Moments and products of inertia of rods about the other point, in all components at once."""
    for stage in stages:
        own = {x.number: x for x in stage.parts if isinstance(x, Step) and x.op in PRODUCT}
        numbers = {Product(x).coefficient for x in own.values()}
        for known, factor, text in OF_RODS:
            if own and {abs(n) for n in numbers} <= known:
                words = Words(text.template, part=stage.means or Words(OWN))
                cause = computed(f"{factor} times {[*own]}", words)
                yield Edit(LEAST, cause, {n: ("*", x, factor) for n, x in own.items()})


def of_shared(s: Step) -> Iterator[Slip]:
    """Twice or half of a product that several others use, as one of two equal bodies."""
    known = {*s.trace.meant, *s.trace.called}  # quantities, which are halved themselves
    is_part = any(x.number in known for x in (s, *(x for x, _ in parts_of(s, "/"))))
    named = "" if is_part or Product(s).coefficient != 1 else described(s)
    for factor, does, text in TIMES if named else ():
        if factor > 0:
            yield (
                LESS,
                f"{factor} times",
                Words(text.template, quantity=named),
                ("*", s, factor),
                does,
                named,
            )


def of_ratios(
    named: Sequence[Named],
    answers: Mapping[str, Traced],
    given: Mapping[str, Step],
    of: DimensionOf,
) -> Iterator[Edit]:
    """Answers that are one quantity times another, or over it, where the dimension allows it."""
    own = [(n, [s]) for n, s in given.items()]
    known = [(words, parts) for words, parts in (*named, *own) if all(map(_has(of), parts))]
    scalars = [(words, parts[0]) for words, parts in known if len(parts) == 1]
    for key, a in answers.items():
        pairs = (
            (x, y) for x in known for y in scalars if len(x[1]) == len(a.parts) and x[0] != y[0]
        )
        for ((first, parts), (second, factor)), (op, sign) in product(pairs, (("*", 1), ("/", -1))):
            moved = [(x, y) for x, y in zip(a.parts, parts, strict=True) if isinstance(x, Step)]
            by = of(factor)
            if by == Dimension() or (op == "*" and len(parts) == 1 and str(second) < str(first)):
                continue
            if all(x is not y and of(x) == _times(of(y), by, sign) for x, y in moved):
                words = Words("takes {a} {op} {b} for {key}: look up what {key} stands for",
                              a=first, op=op, b=second, key=key)  # fmt: skip
                instead = {x.number: (op, y, factor) for x, y in moved}
                yield Edit(LEAST + 1, computed(f"{first} {op} {second} for {key}", words), instead)


def of_mean_rates(
    named: Sequence[Named], given: Mapping[str, Step], of: DimensionOf
) -> Iterator[Edit]:
    """A quantity over the time that it takes, for a rate on the way; a rate of it times this time,
    for what it grows to.
    """
    scalars = [(words, parts[0]) for words, parts in named if len(parts) == 1]
    known = [(words, x) for words, x in scalars if _has(of)(x) and x.op != "argument"]
    times = [(n, s) for n, s in given.items() if of(s) == TIME]
    for (a, x), (b, y), (t, time) in product(known, known, times):
        for op, sign, text in ("/", -1, MEAN_RATE), ("*", 1, GROWN):
            is_first = op == "/" or all(s is not y for s in needed([x]))
            if x is not y and is_first and of(y) == _times(of(x), TIME, sign):
                words = Words(text, a=a, t=t, b=b)
                cause = computed(f"{x.number} {op} {t} for {y.number}", words)
                yield Edit(LEAST, cause, {y.number: (op, x, time)})


def _has(of):
    return lambda x: isinstance(x, Step) and of(x) is not None


def _times(a, b, sign):
    return a * b if sign > 0 else a / b


def of_cross_products(named: Iterable[Named]) -> Iterator[Edit]:
    """Cross products, whose components are differences of two products: the products added, or the
    middle component reversed.
    """
    for words, parts in named:
        if len(parts) != 3 or not all(isinstance(x, Step) and x.op == "-" for x in parts):
            continue
        added = Words("adds the two products in each component of {quantity}: they are subtracted",
                      quantity=words)  # fmt: skip
        middle = Words("has the second component of {quantity} with the opposite sign: "
                       "a determinant alternates", quantity=words)  # fmt: skip
        name, y = [x.number for x in parts], parts[1]
        yield Edit(
            LESS, computed(f"added {name}", added), {x.number: ("+", *x.args) for x in parts}
        )
        yield Edit(LESS, computed(f"middle {name}", middle), {y.number: ("neg", y)})
        products = [x.args[0] for x in parts]
        if all(isinstance(x, Step) and x.op == "*" for x in products):
            (a2, b3), (a3, b1), (a1, b2) = (x.args for x in products)
            pairs = zip(parts, (a1, a2, a3), (b1, b2, b3), strict=True)
            alone = Words("multiplies the components of {quantity} in pairs: "
                          "a cross product is a vector of differences", quantity=words)  # fmt: skip
            instead = {x.number: ("*", a, b) for x, a, b in pairs}
            yield Edit(LESS, computed(f"pairs {name}", alone), instead)


def of_sums_squared(steps: Iterable[Step], products: Iterable[Step]) -> Iterator[Edit]:
    """The square of a sum, or of a quotient by one, taken term by term; also where the two factors
    are apart, as in omega_z*(I_z*omega_z).
    """
    squares_alone = [*filter(_is_square, steps)]
    for s in products:
        for x, power in Product(s).powers.items():
            is_apart = power == 2 and all(x is not own.args[0] for own in squares_alone)
            named = described(x) if is_apart and len(terms_of(x)) > 1 and not repeats(x) else ""
            if named:
                each = reduce(lambda a, b: ("+", a, b), [("*", t, t) for _, t in terms_of(x)])
                cause = computed(f"squares in {s.number} of {x.number}", Words(EACH, sum=named))
                yield Edit(LESS, cause, {s.number: ("/", ("*", s, each), ("*", x, x))})
    for s in squares_alone:
        (x, _) = s.args
        is_below = isinstance(x, Step) and x.op == "/"
        whole = x.args[1] if is_below else x
        named = described(whole) if len(terms_of(whole)) > 1 and not repeats(whole) else ""
        if named:
            squares: list[Any] = [("*", term, term) for _, term in terms_of(whole)]
            words = Words(EACH, sum=named)
            total = reduce(lambda a, b: ("+", a, b), squares)
            changed = ("*", s, ("/", ("*", whole, whole), total)) if is_below else total
            yield Edit(LESS, computed(f"squares in {s.number}", words), {s.number: changed})
            if {sign for sign, _ in terms_of(whole)} == {1, -1} and not is_below:
                words = Words(OF_SQUARES, sum=named)
                squares = [("*", ("*", float(sign), t), t) for sign, t in terms_of(whole)]
                total = reduce(lambda a, b: ("+", a, b), squares)
                cause = computed(f"difference of squares in {s.number}", words)
                yield Edit(LESS, cause, {s.number: total})


def of_slopes(steps: Iterable[Step]) -> Iterator[Edit]:
    """The tangent of an angle for a leg of its right triangle over the slant side."""
    for s in steps:
        own, slant = s.args if s.op == "/" else (None, None)
        inside = slant.args[0] if isinstance(slant, Step) and slant.op == "sqrt" else None
        legs = terms_of(inside) if isinstance(inside, Step) else []
        if len(legs) == 2 and all(sign > 0 and _is_square(leg) for sign, leg in legs):
            a, b = (leg.args[0] for _, leg in legs)
            other = b if own is a else a if own is b else None
            one, over = described(own), described(other)
            if one and over:
                words = Words(TANGENT, own=one, over=over)
                yield Edit(
                    LESS, computed(f"slope {s.number}", words), {s.number: ("/", other, own)}
                )


def of_differences_of_squares(steps: Iterable[Step]) -> Iterator[Edit]:
    """The square of a difference for the difference of two squares, as m*(a - b)^2 for
    m*a^2 - m*b^2; that of a sum for a sum.
    """
    for s in steps:
        terms = terms_of(s) if s.op in ("+", "-") else []
        for (m, x), (n, y) in combinations(terms, 2):
            pair = _unlike(x, y)
            if not pair:
                continue
            a, b = pair
            whole = ("+" if m == n else "-", a, b)
            words = Words("squares the difference: the difference of the squares belongs there")
            if m == n:
                words = Words("squares the sum: the sum of the squares belongs there")
            square = ("*", ("/", ("/", x, a), a), ("*", whole, whole))
            rest = ("-", ("-", s, ("*", float(m), x)), ("*", float(n), y))
            instead = {s.number: ("+", rest, ("*", float(m), square))}
            name = f"square of {x.number} {y.number} in {s.number}"
            yield Edit(LESS, computed(name, words), instead)


def _unlike(x, y):
    """The steps whose squares alone tell two products apart, as a and b of m*a^2 and m*b^2."""
    if _is_square(x) and _is_square(y):
        return x.args[0], y.args[0]
    one, other = Product(x), Product(y)
    if not (one.is_exact and other.is_exact and one.coefficient == other.coefficient):
        return ()
    own, others = (
        one.powers.items() - other.powers.items(),
        other.powers.items() - one.powers.items(),
    )
    if [power for _, power in (*own, *others)] != [2, 2] or len(own) != 1:
        return ()
    return tuple(s for s, _ in (*own, *others))


def _is_square(x):
    return isinstance(x, Step) and x.op == "*" and x.args[0] is x.args[1]


def _plain(x):
    """A step and its sign: the trace moves a minus sign outward."""
    return (x.args[0], -1) if isinstance(x, Step) and x.op == "neg" else (x, 1)


def _are_alike(one, other, of):
    (x, _), (y, _) = one, other
    return isinstance(y, Step) and x is not y and of(x) is not None and of(x) == of(y)


def of_distances(
    given: Mapping[str, Step], products: Iterable[Step], of: DimensionOf
) -> Iterator[Edit]:
    """A length of the text, or half of it, in place of a computed one, in one product."""
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


def of_givens_in_products(
    products: Iterable[Step], read: Mapping[str, Unit], given: Mapping[str, Step]
) -> Iterator[Edit]:
    """A given of the same unit for another in one product, as another radius in omega*r."""
    powers = {s: Product(s).powers for s in products}
    used = Counter(x for own in powers.values() for x in own if x.op == "argument")
    for s, own in powers.items():
        whole = described(s)
        for x, power in own.items() if whole else ():
            name = x.args[0] if x.op == "argument" and used[x] > 1 else ""
            for other, step in given.items() if name and abs(power) <= 2 else ():
                if other != name and read[other].text == read[name].text:
                    words = Words(IN_PRODUCT, other=other, name=name, product=whole)
                    ratio = ("**", ("/", step, x), float(power))
                    cause = computed(f"{other} for {name} in {s.number}", words)
                    yield Edit(LEAST + 2, cause, {s.number: ("*", s, ratio)})


def of_densities(
    given: Mapping[str, Step], steps: Iterable[Step], of: DimensionOf
) -> Iterator[Edit]:
    """A density in place of the mass that is computed from it."""
    for name, rho in given.items():
        if of(rho) in DENSITIES:
            masses = {s for s in steps if of(s) == MASS and Product(s).powers.get(rho) == 1}
            first = [s for s in masses if not any(a in masses for a in steps_in(s))]
            words = Words(
                "takes {name} for a mass: multiply it by the length, area or volume", name=name
            )
            if first:
                yield Edit(LESS, computed(f"{name} as mass", words), {s.number: rho for s in first})


def of_areas(
    answers: Mapping[str, Traced], given: Mapping[str, Step], steps: Iterable[Step], of: DimensionOf
) -> Iterator[Edit]:
    """Answers without the mass per length, area or volume: those of a line, an area, a volume.
    A given mass may be spread over a given length, a rectangle, a triangle.
    """
    words = Words(
        "leaves out the mass per length, area or volume: the moments of the mass are asked for"
    )
    parts = [x for a in answers.values() for x in a.parts if isinstance(x, Step)]
    parts = [x for x in parts if of(x) in (INERTIA, MOMENT)]
    found: list[Any] = [s for s in steps if of(s) in DENSITIES and s.op != "argument"]
    masses, lengths = ([s for s in given.values() if of(s) == kind] for kind in (MASS, LENGTH))
    for m in masses if len(masses) == 1 else ():
        found += [("/", m, d) for d in lengths]
        areas = [("*", a, b) for a, b in combinations_with_replacement(lengths, 2)]
        found += [("/", ("/", m, area), share) for area in areas for share in (1.0, 0.5)]
    for n, rho in enumerate(found if parts else ()):
        instead = {x.number: ("/", x, rho) for x in parts}
        yield Edit(LESS, computed(f"areas {n}", words), instead)


def of_transfers(
    given: Mapping[str, Step], steps: Iterable[Step], of: DimensionOf
) -> Iterator[Edit]:
    """A parallel-axis term added to a moment of inertia, or taken off, where none belongs: of a
    given mass, or of a weight, and a given length, or half of it.
    """
    masses = [s for s in steps if of(s) == MASS]
    moments = {s for s in steps if of(s) == INERTIA}
    first = [s for s in moments if not any(a in moments for a in steps_in(s))]
    lengths = [(n, s) for n, s in given.items() if of(s) == LENGTH]
    some = first if len(first) <= FEW else ()  # of many bodies, a setup shows the place of each
    for I, m, (name, d) in product(some, masses, lengths):
        m_d = described(m)
        for text, factor in (
            ((f"{m_d}*{name}^2", 1.0), (f"{m_d}*({name}/2)^2", 0.25)) if m_d else ()
        ):
            term = ("*", ("*", ("*", m, d), d), factor)
            for op, words in TRANSFERS.items():
                cause = computed(f"{op} {text} {I.number}", Words(words, term=text))
                yield Edit(LEAST, cause, {I.number: (op, I, term)})


def of_masses(
    steps: Iterable[Step], number: Callable[[Step], Any], of: DimensionOf
) -> Iterator[Edit]:
    """The weights of all bodies in place of their masses, as W for W/g."""
    masses = [s for s in steps if s.op == "/" and [*map(of, s.args)] == [FORCE, GRAVITY]]
    if len(masses) > 1:
        words = Words("takes the weights for masses: a mass is a weight over g")
        instead = {s.number: ("*", s, number(s.args[1])) for s in masses}
        yield Edit(RARER, computed("weights as masses", words), instead)


def of_squares(
    products: Iterable[Step], number: Callable[[Step], Any], of: DimensionOf
) -> Iterator[Edit]:
    """A factor, or all of one dimension, not squared in any product, or in its third power."""
    squared: dict[Step, list[Step]] = {}
    for s in products:
        inside = {part for part, _ in parts_of(s, "/")}
        for x, power in Product(s).powers.items():
            known = squared.setdefault(x, [])
            if power == 2 and not inside & {*known}:  # or else it is the same square
                known.append(s)
    squared = {x: products for x, products in squared.items() if products}
    kinds = {of(x) for x in squared} - {None}
    groups = [[x] for x in squared]
    groups += [[x for x in squared if of(x) == kind] for kind in sorted(kinds, key=str)]
    for group, (op, rank, words) in product(groups, OTHER_POWERS):
        changed: dict[int, Any] = {}
        for x in group:
            for s in squared[x]:
                changed[s.number] = (op, changed.get(s.number, s), number(x))
        if len(changed) > 1 and all(named := [*map(described, group)]):
            text = Words(words.template, factors=joined(named))
            yield Edit(rank, computed(f"squares {op} {[*changed]} {len(group)}", text), changed)
