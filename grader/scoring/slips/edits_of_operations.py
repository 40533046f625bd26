"""Slips in single operations: a sign, a term, a factor, a square, sine for cosine. Each is (rank,
kind, words, replacement), and of terms what it does, and to which.
"""

from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import product as signs_of
from math import pi
from typing import Any

from newton_euler.algebra.language import Words, joined
from newton_euler.algebra.trace import Step
from newton_euler.algebra.units import Dimension
from newton_euler.answers.causes import LEFT_OUT, RESCALED, REVERSED, UNNAMED, computed
from newton_euler.answers.near import LEAST, LESS, RARER, SIMPLE
from newton_euler.answers.usual import MOMENTS as BODIES

from .edits_of_givens import NO_FIT, NOT_ONE, Slip
from .edits_of_groups import neighbours
from .facts import AREA, ENERGY, INERTIA, LENGTH, NUMBER, Facts
from .formulas import PRODUCT, SUM, Edit, edit, multiplied, steps_needed, total
from .typed import Product, described, is_given, is_nothing, typed, without_zeros

COFUNCTIONS = {"sin": "cos", "cos": "sin", "asin": "acos", "acos": "asin"}
TANGENTS = {"sin": "tan", "cos": "tan", "asin": "atan", "acos": "atan"}
SINES = {"asin": Words("sine"), "acos": Words("cosine"), "atan": Words("tangent")}
FACTOR = Words("takes the factor {other} for {own}{of}: the formula has {own}")
LEAVES_OUT = Words("leaves out {factor}{of}: {why}")
CANCELS = Words("has {name} left in one place: it cancels from every term")
DIVIDED = Words("divides by {name} once too often: put your units into the whole formula")
RATIOS = {
    -1: Words("inverts {ratio}{of}: it is the other way round"),
    1: Words("does not square {ratio}{of}: the formula does"),
    3: Words("takes the third power of {ratio}{of}: the formula has the square"),
}
ALL_AXES = Words("measures all angles from the other axis: sines and cosines are exchanged")
OTHER_AXIS = Words("measures {angle} from the other axis: sine and cosine are exchanged")
SMALL_ANGLE = Words("uses the small-angle approximation for {angle}: it is not small")
SUBTRACTED = Words("one of the two terms there is subtracted")
ADDED = Words("both terms there are added")
TURNED_TERM = Words("has {term} with the opposite sign: {why}")
OTHER_NUMBER = Words("takes {other} for {term}: look up the number")
SCALED = (
    (2.0, "doubles", Words("doubles {term}: it counts once")),
    (0.5, "halves", Words("halves {term}: it counts in full")),
)
RODS = {Fraction(1, 3), Fraction(1, 12)}  # l^2/12 may stand in a sum, without its mass
CONE = Fraction(3, 10)  # a wrong number for it is a slip; it is not one for another number


def of_operation(s: Step, number: Callable[[Step], Any]) -> Iterator[Slip]:
    """The slips in one operation other than a product; ``number`` of a step, in a student's
    units.
    """
    if s.op == "sqrt":
        inside = typed(s.args[0]) or Words("a sum")
        words = Words("leaves out the square root of {sum}: this is still the square", sum=inside)
        yield SIMPLE, "root", words, ("*", s, number(s))
    if s.op in _OF:
        yield from _OF[s.op](s)


def _of_sum(s):
    a, b = s.args
    minus = s.op == "-"
    if without_zeros(s) is not s or is_nothing(s):
        return  # a term, or the whole, is zero for every student
    for term, left, turned in (
        (a, ("neg", b) if minus else b, ("neg", ("+", a, b)) if minus else ("-", b, a)),
        (b, a, ("+" if minus else "-", a, b)),
    ):
        several = isinstance(term, Step) and term.op in SUM
        rank, name = LESS if several else SIMPLE, _term(term, s)
        what, varies = name or UNNAMED, is_given(term)
        if a is not b:  # if one of two equal terms is reversed, nothing is left
            words = Words(TURNED_TERM, term=what, why=SUBTRACTED if minus else ADDED)
            yield rank if varies else LESS, "sign", words, turned, REVERSED, name
        words = Words("leaves out {term}: it is not zero here", term=what)
        yield rank, "term", words, left, LEFT_OUT, name

        def scaled(factor, term=term):
            return s.op, *(("*", x, factor) if x is term else x for x in (a, b))

        for factor, kind, text in SCALED if varies and not several else ():
            yield LESS, kind, Words(text, term=what), scaled(factor), RESCALED, name
        is_number = not isinstance(term, Step) and abs(term) not in (0, 1)
        for factor in (4, 2, 0.5, 0.25) if is_number else ():
            words = Words(OTHER_NUMBER, other=f"{factor * term:g}", term=what)
            yield LEAST, f"{factor} times", words, scaled(factor)


def _term(term, whole):
    if not isinstance(term, Step):
        around = typed(whole)
        if around:
            return Words("the {number} of {sum}", number=f"{term:g}", sum=around)
        return Words("the constant term of a sum")
    return described(term, "the term")


def of_product(
    s: Step, number: Callable[[Step], Any], dimension: Callable[[Step], Dimension | None]
) -> Iterator[Slip]:
    """The slips in a product with all its factors; ``number`` of a factor, in a student's units."""

    def why(factor):
        return NO_FIT if dimension(factor) not in (None, NUMBER) else NOT_ONE

    product, whole, of = Product(s), typed(s), _of_whole(s)
    for factor, power in product.powers.items():
        if described(factor):
            yield from of_factor(s, factor, power, number(factor), why(factor))
    for x in product.cancelled:
        is_left = x.op == "argument" and x not in product.powers
        for op, words in zip("*/", (CANCELS, DIVIDED), strict=True) if is_left else ():
            yield LEAST, f"left {x.number} {op}", Words(words, name=x.args[0]), (op, s, number(x))
    parts = [(part, op, 1) for part, op in parts_of(s, "/")]
    if s.args[0] is s.args[1]:
        parts += [(part, op, 2) for part, op in parts_of(s.args[0], "/")]
    squared = [x for x, power in product.powers.items() if power == 2]
    if len(squared) > 1 and all(map(described, squared)):
        names = joined(map(described, squared))
        words = Words("does not square {factor}{of}: {why}", factor=names, of=of, why=why(s))
        lost = multiplied(map(number, squared))
        yield LESS, "squares", words, ("/", s, lost)
    for part, op, times in parts:
        inner = Product(part)
        if inner.is_exact and inner.coefficient == 1 and len(inner.powers) == 1:
            continue  # one factor, as above
        named = described(part, "the factor") or Words("a factor")
        words = Words(LEAVES_OUT, factor=named, of=of if whole else "", why=why(part))
        cause = computed(f"part {part.number} {times} {s.number}", words, f"part {part.number}")
        yield LESS, "factor", cause, (op, s, ("**", number(part), float(times)))
    yield from _of_ratios(s, product, dimension, of)
    powers = product.powers.values()
    if min(powers, default=0) < 0 < max(powers):
        quotient = whole or Words("a quotient")
        words = Words("inverts {quotient}: {why}", quotient=quotient, why=why(s))
        yield LESS, "inverse", words, ("/", 1.0, s)
    yield from of_coefficient(s)


def _of_whole(s):
    whole = typed(s)
    return Words(" of {product}", product=whole) if whole else described(s, "of the product")


def of_coefficient(s: Step) -> Iterator[Slip]:
    """The slips in the number of a product."""
    product, of = Product(s), _of_whole(s)
    c = abs(product.coefficient)
    if product.is_exact and c != 1 and c.denominator < 100:
        for other in dict.fromkeys((c / 2, 2 * c, *neighbours(c))):
            rank = LESS if other in (c / 2, 2 * c) else LEAST
            words = Words(FACTOR, other=other, own=c, of=of)
            yield rank, f"constant for {other}", words, ("*", s, float(other / c))
        if c in RODS:  # also where no dimension shows that it is of a moment of inertia
            (other,) = RODS - {c}
            words = Words(FACTOR, other=other, own=c, of=of)
            yield LEAST, f"constant for {other}", words, ("*", s, float(other / c))
        for lost in {Fraction(c.numerator), Fraction(1, c.denominator), c} - {Fraction(1)}:
            words = Words(
                "leaves out the factor {factor}{of}: the formula has it", factor=lost, of=of
            )
            yield SIMPLE, f"constant {lost}", words, ("/", s, float(lost))


def _of_ratios(s, product, dimension, of):
    """A ratio of two quantities of one dimension inverted, not squared or to the third power."""
    powers = product.powers.items()
    ratios = [(x, y, n) for x, n in powers for y, m in powers if m == -n < 0]
    inside = [a for a, _ in parts_of(s, "/") if a.op == "/" and any(map(_is_whole, a.args))]
    for x, y, n in (*ratios, *((*a.args, 1) for a in inside)):
        own = dimension(x) if isinstance(x, Step) else None
        if own is None or not isinstance(y, Step) or dimension(y) != own:
            continue
        a, b = described(x), described(y)
        ratio = Words("the ratio of {a} to {b}", a=a, b=b) if a and b else Words("a ratio")
        for k, text in RATIOS.items():
            if k < 0 or (a and b and n == 2) or (n > 1 == k and a and b):
                words = Words(text, ratio=ratio, of="" if a and b else of)
                power = float(2 * n if k < 0 else n - k)
                rank = LEAST if k == 3 else LESS
                yield rank, f"ratio {k}", words, ("*", s, ("**", ("/", y, x), power))


def _is_whole(x):
    """True of a product or a sum, False of a single factor."""
    return isinstance(x, Step) and (x.op in PRODUCT or x.op in SUM)


def parts_of(s: Step, op: str) -> Iterator[tuple[Step, str]]:
    """The products within a product, and the operation that takes each out of it."""
    for n, a in enumerate(s.args):
        if isinstance(a, Step) and a.op in PRODUCT:
            inner = op if n == 0 or s.op == "*" else "*/".replace(op, "")
            yield a, inner
            yield from parts_of(a, inner)


def of_factor(s: Step, x: Step, power: int, factor: Any, why: str) -> Iterator[Slip]:
    """The slips in a factor ``x`` of a product; ``factor`` as a student has it."""
    named, the_factor, of = described(x), described(x, "the factor"), _of_whole(s)
    if power == 2:
        if x.op == "pi":
            named, factor = "2*pi", ("*", factor, 2.0)
        of = "" if of == f" of {named}^2" else of
        words = Words("does not square {factor}{of}: {why}", factor=named, of=of, why=why)
        yield SIMPLE, "square", words, ("/", s, factor)
        words = Words("leaves out {factor}^2{of}: {why}", factor=named, of=of, why=why)
        cause = computed(f"whole {s.number} {x.number}", words, f"without {x.number}")
        yield LESS, "whole square", cause, ("/", ("/", s, factor), factor)
        words = Words("doubles {factor}, and does not square it: {why}", factor=named, why=why)
        yield LEAST, "doubled", words, ("/", ("*", s, 2.0), factor)
        words = Words("takes half of {factor}{of}: the formula has it in full", factor=named, of=of)
        yield LEAST, "half", words, ("*", s, 0.25)
        words = Words("takes twice {factor}{of}: the formula has it once", factor=named, of=of)
        yield LEAST, "twice", words, ("*", s, 4.0)
    elif power == -2:
        words = Words("divides by {factor}, not by its square: {why}", factor=named, why=why)
        yield SIMPLE, "square", words, ("*", s, factor)
    elif power > 0:
        words = Words(LEAVES_OUT, factor=the_factor, of=of, why=why)
        cause = computed(f"factor {s.number} {x.number}", words, f"without {x.number}")
        yield LESS, "factor", cause, ("/", s, factor)
        words = Words("divides by {factor} instead of multiplying: {why}", factor=named, why=why)
        if power > 2:
            words = Words(
                "has {factor}^{less} for {factor}^{power}{of}: {why}",
                factor=named, less=power - 2, power=power, of=of, why=why,
            )  # fmt: skip
        yield LEAST, "divided", words, ("/", ("/", s, factor), factor)
    else:
        words = Words("does not divide by {factor}: {why}", factor=named, why=why)
        cause = computed(f"factor {s.number} {x.number}", words, f"without {x.number}")
        yield LESS, "factor", cause, ("*", s, factor)
        words = Words("multiplies by {factor} instead of dividing: {why}", factor=named, why=why)
        yield LEAST, "multiplied", words, ("*", ("*", s, factor), factor)


def _of_power(s):
    a, _ = s.args
    factor = described(a) or Words("a factor")
    words = Words("leaves out the power of {factor}: the formula has it", factor=factor)
    yield SIMPLE, "power", words, a


def _of_root(s):
    (x,) = s.args
    inside = typed(x) or Words("a sum")
    squares = _summands(x)
    roots = {y.number: ("/", y, r) for y in squares if isinstance(y, Step) and (r := _number_in(y))}
    if roots:
        words = Words("does not square the numbers in {sum}: the whole term is squared", sum=inside)
        sums = [roots.get(getattr(y, "number", -1), y) for y in squares]
        yield SIMPLE, "numbers", words, ("sqrt", total(sums))
    sides = [*map(_side, squares)]
    if len(sides) > 1 and all(side is not None for side in sides):
        yield from _of_components(sides, [next(iter(Product(a).powers)) for a in squares])
        return
    sums = [y for y, n in Product(x).powers.items() if n == 1 and y.op in SUM]
    for y in [x] if x.op in SUM else sums:
        roots: Any = (y.op, *(("sqrt", ("abs", a)) for a in y.args))
        words = Words("takes the root of each term of a sum: it is the root of the whole")
        yield LESS, "roots", words, ("*", s, ("/", roots, ("sqrt", y)))


def _side(x):
    """The expression of which x is the square, or None."""
    product = Product(x)
    if not (product.powers and product.is_exact and product.coefficient > 0):
        return None
    if any(p % 2 for p in product.powers.values()):
        return None
    factors = [("**", y, p / 2) for y, p in product.powers.items()]
    return multiplied([float(product.coefficient) ** 0.5, *factors])


def _of_components(sides, sums):
    """The size of a vector with its components added as numbers, or squared term by term."""
    words = Words("adds components as numbers: they are at right angles")
    yield SIMPLE, "components", words, total(("abs", side) for side in sides)
    yield LESS, "signed components", words, ("abs", total(sides))
    for signs in signs_of(("", "neg"), repeat=len(sides)):  # a formula may be of either sign
        signed = [(s, side) if s else side for s, side in zip(signs, sides, strict=True)]
        yield LESS, f"components {signs}", words, total(signed)
    words = Words("does not square the components: the squares are added, and then the root taken")
    yield LESS, "no squares", words, ("sqrt", ("abs", total(sides)))
    if all(x.op in SUM for x in sums):
        words = Words("squares each term of a sum separately: twice their product is missing")
        for op in SUM:
            each = [(op, *(("*", a, a) for a in x.args)) for x in sums]
            yield LESS, f"each squared {op}", words, ("sqrt", ("abs", total(each)))


def _number_in(x):
    """The root of the number in a square, such as 3 for 9*c^2, or None."""
    product = Product(x)
    root = product.coefficient**0.5
    squared = all(p % 2 == 0 for p in product.powers.values())
    return root if product.is_exact and squared and root % 1 == 0 and root > 1 else None


def _summands(x):
    """The terms of nested sums."""
    if not isinstance(x, Step) or x.op != "+":
        return [x]
    return [term for a in x.args for term in _summands(a)]


def _of_function(s):
    (x,) = s.args
    own = _supplement_of(x)
    inside = typed(x if own is None else own) or "..."
    for rank, twin in ((SIMPLE, COFUNCTIONS[s.op]), (LESS, TANGENTS[s.op])):
        words = Words(
            "takes {other} for {own}: that is another side of its triangle",
            other=f"{twin}({inside})", own=f"{s.op}({inside})",
        )  # fmt: skip
        yield rank, f"cofunction {twin}", words, (twin, x)
        if own is not None:  # cos(pi - beta), which a student writes as -cos(beta)
            yield rank, f"cofunction {twin} back", words, ("*", -1.0, (twin, x))
    yield from _of_inverse(s)


def _supplement_of(x):
    """beta if the step is pi - beta, or None."""
    is_less = isinstance(x, Step) and x.op == "-" and isinstance(x.args[1], Step)
    return x.args[1] if is_less and getattr(x.args[0], "op", "") == "pi" else None


def _of_inverse(s):
    (x,) = s.args
    for name in [SINES[s.op]] if s.op in SINES else ():
        words = Words("gives the {f} of the angle: the angle itself is asked for", f=name)
        yield LESS, "no inverse", words, x
        yield LESS, "no inverse, degrees", words, ("*", x, pi / 180)


def _of_atan(s):
    words = Words("measures the angle from the other axis: the legs of its triangle are exchanged")
    other = ("atan2", *reversed(s.args)) if s.op == "atan2" else ("atan", ("/", 1.0, *s.args))
    yield SIMPLE, "cofunction", words, other
    yield from _of_inverse(s) if s.op == "atan" else ()


_OF = {
    "+": _of_sum, "-": _of_sum, "**": _of_power, "sqrt": _of_root,
    "sin": _of_function, "cos": _of_function, "asin": _of_function, "acos": _of_function,
    "atan": _of_atan, "atan2": _of_atan,
}  # fmt: skip


def of_angles(f: Facts) -> Iterator[Edit]:
    """Angles from the other axis."""
    sines = {s.args[0]: s for s in f.steps if s.op == "sin"}
    cosines = {s.args[0]: s for s in f.steps if s.op == "cos"}
    turned = [s for s in (*sines.values(), *cosines.values()) if is_given(s)]
    if len({s.args[0] for s in turned}) > 1:
        instead: dict[int, Any] = {s.number: (COFUNCTIONS[s.op], *s.args) for s in turned}
        yield edit(LESS, "all axes", ALL_AXES, instead)
    for x, s in sines.items():
        if not any(inner.op == "argument" for inner in steps_needed([x])):
            continue  # a constant
        named = typed(x) or Words("an angle")
        small, c = {s.number: x}, cosines.get(x)
        if c is not None:
            small[c.number] = 1.0
            exchanged = {s.number: ("cos", x), c.number: ("sin", x)}
            yield edit(SIMPLE, f"axis {s.number}", Words(OTHER_AXIS, angle=named), exchanged)
        yield edit(LESS, f"small {s.number}", Words(SMALL_ANGLE, angle=named), small)


def of_moment(s: Step, dimension: Callable[[Step], Dimension | None]) -> Iterator[Slip]:
    """The moment of inertia of another body, in a product."""
    product, whole = Product(s), dimension(s)
    if s.op not in PRODUCT or whole is None or not product.is_exact:
        return
    own, powers = product.coefficient, product.powers
    # an energy has half a moment of inertia; a diameter for the radius gives four times it
    turns = whole != ENERGY or LENGTH in map(dimension, powers)  # m*v^2/2 is of no body
    for n in {INERTIA: (1, 4), AREA: (1,), ENERGY: (2,)}.get(whole, ()) if turns else ():
        yield from _of_body(s, own * n, n, whole)


def _of_body(s, own, times, dimension):
    """The factor of another body in a moment of inertia; a bare mass times a square may belong to a
    particle, or to the parallel-axis theorem.
    """
    of_rod = own in RODS and times < 4
    if not of_rod and (own not in {*BODIES, CONE} or dimension == AREA or own == 1 == times):
        return
    alike = RODS if of_rod or own == 1 else BODIES.keys() - RODS
    for other in sorted(alike - {own}):
        words = Words(
            "takes the factor {other} for {own} in a moment of inertia: that is {body}",
            other=other, own=own, body=BODIES[other],
        )  # fmt: skip
        yield RARER if times == 1 else LESS, f"body {other}", words, ("*", s, float(other / own))
