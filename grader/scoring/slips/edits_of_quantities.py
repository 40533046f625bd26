"""Slips in whole quantities: one for another, twice or half of it or its opposite; another length
for a distance, a density for a mass, rates that turn the other way.
"""

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, combinations_with_replacement, product
from math import pi
from typing import Any

from newton_euler.algebra.language import Words, joined
from newton_euler.algebra.trace import Step
from newton_euler.algebra.units import Dimension
from newton_euler.answers.causes import FACTOR_2, LEFT_OUT
from newton_euler.answers.near import LEAST, LESS, RARER

from .edits_of_givens import Slip
from .edits_of_operations import parts_of
from .facts import FORCE, GRAVITY, INERTIA, LENGTH, MASS, NUMBER, TIME, Facts
from .formulas import PRODUCT, SUM, Edit, edit, steps_in, steps_needed, total
from .typed import Product, described, repeats, terms_of

MOMENT = Dimension(1, 1)
FEW = 3  # moments of inertia: to more, no parallel-axis term is added
DENSITIES = [Dimension(1, -n) for n in (1, 2, 3)]
HALF_RIGHT = Words("takes {quantity} as 45 degrees: it follows from the text")
OF_SQUARES = Words(
    "takes the difference of the squares for the square of {sum}: it is squared as a whole"
)
TANGENT = Words(
    "takes {over}/{own}, a tangent, for {own} over the slant side: look at the triangle"
)
EACH = Words("squares each term of {sum} separately: twice their product is missing")
IN_PRODUCT = Words("takes {other} for {name} in {product}: check which of them it is")
OF_TWO = Words("takes {a} {op} {b} for {key}: look up what {key} stands for")
ADDED = Words("adds the two products in each component of {quantity}: they are subtracted")
MIDDLE_TURNED = Words(
    "has the second component of {quantity} with the opposite sign: a determinant alternates"
)
IN_PAIRS = Words(
    "multiplies the components of {quantity} in pairs: a cross product is a vector of differences"
)
WHOLE_SQUARED = (
    Words("squares the difference: the difference of the squares belongs there"),
    Words("squares the sum: the sum of the squares belongs there"),
)
AS_MASS = Words("takes {name} for a mass: multiply it by the length, area or volume")
WITHOUT_MASS = Words(
    "leaves out the mass per length, area or volume: the moments of the mass are asked for"
)
WEIGHTS = Words("takes the weights for masses: a mass is a weight over g")
MEAN_RATE = Words("takes {a} over {t} for {b}: that is its mean value, and it changes")
GROWN = Words("takes {a} times {t} for {b}: it does not grow evenly")
ANGULAR = {"sin", "cos", "tan"}
TRANSFERS = {
    "+": Words("adds {term} to a moment of inertia: it is about this axis already"),
    "-": Words("subtracts {term} from a moment of inertia: it is about this axis already"),
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

# the numbers of rods, and of two alike, about the middle; the same about an end
MIDDLE, END = {Fraction(1, 12), Fraction(1, 6)}, {Fraction(1, 3), Fraction(2, 3)}
OF_RODS = (
    (MIDDLE, 4.0, Words("has 1/3 for 1/12 in {part}: look up which point it is about")),
    (END, 0.25, Words("has 1/12 for 1/3 in {part}: look up which point it is about")),
)


def of_quantities(f: Facts) -> Iterator[Edit]:
    """Intermediate quantities, and answers from which others are computed: one for another, twice
    or half of one, reversed, left out.
    """
    named = [(words, [*map(_plain, parts)]) for words, parts in f.named]
    for words, parts in named:
        own = {x.number: x for x, _ in parts if isinstance(x, Step) and x.op != "argument"}
        if not any(f.users.get(x) for x in own.values()):
            continue
        kinds = {f.of(x) for x in own.values()}
        for factor, does, text in TIMES:
            if factor < 0 and kinds <= {MASS, INERTIA}:
                continue  # a scalar without direction
            rank = LESS if factor or words in f.answers else RARER
            why, instead = Words(text, quantity=words), _times_factor(own, factor)
            yield edit(rank, f"{factor} times {[*own]}", why, instead, does, words)
        if len(parts) == 1 and len(own) == 1 and f.of(parts[0][0]) == NUMBER:
            why = Words("takes {quantity} as 1: it is another number here", quantity=words)
            yield edit(LESS, f"1 for {[*own]}", why, dict.fromkeys(own, 1.0))
            if {user.op for x in own.values() for user in f.users.get(x, ())} & ANGULAR:
                why = Words(HALF_RIGHT, quantity=words)
                yield edit(LESS, f"45 for {[*own]}", why, dict.fromkeys(own, pi / 4))
        for other, instead in named if len(own) == len(parts) else ():
            pairs = [*zip(parts, instead, strict=False)]
            if len(instead) != len(parts) or not all(_are_alike(x, y, f.of) for x, y in pairs):
                continue
            if {s.number for s in steps_needed(y for y, _ in instead)} & own.keys():
                continue  # it is computed from the other one
            why = Words("takes {other} for {own}: each has its own place", other=other, own=words)
            signed = {x.number: y if s == t else ("neg", y) for (x, s), (y, t) in pairs}
            yield edit(LESS, f"{other} for {[*own]}", why, signed)


def _times_factor(own, factor):
    return {n: ("*", x, factor) for n, x in own.items()}


def of_rods(f: Facts) -> Iterator[Edit]:
    """Moments and products of inertia of rods about the other point, in all components at once."""
    for stage in f.stages:
        own = {x.number: x for x in stage.parts if isinstance(x, Step) and x.op in PRODUCT}
        numbers = {abs(Product(x).coefficient) for x in own.values()}
        for known, factor, text in OF_RODS:
            if own and numbers <= known:
                words = Words(text, part=stage.means or Words("the part about the centre of mass"))
                name = f"{factor} times {[*own]}"
                yield edit(LEAST, name, words, _times_factor(own, factor))


def of_shared(s: Step) -> Iterator[Slip]:
    """Twice or half of a product that several others use, as one of two equal bodies."""
    known = {*s.trace.meant, *s.trace.called}  # quantities, which are halved themselves
    is_part = any(x.number in known for x in (s, *(x for x, _ in parts_of(s, "/"))))
    named = "" if is_part or Product(s).coefficient != 1 else described(s)
    for factor, does, text in TIMES if named else ():
        if factor > 0:
            words = Words(text, quantity=named)
            yield LESS, f"{factor} times", words, ("*", s, factor), does, named


def of_ratios(f: Facts) -> Iterator[Edit]:
    """Answers that are one quantity times another, or over it, where the dimension allows it."""
    own = [(n, [s]) for n, s in f.given.items()]
    known = [(words, parts) for words, parts in (*f.named, *own) if all(map(f.is_known, parts))]
    scalars = [(words, parts[0]) for words, parts in known if len(parts) == 1]
    for key, a in f.answers.items():
        pairs = (
            (x, y) for x in known for y in scalars if len(x[1]) == len(a.parts) and x[0] != y[0]
        )
        for ((first, parts), (second, factor)), (op, sign) in product(pairs, (("*", 1), ("/", -1))):
            moved = [(x, y) for x, y in zip(a.parts, parts, strict=True) if isinstance(x, Step)]
            by = f.of(factor)
            if by == NUMBER or (op == "*" and len(parts) == 1 and str(second) < str(first)):
                continue
            if all(x is not y and f.of(x) == _times(f.of(y), by, sign) for x, y in moved):
                words = Words(OF_TWO, a=first, op=op, b=second, key=key)
                instead = {x.number: (op, y, factor) for x, y in moved}
                yield edit(LEAST + 1, f"{first} {op} {second} for {key}", words, instead)


def of_mean_rates(f: Facts) -> Iterator[Edit]:
    """A quantity over the time that it takes, for a rate on the way; a rate of it times this time,
    for what it grows to.
    """
    scalars = [(words, parts[0]) for words, parts in f.named if len(parts) == 1]
    known = [(words, x) for words, x in scalars if f.is_known(x) and x.op != "argument"]
    times = [(n, s) for n, s in f.given.items() if f.of(s) == TIME]
    for (a, x), (b, y), (t, time) in product(known, known, times):
        for op, sign, text in ("/", -1, MEAN_RATE), ("*", 1, GROWN):
            is_first = op == "/" or all(s is not y for s in steps_needed([x]))
            if x is not y and is_first and f.of(y) == _times(f.of(x), TIME, sign):
                words, name = Words(text, a=a, t=t, b=b), f"{x.number} {op} {t} for {y.number}"
                yield edit(LEAST, name, words, {y.number: (op, x, time)})


def _times(a, b, sign):
    return a * b if sign > 0 else a / b


def of_cross_products(f: Facts) -> Iterator[Edit]:
    """Cross products, whose components are differences of two products: the products added, or the
    middle component reversed.
    """
    for words, parts in f.vectors:
        if not all(isinstance(x, Step) and x.op == "-" for x in parts):
            continue
        name, y = [x.number for x in parts], parts[1]
        added = {x.number: ("+", *x.args) for x in parts}
        yield edit(LESS, f"added {name}", Words(ADDED, quantity=words), added)
        middle = Words(MIDDLE_TURNED, quantity=words)
        yield edit(LESS, f"middle {name}", middle, {y.number: ("neg", y)})
        products = [x.args[0] for x in parts]
        if all(isinstance(x, Step) and x.op == "*" for x in products):
            (a2, b3), (a3, b1), (a1, b2) = (x.args for x in products)
            pairs = zip(parts, (a1, a2, a3), (b1, b2, b3), strict=True)
            instead = {x.number: ("*", a, b) for x, a, b in pairs}
            yield edit(LESS, f"pairs {name}", Words(IN_PAIRS, quantity=words), instead)


def of_sums_squared(f: Facts) -> Iterator[Edit]:
    """The square of a sum, or of a quotient by one, taken term by term; also where the two factors
    are apart, as in omega_z*(I_z*omega_z).
    """
    squares_alone = [*filter(_is_square, f.steps)]
    for s in f.products:
        for x, power in Product(s).powers.items():
            is_apart = power == 2 and all(x is not own.args[0] for own in squares_alone)
            if named := _sum_in_words(x) if is_apart else "":
                apart = ("/", ("*", s, _each_squared(x)), ("*", x, x))
                name = f"squares in {s.number} of {x.number}"
                yield edit(LESS, name, Words(EACH, sum=named), {s.number: apart})
    for s in squares_alone:
        (x, _) = s.args
        is_below = isinstance(x, Step) and x.op == "/"
        whole = x.args[1] if is_below else x
        if named := _sum_in_words(whole):
            each: Any = _each_squared(whole)
            each = ("*", s, ("/", ("*", whole, whole), each)) if is_below else each
            yield edit(LESS, f"squares in {s.number}", Words(EACH, sum=named), {s.number: each})
            if {sign for sign, _ in terms_of(whole)} == {1, -1} and not is_below:
                words = Words(OF_SQUARES, sum=named)
                squares = total(("*", ("*", float(n), t), t) for n, t in terms_of(whole))
                name = f"difference of squares in {s.number}"
                yield edit(LESS, name, words, {s.number: squares})


def _sum_in_words(x):
    """A sum in words; "" for another expression, and for a sum that a student would not write."""
    return described(x) if len(terms_of(x)) > 1 and not repeats(x) else ""


def _each_squared(x):
    return total(("*", term, term) for _, term in terms_of(x))


def of_slopes(f: Facts) -> Iterator[Edit]:
    """The tangent of an angle for a leg of its right triangle over the slant side."""
    for s in f.steps:
        own, slant = s.args if s.op == "/" else (None, None)
        inside = slant.args[0] if isinstance(slant, Step) and slant.op == "sqrt" else None
        legs = terms_of(inside) if isinstance(inside, Step) else []
        if len(legs) == 2 and all(sign > 0 and _is_square(leg) for sign, leg in legs):
            a, b = (leg.args[0] for _, leg in legs)
            other = b if own is a else a if own is b else None
            one, over = described(own), described(other)
            if one and over:
                words = Words(TANGENT, own=one, over=over)
                yield edit(LESS, f"slope {s.number}", words, {s.number: ("/", other, own)})


def of_differences_of_squares(f: Facts) -> Iterator[Edit]:
    """The square of a difference for the difference of two squares, as m*(a - b)^2 for
    m*a^2 - m*b^2; that of a sum for a sum.
    """
    for s in f.steps:
        terms = terms_of(s) if s.op in SUM else []
        for (m, x), (n, y) in combinations(terms, 2):
            pair = _unlike(x, y)
            if not pair:
                continue
            a, b = pair
            whole = ("+" if m == n else "-", a, b)
            square = ("*", ("/", ("/", x, a), a), ("*", whole, whole))
            rest = ("-", ("-", s, ("*", float(m), x)), ("*", float(n), y))
            instead = {s.number: ("+", rest, ("*", float(m), square))}
            name = f"square of {x.number} {y.number} in {s.number}"
            yield edit(LESS, name, WHOLE_SQUARED[m == n], instead)


def _unlike(x, y):
    """The steps whose squares alone tell two products apart, as a and b of m*a^2 and m*b^2."""
    if _is_square(x) and _is_square(y):
        return x.args[0], y.args[0]
    one, other = Product(x), Product(y)
    if not (one.is_exact and other.is_exact and one.coefficient == other.coefficient):
        return ()
    a, b = one.powers.items(), other.powers.items()
    own, others = a - b, b - a
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


def of_distances(f: Facts) -> Iterator[Edit]:
    """A length of the text, or half of it, in place of a computed one, in one product."""
    lengths: list[tuple[str, Any]] = [(n, s) for n, s in f.given.items() if f.of(s) == LENGTH]
    lengths += [(f"{n}/2", ("*", s, 0.5)) for n, s in lengths]
    for s in f.products:
        parts = [x for x, n in Product(s).powers.items() if n > 0 and x.op != "argument"]
        for part in (*parts, *(x for x, op in parts_of(s, "/") if op == "/")):
            own = described(part) if f.of(part) == LENGTH else ""
            for name, length in lengths if own else ():
                words = Words("takes {a} for {b}: look for it in the figure", a=name, b=own)
                instead = {s.number: ("*", s, ("/", length, part))}
                yield edit(LEAST, f"{name} for {part.number} in {s.number}", words, instead)


def of_givens_in_products(f: Facts) -> Iterator[Edit]:
    """A given of the same unit for another in one product, as another radius in omega*r."""
    powers = {s: Product(s).powers for s in f.products}
    used = Counter(x for own in powers.values() for x in own if x.op == "argument")
    for s, own in powers.items():
        whole = described(s)
        for x, power in own.items() if whole else ():
            name = x.args[0] if x.op == "argument" and used[x] > 1 else ""
            for other, step in f.given.items() if name and abs(power) <= 2 else ():
                if other != name and f.read[other].text == f.read[name].text:
                    words = Words(IN_PRODUCT, other=other, name=name, product=whole)
                    instead = {s.number: ("*", s, ("**", ("/", step, x), float(power)))}
                    yield edit(LEAST + 2, f"{other} for {name} in {s.number}", words, instead)


def of_densities(f: Facts) -> Iterator[Edit]:
    """A density in place of the mass that is computed from it."""
    for name, rho in f.given.items():
        if f.of(rho) in DENSITIES:
            masses = {s for s in f.steps if f.of(s) == MASS and Product(s).powers.get(rho) == 1}
            first = {s.number: rho for s in masses if masses.isdisjoint(steps_in(s))}
            if first:
                yield edit(LESS, f"{name} as mass", Words(AS_MASS, name=name), first)


def of_areas(f: Facts) -> Iterator[Edit]:
    """Answers without the mass per length, area or volume: those of a line, an area, a volume.
    A given mass may be spread over a given length, a rectangle, a triangle.
    """
    parts = [x for a in f.answers.values() for x in a.parts if isinstance(x, Step)]
    parts = [x for x in parts if f.of(x) in (INERTIA, MOMENT)]
    found: list[Any] = [s for s in f.steps if f.of(s) in DENSITIES and s.op != "argument"]
    masses, lengths = ([s for s in f.given.values() if f.of(s) == x] for x in (MASS, LENGTH))
    for m in masses if len(masses) == 1 else ():
        found += [("/", m, d) for d in lengths]
        areas = [("*", a, b) for a, b in combinations_with_replacement(lengths, 2)]
        found += [("/", ("/", m, area), share) for area in areas for share in (1.0, 0.5)]
    for n, rho in enumerate(found if parts else ()):
        yield edit(LESS, f"areas {n}", WITHOUT_MASS, {x.number: ("/", x, rho) for x in parts})


def of_transfers(f: Facts) -> Iterator[Edit]:
    """A parallel-axis term added to a moment of inertia, or taken off, where none belongs: of a
    given mass, or of a weight, and a given length, or half of it.
    """
    masses = [(described(s), s) for s in f.steps if f.of(s) == MASS]
    moments = dict.fromkeys(s for s in f.steps if f.of(s) == INERTIA)
    first = [s for s in moments if moments.keys().isdisjoint(steps_in(s))]
    lengths = [(n, s) for n, s in f.given.items() if f.of(s) == LENGTH]
    some = first if len(first) <= FEW else ()  # with many bodies, the setup shows the place of each
    for I, (mass, m), (name, d) in product(some, masses, lengths):
        for text, factor in (f"{mass}*{name}^2", 1.0), (f"{mass}*({name}/2)^2", 0.25):
            term = ("*", ("*", ("*", m, d), d), factor)
            for op, words in TRANSFERS.items() if mass else ():
                instead = {I.number: (op, I, term)}
                yield edit(LEAST, f"{op} {text} {I.number}", Words(words, term=text), instead)


def of_masses(f: Facts) -> Iterator[Edit]:
    """The weights of all bodies in place of their masses, as W for W/g."""
    masses = [s for s in f.steps if s.op == "/" and [*map(f.of, s.args)] == [FORCE, GRAVITY]]
    if len(masses) > 1:
        instead = {s.number: ("*", s, f.number(s.args[1])) for s in masses}
        yield edit(RARER, "weights as masses", WEIGHTS, instead)


def of_squares(f: Facts) -> Iterator[Edit]:
    """A factor, or all of one dimension, not squared in any product, or in its third power."""
    squared: dict[Step, list[Step]] = {}
    for s in f.products:
        inside = {part for part, _ in parts_of(s, "/")}
        for x, power in Product(s).powers.items():
            known = squared.setdefault(x, [])
            if power == 2 and not inside & {*known}:  # or else it is the same square
                known.append(s)
    squared = {x: products for x, products in squared.items() if products}
    kinds = {f.of(x) for x in squared} - {None}
    groups = [[x] for x in squared]
    groups += [[x for x in squared if f.of(x) == kind] for kind in sorted(kinds, key=str)]
    for group, (op, rank, words) in product(groups, OTHER_POWERS):
        changed: dict[int, Any] = {}
        for x in group:
            for s in squared[x]:
                changed[s.number] = (op, changed.get(s.number, s), f.number(x))
        if len(changed) > 1 and all(named := [*map(described, group)]):
            text = Words(words, factors=joined(named))
            yield edit(rank, f"squares {op} {[*changed]} {len(group)}", text, changed)
