"""Slips in the givens: one for another, twice or half of one, sign, unit, weight for mass."""

from collections.abc import Iterator
from itertools import combinations, permutations, product
from math import pi
from typing import Any

from newton_euler.algebra.language import Words, joined
from newton_euler.algebra.trace import Step
from newton_euler.algebra.units import SI, US, Dimension, System, Unit, unit
from newton_euler.answers.causes import FACTOR_2, LEFT_OUT, ZERO, Cause, computed, unconverted
from newton_euler.answers.near import LEAST, LESS, RARER, SIMPLE

from .facts import FORCE, G_OF_FEET, GRAVITY, LENGTH, MASS, NUMBER, TIME, Facts, G
from .formulas import SUM, Edit, edit
from .typed import is_nothing, terms_of

RATES = Dimension(0, 0, -1), Dimension(0, 0, -2)
TWICE, HALF, ONE, FOREIGN = "doubled", "halved", "one", "foreign unit"
OTHERS = {  # units from which a number already in this unit is wrongly converted
    "rad/s": ("rev/min", "rev/s"), "rad": ("deg",), "m": ("mm", "cm"), "ft": ("in",),
    "m/s": ("km/h",), "ft/s": ("mi/h",), "s": ("min",), "kg": ("g",),
}  # fmt: skip
CONFUSED = {"km": "mi", "mi": "km", "in": "ft", "ft": "in", "mm": "cm", "cm": "mm"}
OF_TURNS = {"s": "min"}  # the unit by which a rotation rate is divided

MANY = 9  # lengths: of more, not even whole ones are added
SEVERAL = 6  # lengths, or pairs of rates: of more, no sums are tried

TWO_PI = Words("leaves out 2*pi in {name}: a revolution is 2*pi radians")
INVERTED = Words("converts {name} from {unit} the wrong way: its factor is inverted")
FROM = Words("converts {name} from {other}: it is given in {unit}")
SLANT = Words(
    "takes the slant length sqrt({name}^2 + {other}^2) for {name}: another distance counts"
)
LEG = Words("takes the leg sqrt({name}^2 - {other}^2) for {name}: check where the right angle is")
HALVES = Words("takes half of {name} and of {other}: a radius is not a diameter")
TWICE_BOTH = Words("takes twice {name} and {other}: a diameter is not a radius")
AS_EQUAL = Words("takes {name} and {other} as equal: the text gives two lengths")
PLACE = Words("takes {name} {op} {part} for {name}: it leads to another point")
LOAD = Words("takes {name} {op} {part} for {name}: check which bodies count there")
MEAN = Words("takes the mean of {a} and {b} for {key}: look up what {key} stands for")
PAIRS = Words("multiplies {a} by {b}, each by each, for {key}: look up what {key} stands for")
OF_GIVEN = Words("takes {other} for {name}: {why}")
LESS_OTHER = Words("takes {name} - {other} for {name}: {why}")
NOT_HERE = Words("leaves out {name}: it is not zero here")
NOT_ONE, NO_FIT = Words("it is not 1 here"), Words("then the units do not fit")
TIMES_OF_GIVEN = (
    (2.0, TWICE, Words("takes twice {name}, or has a 2 too many beside it: {why}")),
    (0.5, HALF, Words("takes half of {name}, or lacks a factor 2 beside it: {why}")),
)
OF_WEIGHT = {  # words for a product with g, and for a quotient by it
    FORCE: (
        Words("takes {name} for a mass: it is a weight"),
        Words("divides {name} by g: it is a force already"),
    ),
    MASS: (
        Words("multiplies {name} by g: it is a mass already"),
        Words("divides {name} by g: it is a mass, not a weight"),
    ),
}
# rank, kind, words or cause, replacement; for some also what they do, and to what
Slip = tuple[int, str, Any, Any] | tuple[int, str, Words, Any, str, str]


def of_given(s: Step, f: Facts) -> Iterator[Slip]:
    """One given for another, twice or half of it, its sign, weight for mass."""
    name, own = s.args[0], f.read[s.args[0]]
    is_it = Words("the formula has {name} there", name=name)
    if means := f.formulas.means.get(name):
        is_it = Words("{name} is the {means}", name=name, means=means)
    not_one, others = NOT_ONE if own.dimension == NUMBER else NO_FIT, _others(s, f)
    yield from _of_another_given(s, others, f.read, is_it)
    if own.dimension == NUMBER and not own.is_of_angle:
        yield LEAST, "inverse", Words("inverts {name}: {why}", name=name, why=is_it), ("/", 1.0, s)
    yield from _of_sign(s, own.dimension)
    for times, kind, text in TIMES_OF_GIVEN:
        rank = RARER if own.dimension == LENGTH else LESS
        yield rank, kind, Words(text, name=name, why=is_it), ("*", s, times), FACTOR_2, name
    yield LESS, "zero", Words(NOT_HERE, name=name), ("*", s, 0.0), ZERO, name
    words = Words("leaves out the factor {name}: {why}", name=name, why=not_one)
    cause = computed(f"{ONE} {s.number}", words, f"without {s.number}")
    yield LESS, ONE, cause, ("/", s, f.number(s))
    if name == "g" and own.dimension == GRAVITY:
        if own.text == "m/s^2":
            words = Words("takes 10 for {name}: the text gives more digits", name=name)
            yield LESS, "ten", words, 10.0
        elsewhere, of = (G, "m/s^2") if own.is_of_feet else (G_OF_FEET, "ft/s^2")
        words = Words(
            "takes {other} for {name}: that is in {unit}", other=elsewhere, name=name, unit=of
        )
        yield LESS, "g of others", words, elsewhere * own.to_base(1.0, f.system)
    if own.dimension in OF_WEIGHT:
        g = f.number(others["g"]) if "g" in others else G_OF_FEET if own.is_of_feet else G
        for op, text in zip("*/", OF_WEIGHT[own.dimension], strict=True):
            yield LESS, "g", Words(text, name=name), (op, s, g)


def _others(s, f):
    """The givens that may be taken for one: symbols for symbols, no two of earlier answers."""
    name, symbols, components = s.args[0], f.formulas.symbols, f.formulas.components
    found = {n: x for n, x in f.anything.items() if (n in symbols) == (name in symbols)}
    return {n: x for n, x in found.items() if name not in components or n not in components}


def _of_another_given(s, others, read, is_it):
    name, own = s.args[0], read[s.args[0]]
    for other, step in others.items():
        if read[other].dimension != own.dimension:
            if not _are_confused(read[other].dimension, own.dimension):
                continue  # an unlikely slip, and many of these agree by chance
            words = Words(OF_GIVEN, other=other, name=name, why=NO_FIT)
            yield LEAST, f"given {other}", words, step
        elif other != name:
            rank = RARER if read[other].text == own.text else LESS
            yield rank, f"given {other}", Words(OF_GIVEN, other=other, name=name, why=is_it), step
            if own.is_of_angle:
                words = Words(LESS_OTHER, name=name, other=other, why=is_it)
                yield LEAST, f"less {other}", words, ("-", s, step)


def _are_confused(a, b):
    """True of a quantity and its rate, of a length and an area, a mass and a weight."""
    mass, length, time = (a / b).powers
    return {a, b} == {MASS, FORCE} or (not mass and not (length and time))


def _of_sign(s, dimension):
    """A given with the opposite sign, a length on the other side; not for a mass."""
    name, rank = s.args[0], RARER
    words = Words("takes {name} with the opposite sign: the text gives its sense", name=name)
    if dimension == LENGTH:
        rank = LESS + 1
        words = Words("measures {name} to the other side: look at the figure", name=name)
    if dimension != MASS:
        yield rank, "sign", words, ("neg", s)


def of_rates(f: Facts) -> Iterator[Edit]:
    """Angular velocities about different axes added as numbers, alone or with their rates."""
    spins, growths = (
        [*permutations([n for n in f.anything if f.read[n].dimension == of], 2)] for of in RATES
    )
    for pairs in product(spins, [None, *growths]) if len(spins) <= SEVERAL else ():
        instead: dict[int, Any] = {}
        for a, b in filter(None, pairs):
            one, other = f.anything[a], f.anything[b]
            instead |= {one.number: ("+", one, other), other.number: 0.0}
        a, b = pairs[0]
        words = Words("adds {a} and {b} as numbers: they turn about different axes", a=a, b=b)
        yield edit(LEAST, f"added {[*instead]}", words, instead)


def of_lengths(f: Facts) -> Iterator[Edit]:
    """A length to another point: another length, or half of it, added or subtracted, or another
    side of a right angle; two lengths taken as equal.
    """
    given, few = f.given, [n for n in f.given if f.read[n].dimension == LENGTH]
    yield from _of_few_lengths(few, given) if len(few) <= SEVERAL else ()
    yield from _of_sums(few, given, PLACE, len(few) <= SEVERAL)


def _of_few_lengths(lengths, given):
    for name, other in permutations(lengths, 2):
        squares = [("*", given[n], given[n]) for n in (name, other)]
        for op, text in ("+", SLANT), ("-", LEG):
            side = ("sqrt", ("abs", (op, *squares)))
            words = Words(text, name=name, other=other)
            yield edit(LEAST, f"slant {name} {op} {other}", words, {given[name].number: side})
    for pair in combinations(lengths, 2):
        name, other = pair
        both = ("*", ("+", given[name], given[other]), 0.5)
        words = Words(AS_EQUAL, name=name, other=other)
        yield edit(LEAST, f"equal {name} {other}", words, {given[n].number: both for n in pair})
        for factor, text in (0.5, HALVES), (2.0, TWICE_BOTH):
            instead = {given[n].number: ("*", given[n], factor) for n in pair}
            words = Words(text, name=name, other=other)
            yield edit(LEAST + 2, f"{factor} of {name} {other}", words, instead)


def of_loads(f: Facts) -> Iterator[Edit]:
    """The mass, or the weight, of another body added or taken off."""
    for kind in MASS, FORCE:
        names = [n for n in f.anything if f.read[n].dimension == kind]
        yield from _of_sums(names, f.anything, LOAD, False)


def _of_sums(names, given, text, with_halves):
    """Another given of the same kind added or taken off; of many, none."""
    for name, other in permutations(names, 2) if len(names) <= MANY else ():
        parts: list[tuple[str, Any]] = [(other, given[other])]
        parts += [(f"{other}/2", ("*", given[other], 0.5))] if with_halves else []
        for (part, x), op in product(parts, "+-"):
            words = Words(text, name=name, op=op, part=part)
            instead = {given[name].number: (op, given[name], x)}
            yield edit(LEAST, f"{name} {op} {part}", words, instead)


def of_projections(f: Facts) -> Iterator[Edit]:
    """The component of a given, or of an answer, by a given angle, in its place."""
    angles = [n for n in f.given if f.read[n].is_of_angle]
    for (key, answer), angle, function in product(f.answers.items(), angles, ("cos", "sin")):
        x, *others = answer.parts
        if not others and isinstance(x, Step):
            part = f"{key}*{function}({angle})"
            words = Words("gives {part}, a component: the whole is asked for", part=part)
            instead = {x.number: ("*", x, (function, f.given[angle]))}
            yield edit(LESS, f"component {key} {function} {angle}", words, instead)
    whole = [n for n in f.given if f.read[n].dimension not in (MASS, TIME, NUMBER, *RATES)]
    for name, angle, function in product(whole, angles, ("cos", "sin")):
        part = f"{name}*{function}({angle})"
        words = Words("takes {part} for {name}: all of it counts", part=part, name=name)
        s = f.given[name]
        instead = {s.number: ("*", s, (function, f.given[angle]))}
        yield edit(LEAST, f"{name} {function} {angle}", words, instead)


def of_weights(f: Facts) -> Iterator[Edit]:
    """The weight of a given mass put into a component of a force, upward or downward, and g into
    one of an acceleration by forces.
    """
    found = {x: key for key, a in f.answers.items() for x in a.parts if isinstance(x, Step)}
    masses = {n: s for n, s in f.numbers.items() if f.read[n].dimension == MASS}
    for (x, key), op in product(found.items() if masses else (), "+-"):
        if f.of(x) == GRAVITY:
            words = Words("puts g into {key}: look up what {key} consists of", key=key)
            yield edit(LEAST, f"{op} g {x.number}", words, {x.number: (op, x, f.g)})
    for (x, key), (name, m), op in product(found.items(), masses.items(), "+-"):
        if f.of(x) == FORCE:
            words = Words(
                "puts the weight {name}*g into {key}: look up what {key} consists of",
                name=name, key=key,
            )  # fmt: skip
            instead = {x.number: (op, x, ("*", m, f.g))}
            yield edit(LEAST, f"{op} weight of {name} {x.number}", words, instead)


def of_unit(s: Step, own: Unit, system: System) -> Iterator[Slip]:
    """A given used with its number in another unit."""
    name = s.args[0]
    for ratio in _ratios(own, system):
        yield SIMPLE, "unit", unconverted(name, own.text), ("*", s, ratio)
        words = Words(INVERTED, name=name, unit=own.text)
        yield LESS + 1, "wrong way", Cause("unit", f"{name} back", words), ("*", s, ratio * ratio)
    for foreign in OTHERS.get(own.text, ()):
        words = Words(FROM, name=name, other=foreign, unit=own.text)
        ratio = float(unit(foreign).to_base(1.0, SI) / own.to_base(1.0, SI))
        yield LESS, FOREIGN, Cause("unit", f"{name} from {foreign}", words), ("*", s, ratio)
    if own.text == "rad/s":
        words = Words("divides {name} by 2*pi: it is in radians already", name=name)
        yield LESS, "in turns", words, ("*", s, 0.5 / pi)
    if _is_of_turns(own):
        yield SIMPLE, "2 pi", Words(TWO_PI, name=name), ("*", s, 0.5 / pi)
    for part in own.parts:
        over = own.is_of_turning and OF_TURNS.get(part)
        if other := CONFUSED.get(part) or over:
            words = Words(
                "takes {other} for {part} in {name}: it is given in {unit}",
                other=other, part=part, name=name, unit=own.text,
            )  # fmt: skip
            ratio = unit(other).to_base(1.0, SI) / unit(part).to_base(1.0, SI)
            yield LESS, f"confused {part}", words, ("/" if over else "*", s, ratio)
        ratio = unit(part).to_base(1.0, system)
        if part != own.text and ratio != 1:
            words = Words(
                "does not convert the {part} in {name}: the rest is in other units",
                part=part, name=name,
            )  # fmt: skip
            for times in (1 / ratio, ratio):
                yield LESS, f"part {part}", words, ("*", s, times)


def _is_of_turns(own):
    """True of a unit with revolutions in it, and of radians."""
    return own.is_of_turning and abs(own.to_base(1.0, SI) - pi / 180) > 1e-9


def _ratios(own, system):
    """The factors of a quantity whose number is used as if in SI, or in feet and pounds."""
    found = set()
    for other in (SI, US):
        there = own.to_base(1.0, other)
        meant = float(other.factor(own.dimension) / system.factor(own.dimension))
        ratio = meant / own.to_base(1.0, system)
        if abs(there - 1) > 1e-9 and (other is SI or own.is_of_feet or other is system):
            found.add(ratio)
    return sorted(found)


def of_planes(f: Facts) -> Iterator[Edit]:
    """Of a sum of products of two givens, as a scalar product, both givens of one left out."""
    for s in (s for s in f.steps if s.op in SUM):
        products = [x.args for _, x in terms_of(s) if isinstance(x, Step) and x.op == "*"]
        pairs = [p for p in products if p[0] is not p[1] and all(map(_is_argument, p))]
        for pair in pairs if len(pairs) > 1 else ():
            names = _names(pair)
            words = Words("leaves out {names}: they are not zero here", names=names)
            name = " ".join(["no", *(str(x.number) for x in pair)])
            yield edit(LESS, name, words, {x.number: 0.0 for x in pair}, LEFT_OUT, names)


def _names(steps):
    return joined(s.args[0] for s in steps)


def _is_argument(x):
    return isinstance(x, Step) and x.op == "argument"


def of_earlier(f: Facts) -> Iterator[Edit]:
    """An earlier vector of the student's left out, all of its ``components``."""
    components = f.formulas.components
    for name in dict.fromkeys(components.values()):
        own = [s.number for n, s in f.given.items() if components.get(n) == name]
        cause = computed(f"without {name}", Words(NOT_HERE, name=name), name, ZERO, name)
        yield Edit(RARER, cause, dict.fromkeys(own, 0.0))


def of_exchanged(f: Facts) -> Iterator[Edit]:
    """Two givens, each in the place of the other."""
    for (a, s), (b, t) in combinations(f.given.items(), 2):
        if _are_confused(f.read[a].dimension, f.read[b].dimension):
            words = Words("exchanges {a} and {b}: each has its own place", a=a, b=b)
            rank = LESS if f.read[a].text == f.read[b].text else LEAST + 2
            yield edit(rank, f"exchanged {a} {b}", words, {s.number: t, t.number: s})


def of_vectors(f: Facts) -> Iterator[Edit]:
    """The givens that are the components of one vector, those in the same place in all components
    of an answer: reversed or left out, taken for the answer, or added to it.
    """
    found = dict[frozenset[Step], tuple[Step, ...]]()
    for key, answer in f.answers.items():
        parts = [x for x in answer.parts if not is_nothing(x)]
        if answer.kind.is_vector and len(parts) > 1 and all(isinstance(x, Step) for x in parts):
            own = dict.fromkeys(_alike(parts))
            for steps in own:
                found.setdefault(frozenset(steps), steps)
            yield from _of_whole_vectors(key, parts, own)
            yield from _of_factors(parts)
            for one, other in combinations(own, 2):
                yield from _of_both(key, parts, one, other)
    for one, other in permutations(found.values(), 2):
        if len(one) == len(other):
            yield from _of_another_vector(one, other)
            a, b = _names(one), _names(other)
            words = Words("exchanges {a} with {b}: each is a vector of its own", a=a, b=b)
            instead = _instead((*one, *other), (*other, *one))
            yield edit(LESS, f"exchanged {a} with {b}", words, instead)
    for steps in found.values():
        names = _names(steps)
        words = Words("takes {names} with the opposite sign: they are one vector", names=names)
        yield edit(SIMPLE, f"turned {names}", words, {s.number: ("neg", s) for s in steps})
        words = Words("leaves out {names}: they are one vector, and not zero here", names=names)
        yield edit(SIMPLE, f"no {names}", words, {s.number: 0.0 for s in steps}, LEFT_OUT, names)


def _instead(steps, expressions):
    return {s.number: x for s, x in zip(steps, expressions, strict=True)}


def _of_another_vector(one, other):
    """The vector from one place to another, for one of them."""
    a, b = _names(one), _names(other)
    words = Words("takes the difference of {a} and {b} for {a}: each is a vector", a=a, b=b)
    pairs = [*zip(one, other, strict=True)]
    for sign, differences in (
        ("-", [("-", s, t) for s, t in pairs]),
        ("+", [("-", t, s) for s, t in pairs]),
    ):
        yield edit(LESS, f"{a} {sign} {b}", words, _instead(one, differences))


def _of_both(key, parts, one, other):
    """The mean of two vectors, or their products in pairs, for the answer."""
    a, b, pairs = _names(one), _names(other), [*zip(one, other, strict=True)]
    for kind, text, both in (
        ("mean", MEAN, [("*", ("+", s, t), 0.5) for s, t in pairs]),
        ("pairs", PAIRS, [("*", s, t) for s, t in pairs]),
    ):
        words = Words(text, a=a, b=b, key=key)
        yield edit(LEAST, f"{kind} {a} {b} for {key}", words, _instead(parts, both))


def _of_factors(steps):
    """Such givens as factors: left out of the products in one place of each component."""
    ops = {s.op for s in steps}
    for k, own in enumerate(zip(*(s.args for s in steps), strict=False) if len(ops) == 1 else ()):
        if not all(isinstance(x, Step) for x in own):
            continue
        if ops == {"*"} and len(set(own)) == len(own) and {x.op for x in own} == {"argument"}:
            names = _names(own)
            words = Words("leaves out the factors {names}: they are one vector", names=names)
            instead = {s.number: s.args[1 - k] for s in steps}
            yield edit(LESS, f"without {names} {[*instead]}", words, instead)
        yield from _of_factors(own)


def _of_whole_vectors(key, parts, vectors):
    for steps in vectors:
        names = _names(steps)
        words = Words(
            "takes {names} for {key}: look up what {key} stands for", names=names, key=key
        )
        yield edit(LESS, f"{names} for {key}", words, _instead(parts, steps))
        words = Words("adds {names} to {key}: {key} alone is asked for", names=names, key=key)
        added = [("+", x, s) for x, s in zip(parts, steps, strict=True)]
        yield edit(LESS, f"{names} and {key}", words, _instead(parts, added))


def _alike(steps):
    """The arguments, all different, in the same place of several expressions."""
    ops = {s.op for s in steps}
    if ops == {"argument"}:
        if len(set(steps)) == len(steps):
            yield tuple(steps)
    elif len(ops) == 1:
        for args in zip(*(s.args for s in steps), strict=False):
            if all(isinstance(a, Step) for a in args):
                yield from _alike(args)


def of_one_unit(f: Facts) -> Iterator[Edit]:
    """All givens in one unit used unconverted."""
    what = Words("what is given")
    for stated in dict.fromkeys(u.text for u in f.read.values()):
        steps = [s for n, s in f.given.items() if f.read[n].text == stated]
        if len(steps) < 2:
            continue
        for ratio in _ratios(unit(stated), f.system):
            instead: dict[int, Any] = {s.number: ("*", s, ratio) for s in steps}
            yield Edit(SIMPLE, unconverted(what, stated), instead)
            cause = Cause("unit", f"{stated} back", Words(INVERTED, name=what, unit=stated))
            yield Edit(LESS + 1, cause, {s.number: ("*", s, ratio * ratio) for s in steps})
        if _is_of_turns(unit(stated)):
            instead = {s.number: ("*", s, 0.5 / pi) for s in steps}
            yield edit(SIMPLE, f"2 pi of all in {stated}", Words(TWO_PI, name=stated), instead)
