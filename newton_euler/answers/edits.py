"""The slips that can be made in a traced computation, as edits of its steps: a factor, a sign, a
square, sine for cosine, one given for another, a unit. Each has its words and how simple it is.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import partial
from math import pi
from typing import Any, NamedTuple

from ..algebra import scalars
from ..algebra.errors import NewtonEulerError
from ..algebra.source import WITHIN, operations
from ..algebra.trace import Step
from ..algebra.units import SI, US, Dimension, System, unit
from .causes import Cause, computed, unconverted
from .typed import Product, described, typed

# how simple a slip is, in pairs: of two that are equally simple the second is made less often
SIMPLE, RARER, LESS, LEAST = 2, 3, 4, 6
MANY = 8  # uses of a step, of which no single one is looked at
COFUNCTIONS = {"sin": "cos", "cos": "sin", "asin": "acos", "acos": "asin"}
MASS, LENGTH, AREA, INERTIA = (Dimension(m, l) for m, l in ((1, 0), (0, 1), (0, 2), (1, 2)))
FORCE, GRAVITY = Dimension(1, 1, -2), Dimension(0, 1, -2)
G = 9.81  # m/s^2, where the text gives none
BODIES = {
    Fraction(1): "a ring", Fraction(1, 2): "a disk about its axis",
    Fraction(1, 4): "a disk about a diameter", Fraction(1, 3): "a rod about its end",
    Fraction(1, 12): "a rod about its centre", Fraction(2, 5): "a solid sphere",
    Fraction(2, 3): "a spherical shell",
}  # fmt: skip
CONFUSED = {"km": "mi", "mi": "km", "in": "ft", "ft": "in", "mm": "cm", "cm": "mm"}


class Edit(NamedTuple):
    """A slip: other expressions for some steps, {number: expression}. An expression is a number, a
    step, or an operation and its expressions, as a tuple. The lower the ``rank``, the simpler; two
    of one ``level`` are equally simple.
    """

    rank: int
    cause: Cause
    instead: dict[int, Any]

    @property
    def level(self) -> int:
        """Its pair of ranks."""
        return self.rank // 2


def edits_of(
    steps: Sequence[Step],
    answers: Sequence[Sequence[Any]],
    units: Mapping[str, str],
    system: System,
) -> list[Edit]:
    """The edits of ``steps``, those that the answers need, in order; simplest first.

    answers : the components of each
    units : of the givens and symbols, which are the arguments, in base units of the ``system``
    """
    given = {s.args[0]: s for s in steps if s.op == "argument"}
    read = {name: unit(units[name]) for name in given}
    leaves = {x for parts in answers for x in parts if isinstance(x, Step)}
    users, dimensions = _users(steps), _dimensions(steps, read)
    own = US if any(u.is_of_feet for u in read.values()) else SI
    number = partial(_number, dimensions, system, own)
    found = [*_of_angles(steps), *_of_one_unit(given, read, system)]
    found += _of_wholes(answers, given, number)
    for s in steps:
        slips = [*_OF.get(s.op, _of_nothing)(s)]
        if s.op == "argument":
            slips = [*_of_given(s, given, read, number), *_of_unit(s, read[s.args[0]], system)]
        if s.op in PRODUCT and (s in leaves or not _is_factor(users[s.number])):
            slips += _of_product(s, number)
        if s.op in PRODUCT and dimensions[s] in (INERTIA, AREA):
            slips += _of_moment(s)
        for n, slip in enumerate(slips):
            found += _everywhere_and_once(s, n, slip, users[s.number])
    return sorted(found, key=lambda e: e.rank)


def _is_factor(users):
    """True of what is a factor of one product."""
    return len(users) == 1 and users[0].op in PRODUCT


def _number(dimensions, system, own, s):
    """The number by which a student multiplies for a step: in feet and pounds, where the text is,
    another one than in the ``system`` in which the steps are computed.
    """
    dimension = dimensions[s]
    if system is own or dimension is None:
        return s
    return ("*", s, float(system.factor(dimension) / own.factor(dimension)))


def _dimensions(steps, read):
    """The dimension of each step; None where it has no whole powers, or is within an integral."""
    run, found = operations(scalars), {}
    for s in steps:
        try:
            args = [found[a] if isinstance(a, Step) else a for a in s.args]
            found[s] = read[s.args[0]].dimension if s.op == "argument" else run[s.op](*args)
        except (NewtonEulerError, TypeError, AttributeError, KeyError):
            found[s] = None
    return {s: d if isinstance(d, Dimension) and _is_whole(d) else None for s, d in found.items()}


def _is_whole(dimension):
    return all(p.denominator == 1 for p in dimension.powers)


def _users(steps):
    users: dict[int, list[Step]] = {s.number: [] for s in steps}
    for s in steps:
        for a in {a.number: a for a in steps_in(s)}.values():
            users[a.number].append(s)
    return users


def steps_in(s: Step) -> list[Step]:
    """The arguments of a step that are steps."""
    return [a for a in s.args if isinstance(a, Step)]


def _everywhere_and_once(s, place, slip, users):
    """The edit wherever the step is used, and in one use alone if there are several."""
    rank, kind, words, expression = slip
    cause = words if isinstance(words, Cause) else computed(f"{kind} {s.number} {place}", words)
    yield Edit(rank, cause, {s.number: expression})
    users = [user for user in users if user.op not in WITHIN] if len(users) > 1 else []
    for user in users if len(users) <= MANY and rank <= LESS else ():
        once = (user.op, *(expression if a is s else a for a in user.args))
        name = f"{kind} {s.number} {place} {user.number}"
        yield Edit(rank + 2, computed(name, f"{cause.text}, in one place"), {user.number: once})


# -- operations


def _of_nothing(s):
    return ()


def _of_sum(s):
    a, b = s.args
    minus = s.op == "-"
    turned_first = ("neg", ("+", a, b)) if minus else ("-", b, a)
    for term, left, turned in (
        (a, ("neg", b) if minus else b, turned_first),
        (b, a, ("+" if minus else "-", a, b)),
    ):
        several = isinstance(term, Step) and term.op in ("+", "-")
        rank, what = LESS if several else SIMPLE, _term(term, s)
        yield rank, "sign", f"has {what} with the opposite sign", turned
        yield rank, "term", f"leaves out {what}", left
        for factor, kind in ((2.0, "doubles"), (0.5, "halves")) if not several else ():
            scaled = (("*", x, factor) if x is term else x for x in (a, b))
            yield LESS, kind, f"{kind} {what}", (s.op, *scaled)


def _term(term, whole):
    if not isinstance(term, Step):
        around = typed(whole)
        return f"the {term:g} of {around}" if around else "the constant term of a sum"
    return f"the term {what}" if (what := described(term)) else "one term of a sum"


PRODUCT = ("*", "/")


def _of_product(s, number):
    """Slips in a product with all its factors."""
    product = Product(s)
    of = f" of {whole}" if (whole := typed(s)) else ""
    for factor, power in product.powers.items():
        if named := described(factor):
            yield from _of_factor(s, number(factor), power, named, of)
    for part, op in _parts(s, "/"):
        yield (
            LESS,
            "factor",
            f"leaves out the factor {described(part) or 'of a product'}{of}",
            (op, s, number(part)),
        )
    powers = product.powers.values()
    if min(powers, default=0) < 0 < max(powers):
        yield LESS, "inverse", f"inverts {whole or 'a quotient'}", ("/", 1.0, s)
    c = abs(product.coefficient)
    if product.is_exact and c != 1 and c.denominator < 100:
        for lost in {Fraction(c.numerator), Fraction(1, c.denominator), c} - {Fraction(1)}:
            words = f"leaves out the factor {lost}{of}"
            yield SIMPLE, f"constant {lost}", words, ("/", s, float(lost))


def _parts(s, op):
    """The products within a product, and the operation that takes each out of it."""
    for n, a in enumerate(s.args):
        if isinstance(a, Step) and a.op in PRODUCT:
            inner = op if n == 0 or s.op == "*" else "*/".replace(op, "")
            yield a, inner
            yield from _parts(a, inner)


def _of_factor(s, factor, power, named, of):
    if power == 2:
        yield SIMPLE, "square", f"does not square {named}{of}", ("/", s, factor)
    elif power == -2:
        yield SIMPLE, "square", f"divides by {named}, not by its square", ("*", s, factor)
    elif power > 0:
        yield LESS, "factor", f"leaves out the factor {named}{of}", ("/", s, factor)
        yield LEAST, "squared", f"squares {named}{of}", ("*", s, factor)
        words = f"divides by {named} and does not multiply"
        yield LEAST, "divided", words, ("/", ("/", s, factor), factor)
    else:
        yield LESS, "factor", f"does not divide by {named}", ("*", s, factor)
        words = f"multiplies by {named} and does not divide"
        yield LEAST, "multiplied", words, ("*", ("*", s, factor), factor)


def _of_power(s):
    a, _ = s.args
    yield SIMPLE, "power", f"leaves out the power of {described(a) or 'a factor'}", a


def _of_root(s):
    yield SIMPLE, "root", f"leaves out the square root of {typed(s.args[0]) or 'a sum'}", s.args[0]


def _of_function(s):
    (x,) = s.args
    twin, inside = COFUNCTIONS[s.op], typed(x) or "..."
    words = f"takes {twin}({inside}) for {s.op}({inside}): check its triangle"
    yield SIMPLE, "cofunction", words, (twin, x)
    if s.op in ("cos", "acos"):
        other = "with the opposite sign" if s.op == "cos" else "of the other sign: its supplement"
        yield LESS, "supplement", f"has {s.op}({inside}) {other}", _turned(s)


def _turned(s):
    return ("neg", s) if s.op == "cos" else ("acos", ("neg", s.args[0]))


def _of_tangent(s):
    yield LESS, "cotangent", "inverts a tangent: check its triangle", ("/", 1.0, s)


def _of_atan(s):
    words = "takes the angle from the other side of its triangle"
    other = ("atan2", *reversed(s.args)) if s.op == "atan2" else ("atan", ("/", 1.0, *s.args))
    yield SIMPLE, "cofunction", words, other


_OF = {
    "+": _of_sum, "-": _of_sum, "**": _of_power, "sqrt": _of_root,
    "sin": _of_function, "cos": _of_function, "asin": _of_function, "acos": _of_function,
    "tan": _of_tangent, "atan": _of_atan, "atan2": _of_atan,
}  # fmt: skip


def _of_angles(steps):
    """Angles from the other axis, and the other way round."""
    sines = {s.args[0]: s for s in steps if s.op == "sin"}
    cosines = {s.args[0]: s for s in steps if s.op == "cos"}
    for x, s in sines.items():
        named = typed(x) or "an angle"
        if x in cosines:
            words = f"measures {named} from the other axis: sine and cosine are exchanged"
            c = cosines[x]
            exchanged = {s.number: ("cos", x), c.number: ("sin", x)}
            yield Edit(SIMPLE, computed(f"axis {s.number}", words), exchanged)
        words = f"takes {named} the other way round"
        yield Edit(SIMPLE, computed(f"turned {s.number}", words), {s.number: ("neg", s)})


def _of_wholes(answers, given, number):
    """Whole answers with a given too many or too few."""
    components = [x for parts in answers for x in parts if isinstance(x, Step)]
    for name, step in given.items():
        for op, words in (("/", "few"), ("*", "many")):
            cause = computed(f"whole {op} {name}", f"has one factor {name} too {words}")
            instead = {x.number: (op, x, number(step)) for x in components if x is not step}
            yield Edit(LESS, cause, instead)


# -- moments of inertia


def _of_moment(s):
    product = Product(s)
    own = product.coefficient if product.is_exact else None
    for other, body in BODIES.items() if own in BODIES and len(product.powers) > own else ():
        if other != own:
            words = f"takes {other} for {own} in a moment of inertia: that is {body}"
            yield RARER, f"body {other}", words, ("*", s, float(other / own))


# -- givens


def _of_given(s, given, read, number):
    """One given for another, twice or half of it, its sign, weight for mass."""
    name, own = s.args[0], read[s.args[0]]
    for other, step in given.items():
        if other != name and read[other].dimension == own.dimension:
            rank = RARER if read[other].text == own.text else LESS
            yield rank, f"given {other}", f"takes {other} for {name}", step
    if own.dimension != MASS:
        yield RARER, "sign", f"takes {name} with the opposite sign", ("neg", s)
    rank = RARER if own.dimension == LENGTH else LESS
    yield rank, "doubled", f"takes twice {name}", ("*", s, 2.0)
    yield rank, "halved", f"takes half of {name}", ("*", s, 0.5)
    yield LESS, "zero", f"leaves out {name}", ("*", s, 0.0)
    yield LESS, "one", f"leaves out the factor {name}", ("/", s, number(s))
    if own.dimension in (MASS, FORCE):
        g = next((number(x) for n, x in given.items() if read[n].dimension == GRAVITY), G)
        words = f"takes {name} for a mass" if own.dimension == FORCE else f"multiplies {name} by g"
        yield RARER, "g", f"{words}: mass and weight are exchanged", ("*", s, g)
        yield LESS, "g", f"divides {name} by g: mass and weight are exchanged", ("/", s, g)


def _of_unit(s, own, system):
    """A given used with its number in another unit."""
    name, factor = s.args[0], own.to_base(1.0, system)
    for ratio in _ratios(own, system):
        yield SIMPLE, "unit", unconverted(name, own.text), ("*", s, ratio)
        words = f"converts {name} from {own.text} the wrong way"
        yield LESS, "wrong way", words, ("*", s, ratio * ratio)
    if own.is_of_turning and abs(factor - pi / 180) > 1e-9:
        words = f"leaves out 2*pi in {name}: a revolution is 2*pi radians"
        yield SIMPLE, "2 pi", words, ("*", s, 0.5 / pi)
    for part in own.parts:
        if part in CONFUSED:
            other = CONFUSED[part]
            words = f"takes {other} for {part} in {name}"
            ratio = unit(other).to_base(1.0, SI) / unit(part).to_base(1.0, SI)
            yield LESS, f"confused {part}", words, ("*", s, ratio)
        if part != own.text:
            words = f"does not convert the {part} in {name}"
            yield LESS, f"part {part}", words, ("*", s, 1 / unit(part).to_base(1.0, system))
            yield LESS, f"part {part}", words, ("*", s, unit(part).to_base(1.0, system))


def _ratios(own, system):
    """The factors by which a quantity is wrong that is used with its number, as if in SI or in feet
    and pounds.
    """
    found = set()
    for other in (SI, US):
        there = own.to_base(1.0, other)
        meant = float(other.factor(own.dimension) / system.factor(own.dimension))
        ratio = meant / own.to_base(1.0, system)
        if abs(there - 1) > 1e-9 and (other is SI or own.is_of_feet or other is system):
            found.add(ratio)
    return sorted(found)


def _of_one_unit(given, read, system):
    """All givens in one unit with their numbers."""
    for stated in dict.fromkeys(u.text for u in read.values()):
        steps = [s for n, s in given.items() if read[n].text == stated]
        for ratio in _ratios(unit(stated), system) if len(steps) > 1 else ():
            cause = unconverted("what is given", stated)
            yield Edit(SIMPLE, cause, {s.number: ("*", s, ratio) for s in steps})
