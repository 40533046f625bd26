"""The slips that can be made in a traced computation, as edits of its steps: a factor, a sign, a
square, sine for cosine, one given for another, a unit. Each has its words and how simple it is.
"""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import pi
from typing import Any, NamedTuple

from ..algebra.source import WITHIN
from ..algebra.trace import Step
from ..algebra.units import SI, US, Dimension, System, Unit, unit
from .causes import Cause, computed, unconverted

# how simple a slip is, in pairs: of two that are equally simple the second is made less often
SIMPLE, RARER, LESS, LEAST = 2, 3, 4, 6
MANY = 8  # uses of a step, of which no single one is looked at
SHORT = 24  # letters of a formula that is named in a sentence
COFUNCTIONS = {"sin": "cos", "cos": "sin", "asin": "acos", "acos": "asin"}
MASS, LENGTH, FORCE, GRAVITY = (
    Dimension(*powers) for powers in ((1, 0, 0), (0, 1, 0), (1, 1, -2), (0, 1, -2))
)
G = 9.81  # m/s^2, where the text gives none
# the factors of moments of inertia of a rod or plate, about its centre and about its end
ABOUT = {12: (3, "its end, not its centre"), 3: (12, "its centre, not its end")}

Slip = tuple[int, str, str, Any]  # rank, kind, words, what stands for the step


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


def edits_of(steps: Sequence[Step], units: Mapping[str, str], system: System) -> list[Edit]:
    """The edits of ``steps``, those that the answers need, in order; simplest first.

    units : of the givens and symbols, which are the arguments, in base units of the ``system``
    """
    given = {s.args[0]: s for s in steps if s.op == "argument"}
    read = {name: unit(units[name]) for name in given}
    users: dict[int, list[Step]] = {s.number: [] for s in steps}
    for s in steps:
        for a in {a.number: a for a in _steps(s)}.values():
            users[a.number].append(s)
    found = list(_of_angles(steps)) + list(_of_one_unit(given, read, system))
    for s in steps:
        slips = [*_OF.get(s.op, _of_nothing)(s)]
        if s.op == "argument":
            slips = [*_of_given(s, given, read, system), *_of_unit(s, read[s.args[0]], system)]
        for n, slip in enumerate(slips):
            found += _everywhere_and_once(s, n, slip, users[s.number])
    return sorted(found, key=lambda e: e.rank)


def _steps(s):
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
        rank = LESS if several else SIMPLE
        what = f"the term {named}" if (named := text(term)) else "one term of a sum"
        yield rank, "sign", f"has {what} with the opposite sign", turned
        yield rank, "term", f"leaves out {what}", left
        for factor, kind in ((2.0, "doubles"), (0.5, "halves")) if not several else ():
            scaled = (("*", x, factor) if x is term else x for x in (a, b))
            yield LESS, kind, f"{kind} {what}", (s.op, *scaled)


def _of_product(s):
    a, b = s.args
    if a is b:
        yield SIMPLE, "square", f"does not square {text(a) or 'a factor'}", a
        return
    for factor, other in ((a, b), (b, a)):
        if isinstance(factor, Step):
            what = f"the factor {named}" if (named := text(factor)) else "a factor"
            yield LESS, "factor", f"leaves out {what}{_in(other)}", other
        else:
            yield from _of_constant(s, Fraction(factor).limit_denominator(999), other)


def _of_quotient(s):
    a, b = s.args
    if not isinstance(b, Step):
        yield from _of_constant(s, 1 / Fraction(b).limit_denominator(999), a)
        return
    what = text(b) or "the denominator"
    yield LESS, "factor", f"does not divide by {what}", a
    yield LEAST, "inverse", f"multiplies by {what} and does not divide", ("*", a, b)
    if isinstance(a, Step):
        yield LESS, "numerator", f"leaves out the factor {text(a) or 'of the numerator'}", ("/", 1.0, b)
    elif abs(a) != 1:
        yield SIMPLE, "constant", f"leaves out the factor {a:g}", ("/", 1.0, b)


def _of_constant(s, c, other):
    """A constant factor left out, or that of another axis."""
    if abs(c) == 1 or not c:
        return
    named = str(abs(c)) if c.denominator < 100 else "of a constant"
    yield SIMPLE, "constant", f"leaves out the factor {named}{_in(other)}", other
    if c.numerator == 1 and c.denominator in ABOUT:
        instead, about = ABOUT[c.denominator]
        words = f"takes 1/{instead} for 1/{c.denominator}: that is about {about}"
        yield SIMPLE, "about", words, ("/", other, float(instead))


def _of_power(s):
    a, b = s.args
    yield SIMPLE, "square", f"leaves out the power of {text(a) or 'a factor'}", a


def _of_root(s):
    yield SIMPLE, "root", "leaves out the square root", s.args[0]


def _of_function(s):
    (x,) = s.args
    twin, inside = COFUNCTIONS[s.op], text(x) or "..."
    words = f"takes {twin}({inside}) for {s.op}({inside}): check its triangle"
    yield SIMPLE, "cofunction", words, (twin, x)
    if s.op == "cos":
        yield LESS, "supplement", f"has cos({inside}) with the opposite sign", ("neg", s)


def _of_tangent(s):
    yield LESS, "cotangent", "inverts a tangent: check its triangle", ("/", 1.0, s)


def _of_atan2(s):
    a, b = s.args
    yield SIMPLE, "cofunction", "takes the angle from the other side of its triangle", ("atan2", b, a)


_OF = {
    "+": _of_sum, "-": _of_sum, "*": _of_product, "/": _of_quotient, "**": _of_power,
    "sqrt": _of_root, "sin": _of_function, "cos": _of_function, "asin": _of_function,
    "acos": _of_function, "tan": _of_tangent, "atan2": _of_atan2,
}  # fmt: skip


def _of_angles(steps):
    """Angles from the other axis, and the other way round."""
    sines = {s.args[0]: s for s in steps if s.op == "sin"}
    cosines = {s.args[0]: s for s in steps if s.op == "cos"}
    for x, s in sines.items():
        named = text(x) or "an angle"
        if x in cosines:
            words = f"measures {named} from the other axis: sine and cosine are exchanged"
            c = cosines[x]
            exchanged = {s.number: ("cos", x), c.number: ("sin", x)}
            yield Edit(SIMPLE, computed(f"axis {s.number}", words), exchanged)
        words = f"takes {named} the other way round"
        yield Edit(SIMPLE, computed(f"turned {s.number}", words), {s.number: ("neg", s)})


# -- givens


def _of_given(s, given, read, system):
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
    if own.dimension in (MASS, FORCE):
        g = next((x for n, x in given.items() if read[n].dimension == GRAVITY), None)
        g = unit("m/s^2").to_base(G, system) if g is None else g
        words = f"takes {name} for a mass" if own.dimension == FORCE else f"multiplies {name} by g"
        yield RARER, "g", f"{words}: mass and weight are exchanged", ("*", s, g)
        yield LESS, "g", f"divides {name} by g: mass and weight are exchanged", ("/", s, g)


def _of_unit(s, own: Unit, system: System):
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


# -- words


def _in(other):
    return f" of {named}" if (named := text(other)) else ""


def text(x: Any) -> str:
    """A short expression as it is typed; "" for one that is too long to be named."""
    written = _written(x, 0)
    return written if written and len(written) <= SHORT else ""


_BINDING = {"+": 1, "-": 1, "neg": 1, "*": 2, "/": 2, "**": 3}


def _written(x, around):
    if not isinstance(x, Step):
        return f"{x:g}" if isinstance(x, (int, float)) and len(f"{x:g}") < 5 else ""
    if x.op == "argument":
        return x.args[0]
    if x.op in ("integral", "over_cube", "root", "item", "where") or not x.args:
        return "pi" if x.op == "pi" else ""
    binding = _BINDING.get(x.op)
    inside = [_written(a, binding or 0) for a in x.args]
    if not all(inside) or sum(map(len, inside)) > SHORT:
        return ""
    if binding is None:
        return f"{x.op}({', '.join(inside)})"
    if x.op == "*" and x.args[0] is x.args[1]:
        return f"{_written(x.args[0], 3)}^2"
    sign = {"**": "^", "+": " + ", "-": " - "}.get(x.op, x.op)
    joined = f"-{inside[0]}" if x.op == "neg" else sign.join(inside)
    right = x.op in "-/" and isinstance(x.args[-1], Step) and _BINDING.get(x.args[-1].op) == binding
    if right:
        joined = f"{inside[0]}{sign}({inside[1]})"
    return f"({joined})" if binding < around else joined
