"""Slips in single operations: a sign, a term, a factor, a square, sine for cosine. Each is (rank,
kind, words, what stands for the step).
"""

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import Any

from ..algebra.trace import Step
from ..algebra.units import Dimension
from .causes import computed
from .formulas import LEAST, LESS, RARER, SIMPLE, Edit, needed
from .typed import Product, described, typed

Slip = tuple[int, str, str, Any]
AREA, INERTIA = Dimension(0, 2), Dimension(1, 2)
COFUNCTIONS = {"sin": "cos", "cos": "sin", "asin": "acos", "acos": "asin"}
PRODUCT = ("*", "/")
RODS = {Fraction(1, 3), Fraction(1, 12)}  # l^2/12 may stand in a sum, without its mass
BODIES = {
    Fraction(1): "a ring", Fraction(1, 2): "a disk about its axis",
    Fraction(1, 4): "a disk about a diameter", Fraction(1, 3): "a rod about its end",
    Fraction(1, 12): "a rod about its centre", Fraction(2, 5): "a solid sphere",
    Fraction(2, 3): "a spherical shell",
}  # fmt: skip


def of_operation(s: Step) -> Iterator[Slip]:
    """The slips in one operation, products apart."""
    yield from _OF.get(s.op, _of_nothing)(s)


def _of_nothing(s):
    return ()


def _of_sum(s):
    a, b = s.args
    minus = s.op == "-"
    signs = "one of the two terms there is subtracted" if minus else "both terms there are added"
    turned_first = ("neg", ("+", a, b)) if minus else ("-", b, a)
    for term, left, turned in (
        (a, ("neg", b) if minus else b, turned_first),
        (b, a, ("+" if minus else "-", a, b)),
    ):
        several = isinstance(term, Step) and term.op in ("+", "-")
        rank, what = LESS if several else SIMPLE, _term(term, s)
        yield rank, "sign", f"has {what} with the opposite sign: {signs}", turned
        yield rank, "term", f"leaves out {what}: it is not zero here", left
        for factor, kind in ((2.0, "doubles"), (0.5, "halves")) if not several else ():
            scaled = (("*", x, factor) if x is term else x for x in (a, b))
            yield LESS, kind, f"{kind} {what}: it counts once", (s.op, *scaled)


def _term(term, whole):
    if not isinstance(term, Step):
        around = typed(whole)
        return f"the {term:g} of {around}" if around else "the constant term of a sum"
    return described(term, "the term") or "one term of a sum"


def of_product(
    s: Step, number: Callable[[Step], Any], has_unit: Callable[[Step], bool]
) -> Iterator[Slip]:
    """The slips in a product with all its factors; ``number`` of a factor, in a student's units."""

    def why(factor):
        return ": then the units do not fit" if has_unit(factor) else ": it is not 1 here"

    product = Product(s)
    whole = typed(s)
    of = (
        f" of {whole}"
        if whole
        else f" of {in_it}"
        if (in_it := described(s, "the product"))
        else ""
    )
    for factor, power in product.powers.items():
        if described(factor):
            yield from _of_factor(s, factor, power, number(factor), of, why(factor))
    for part, op in _parts(s, "/"):
        named = described(part, "the factor") or "a factor"
        words = f"leaves out {named}{f' of {whole}' if whole else ''}{why(part)}"
        yield LESS, "factor", words, (op, s, number(part))
    powers = product.powers.values()
    if min(powers, default=0) < 0 < max(powers):
        yield LESS, "inverse", f"inverts {whole or 'a quotient'}{why(s)}", ("/", 1.0, s)
    c = abs(product.coefficient)
    if product.is_exact and c != 1 and c.denominator < 100:
        for other in (c / 2, 2 * c):
            words = f"takes the factor {other} for {c}{of}: the formula has {c}"
            yield LESS, f"constant for {other}", words, ("*", s, float(other / c))
        for lost in {Fraction(c.numerator), Fraction(1, c.denominator), c} - {Fraction(1)}:
            words = f"leaves out the factor {lost}{of}: the formula has it"
            yield SIMPLE, f"constant {lost}", words, ("/", s, float(lost))


def _parts(s, op):
    """The products within a product, and the operation that takes each out of it."""
    for n, a in enumerate(s.args):
        if isinstance(a, Step) and a.op in PRODUCT:
            inner = op if n == 0 or s.op == "*" else "*/".replace(op, "")
            yield a, inner
            yield from _parts(a, inner)


def _of_factor(s, x, power, factor, of, why):
    named, the_factor = described(x), described(x, "the factor")
    if power == 2:
        of = "" if of == f" of {named}^2" else of
        yield SIMPLE, "square", f"does not square {named}{of}{why}", ("/", s, factor)
    elif power == -2:
        yield SIMPLE, "square", f"divides by {named}, not by its square{why}", ("*", s, factor)
    elif power > 0:
        yield LESS, "factor", f"leaves out {the_factor}{of}{why}", ("/", s, factor)
        yield LEAST, "squared", f"squares {named}{of}{why}", ("*", s, factor)
        words = f"divides by {named} instead of multiplying{why}"
        yield LEAST, "divided", words, ("/", ("/", s, factor), factor)
    else:
        yield LESS, "factor", f"does not divide by {named}{why}", ("*", s, factor)
        words = f"multiplies by {named} instead of dividing{why}"
        yield LEAST, "multiplied", words, ("*", ("*", s, factor), factor)


def _of_power(s):
    a, _ = s.args
    yield (
        SIMPLE,
        "power",
        f"leaves out the power of {described(a) or 'a factor'}: the formula has it",
        a,
    )


def _of_root(s):
    (x,) = s.args
    words = f"leaves out the square root of {typed(x) or 'a sum'}: its square was found"
    yield SIMPLE, "root", words, x
    if isinstance(x, Step) and x.op == "+" and all(Product(a).is_square for a in x.args):
        words = "adds two components as numbers: they are at right angles"
        yield SIMPLE, "components", words, ("+", *(("sqrt", a) for a in x.args))


def _of_function(s):
    (x,) = s.args
    twin, inside = COFUNCTIONS[s.op], typed(x) or "..."
    words = f"takes {twin}({inside}) for {s.op}({inside}): that is the other side of its triangle"
    yield SIMPLE, "cofunction", words, (twin, x)
    if s.op in ("cos", "acos"):
        words, turned = _SUPPLEMENT[s.op]
        yield LESS, "supplement", words.format(f"{s.op}({inside})"), turned(s)


_SUPPLEMENT = {
    "cos": ("has {} with the opposite sign: that is of the supplement", lambda s: ("neg", s)),
    "acos": ("gives the supplement of {}: a cosine has the opposite sign",
             lambda s: ("acos", ("neg", s.args[0]))),
}  # fmt: skip


def _of_tangent(s):
    yield (
        LESS,
        "cotangent",
        "inverts a tangent: the two legs of its triangle are exchanged",
        ("/", 1.0, s),
    )


def _of_atan(s):
    words = "takes the angle from the other axis: the legs of its triangle are exchanged"
    other = ("atan2", *reversed(s.args)) if s.op == "atan2" else ("atan", ("/", 1.0, *s.args))
    yield SIMPLE, "cofunction", words, other


_OF = {
    "+": _of_sum, "-": _of_sum, "**": _of_power, "sqrt": _of_root,
    "sin": _of_function, "cos": _of_function, "asin": _of_function, "acos": _of_function,
    "tan": _of_tangent, "atan": _of_atan, "atan2": _of_atan,
}  # fmt: skip


def of_angles(steps: Sequence[Step]) -> Iterator[Edit]:
    """Angles from the other axis, and the other way round."""
    sines = {s.args[0]: s for s in steps if s.op == "sin"}
    cosines = {s.args[0]: s for s in steps if s.op == "cos"}
    for x, s in sines.items():
        if not any(inner.op == "argument" for inner in needed([x])):
            continue  # a constant
        named = typed(x) or "an angle"
        if x in cosines:
            words = f"measures {named} from the other axis: sine and cosine are exchanged"
            c = cosines[x]
            exchanged = {s.number: ("cos", x), c.number: ("sin", x)}
            yield Edit(SIMPLE, computed(f"axis {s.number}", words), exchanged)
        words = f"takes {named} the other way round: its positive sense is the opposite one"
        yield Edit(SIMPLE, computed(f"turned {s.number}", words), {s.number: ("neg", s)})


def of_constants(steps: Sequence[Step]) -> Iterator[Edit]:
    """One constant left out wherever it is a factor, as both halves of (x/2, y/2)."""
    found: dict[tuple, dict[int, Any]] = {}
    for s in steps:
        if s.op in PRODUCT and isinstance(s.args[0], Step) and not isinstance(s.args[1], Step):
            found.setdefault((s.op, abs(s.args[1])), {})[s.number] = s.args[0]
    for (op, x), instead in found.items():
        if len(instead) > 1 and x != 1:
            lost = f"{'1/' * (op == '/')}{x:g}"
            words = f"leaves out the factor {lost} in several places: the formulas have it"
            yield Edit(LESS, computed(f"everywhere {op} {x}", words), instead)


def of_moment(s: Step, dimension: Dimension | None) -> Iterator[Slip]:
    """The moment of inertia of another body, in a product of this dimension."""
    if s.op not in PRODUCT or dimension not in (INERTIA, AREA):
        return
    product = Product(s)
    own = product.coefficient if product.is_exact else Fraction(0)
    alike = RODS if own in RODS else BODIES.keys() - RODS
    known = own in RODS or (own in BODIES and dimension == INERTIA)
    for other in sorted(alike - {own}) if known else ():
        words = (
            f"takes the factor {other} for {own} in a moment of inertia: that is {BODIES[other]}"
        )
        yield RARER, f"body {other}", words, ("*", s, float(other / own))
