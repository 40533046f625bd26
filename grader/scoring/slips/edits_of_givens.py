"""Slips in the givens: one for another, twice or half of one, sign, unit, weight for mass."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import combinations, permutations, product
from math import pi
from typing import Any

from newton_euler.algebra.language import Words, joined
from newton_euler.algebra.trace import Step
from newton_euler.algebra.units import SI, US, Dimension, System, Unit, unit
from newton_euler.answers.causes import FACTOR_2, LEFT_OUT, ZERO, Cause, computed, unconverted
from newton_euler.answers.near import LEAST, LESS, RARER, SIMPLE

from .formulas import Edit
from .typed import is_nothing, terms_of

MASS, LENGTH = Dimension(1), Dimension(0, 1)
TIME = Dimension(0, 0, 1)
FORCE, GRAVITY = Dimension(1, 1, -2), Dimension(0, 1, -2)
RATES = Dimension(0, 0, -1), Dimension(0, 0, -2)
TWICE, HALF, ONE, FOREIGN = "doubled", "halved", "one", "foreign unit"
G, G_OF_FEET = 9.81, 32.2  # of g, where the text gives none
OTHERS = {  # units from which a number is converted that is already in this one
    "rad/s": ("rev/min", "rev/s"), "rad": ("deg",), "m": ("mm", "cm"), "ft": ("in",),
    "m/s": ("km/h",), "ft/s": ("mi/h",), "s": ("min",), "kg": ("g",),
}  # fmt: skip
CONFUSED = {"km": "mi", "mi": "km", "in": "ft", "ft": "in", "mm": "cm", "cm": "mm"}

OF_TURNS = {"s": "min"}  # what a rate of turning is divided by

MANY = 9  # lengths: of more, not even whole ones are added
SEVERAL = 6  # lengths, or pairs of rates: of more, no sums are tried

TWO_PI = Words("leaves out 2*pi in {name}: a revolution is 2*pi radians").template
INVERTED = Words("converts {name} from {unit} the wrong way: its factor is inverted").template
FROM = Words("converts {name} from {other}: it is given in {unit}").template
SLANT = Words(
    "takes the slant length sqrt({name}^2 + {other}^2) for {name}: another distance counts"
).template
LEG = Words(
    "takes the leg sqrt({name}^2 - {other}^2) for {name}: look where the right angle is"
).template
HALVES = Words("takes half of {name} and of {other}: a radius is not a diameter").template
TWICE_BOTH = Words("takes twice {name} and {other}: a diameter is not a radius").template
AS_EQUAL = Words("takes {name} and {other} as equal: the text gives two lengths").template
PLACE = Words("takes {name} {op} {part} for {name}: it leads to another point").template
LOAD = Words("takes {name} {op} {part} for {name}: look which bodies count there").template
MEAN = Words("takes the mean of {a} and {b} for {key}: look up what {key} stands for").template
PAIRS = Words(
    "multiplies {a} by {b}, each by each, for {key}: look up what {key} stands for"
).template
NOT_ONE, NO_FIT = Words("it is not 1 here"), Words("then the units do not fit")

DimensionOf = Callable[[Step], Dimension | None]
# rank, kind, words or cause, its replacement; of some what they do, and to what
Slip = tuple[int, str, Any, Any] | tuple[int, str, Words, Any, str, str]


def of_given(
    s: Step,
    given: Mapping[str, Step],
    read: Mapping[str, Unit],
    number: Callable[[Step], Any],
    means: str,
    one: float,
) -> Iterator[Slip]:
    """One given for another, twice or half of it, its sign, weight for mass; ``means`` is its
    meaning in the text, ``one`` its unit in base units.
    """
    name, own = s.args[0], read[s.args[0]]
    is_it = Words("the formula has {name} there", name=name)
    if means:
        is_it = Words("{name} is the {means}", name=name, means=means)
    not_one = NOT_ONE if own.dimension == Dimension() else NO_FIT
    for other, step in given.items():
        if read[other].dimension != own.dimension:
            if not _are_confused(read[other].dimension, own.dimension):
                continue  # few would, and many would be met by chance
            words = Words("takes {other} for {name}: {why}", other=other, name=name, why=NO_FIT)
            yield LEAST, f"given {other}", words, step
        elif other != name:
            rank = RARER if read[other].text == own.text else LESS
            words = Words("takes {other} for {name}: {why}", other=other, name=name, why=is_it)
            yield rank, f"given {other}", words, step
            if own.is_of_angle:
                words = Words("takes {name} - {other} for {name}: {why}",
                              name=name, other=other, why=is_it)  # fmt: skip
                yield LEAST, f"less {other}", words, ("-", s, step)
    if own.dimension == Dimension() and not own.is_of_angle:
        words = Words("inverts {name}: {why}", name=name, why=is_it)
        yield LEAST, "inverse", words, ("/", 1.0, s)
    yield from _of_sign(s, own.dimension)
    rank = RARER if own.dimension == LENGTH else LESS
    twice = Words("takes twice {name}, or has a 2 too many beside it: {why}", name=name, why=is_it)
    yield rank, TWICE, twice, ("*", s, 2.0), FACTOR_2, name
    half = Words("takes half of {name}, or lacks a factor 2 beside it: {why}", name=name, why=is_it)
    yield rank, HALF, half, ("*", s, 0.5), FACTOR_2, name
    words = Words("leaves out {name}: it is not zero here", name=name)
    yield LESS, "zero", words, ("*", s, 0.0), ZERO, name
    yield (
        LESS,
        ONE,
        computed(
            f"{ONE} {s.number}",
            Words("leaves out the factor {name}: {why}", name=name, why=not_one),
            f"without {s.number}",
        ),
        ("/", s, number(s)),
    )
    if name == "g" and own.dimension == GRAVITY:
        words = Words("takes 10 for {name}: the text gives more digits", name=name)
        if own.text == "m/s^2":
            yield LESS, "ten", words, 10.0
        elsewhere, of = (G, "m/s^2") if own.is_of_feet else (G_OF_FEET, "ft/s^2")
        words = Words(
            "takes {other} for {name}: that is in {unit}", other=elsewhere, name=name, unit=of
        )
        yield LESS, "g of others", words, elsewhere * one
    if own.dimension in (MASS, FORCE):
        otherwise = G_OF_FEET if own.is_of_feet else G
        g = number(given["g"]) if "g" in given else otherwise
        if own.dimension == FORCE:
            more = Words("takes {name} for a mass: it is a weight", name=name)
            less = Words("divides {name} by g: it is a force already", name=name)
        else:
            more = Words("multiplies {name} by g: it is a mass already", name=name)
            less = Words("divides {name} by g: it is a mass, not a weight", name=name)
        yield LESS, "g", more, ("*", s, g)
        yield LESS, "g", less, ("/", s, g)


def _are_confused(a, b):
    """True of the dimensions of a quantity and its rate, of a length and an area, a mass and a
    weight.
    """
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


def of_rates(given: Mapping[str, Step], read: Mapping[str, Unit]) -> Iterator[Edit]:
    """Angular velocities about different axes added as numbers, alone or with their rates."""
    spins, growths = (
        [*permutations([n for n in given if read[n].dimension == of], 2)] for of in RATES
    )
    for pairs in product(spins, [None, *growths]) if len(spins) <= SEVERAL else ():
        instead: dict[int, Any] = {}
        for a, b in filter(None, pairs):
            instead |= {given[a].number: ("+", given[a], given[b]), given[b].number: 0.0}
        a, b = pairs[0]
        words = Words("adds {a} and {b} as numbers: they turn about different axes", a=a, b=b)
        yield Edit(LEAST, computed(f"added {[*instead]}", words), instead)


def of_lengths(given: Mapping[str, Step], read: Mapping[str, Unit]) -> Iterator[Edit]:
    """A length to another point: another length, or half of it, added or subtracted, or another
    side of a right angle; two lengths taken as equal.
    """
    lengths = [n for n in given if read[n].dimension == LENGTH]
    for name, other in permutations(lengths, 2) if len(lengths) <= SEVERAL else ():
        squares = [("*", given[n], given[n]) for n in (name, other)]
        for op, text in ("+", SLANT), ("-", LEG):
            words = Words(text, name=name, other=other)
            side = ("sqrt", ("abs", (op, *squares)))
            cause = computed(f"slant {name} {op} {other}", words)
            yield Edit(LEAST, cause, {given[name].number: side})
    for name, other in combinations(lengths, 2) if len(lengths) <= SEVERAL else ():
        both = ("*", ("+", given[name], given[other]), 0.5)
        cause = computed(f"equal {name} {other}", Words(AS_EQUAL, name=name, other=other))
        yield Edit(LEAST, cause, {given[n].number: both for n in (name, other)})
        for factor, text in (0.5, HALVES), (2.0, TWICE_BOTH):
            instead = {given[n].number: ("*", given[n], factor) for n in (name, other)}
            words = Words(text, name=name, other=other)
            yield Edit(LEAST + 2, computed(f"{factor} of {name} {other}", words), instead)
    yield from _of_sums(lengths, given, PLACE, len(lengths) <= SEVERAL)


def of_loads(given: Mapping[str, Step], read: Mapping[str, Unit]) -> Iterator[Edit]:
    """The mass, or the weight, of another body added or taken off."""
    for kind in MASS, FORCE:
        yield from _of_sums([n for n in given if read[n].dimension == kind], given, LOAD, False)


def _of_sums(names, given, text, with_halves):
    """Another given of the same kind added or taken off; of many, none."""
    for name, other in permutations(names, 2) if len(names) <= MANY else ():
        parts: list[tuple[str, Any]] = [(other, given[other])]
        parts += [(f"{other}/2", ("*", given[other], 0.5))] if with_halves else []
        for part, x in parts:
            for op in ("+", "-"):
                words = Words(text, name=name, op=op, part=part)
                cause = computed(f"{name} {op} {part}", words)
                yield Edit(LEAST, cause, {given[name].number: (op, given[name], x)})


def of_projections(
    answers: Mapping[str, Sequence[Any]], given: Mapping[str, Step], read: Mapping[str, Unit]
) -> Iterator[Edit]:
    """The component of a given, or of an answer, by a given angle, in its place."""
    angles = [n for n in given if read[n].is_of_angle]
    for (key, parts), angle, f in product(answers.items(), angles, ("cos", "sin")):
        if len(parts) == 1 and isinstance(parts[0], Step):
            part = f"{key}*{f}({angle})"
            words = Words("gives {part}, a component: the whole is asked for", part=part)
            x = ("*", parts[0], (f, given[angle]))
            yield Edit(LESS, computed(f"component {key} {f} {angle}", words), {parts[0].number: x})
    for name, angle in product(given, angles):
        own = read[name].dimension
        for f in ("cos", "sin") if own not in (MASS, TIME, Dimension(), *RATES) else ():
            part = f"{name}*{f}({angle})"
            words = Words("takes {part} for {name}: all of it counts", part=part, name=name)
            x = ("*", given[name], (f, given[angle]))
            yield Edit(LEAST, computed(f"{name} {f} {angle}", words), {given[name].number: x})


def of_weights(
    answers: Mapping[str, Sequence[Any]], masses: Mapping[str, Step], g: Any, of: DimensionOf
) -> Iterator[Edit]:
    """The weight of a given mass put into a component of a force, upward or downward, and g into
    one of an acceleration by forces.
    """
    found = {x: key for key, parts in answers.items() for x in parts if isinstance(x, Step)}
    for (x, key), op in product(found.items() if masses else (), "+-"):
        if of(x) == GRAVITY:
            words = Words("puts g into {key}: look up what {key} consists of", key=key)
            cause = computed(f"{op} g {x.number}", words)
            yield Edit(LEAST, cause, {x.number: (op, x, g)})
    for (x, key), (name, m) in product(found.items(), masses.items()):
        if of(x) == FORCE:
            words = Words(
                "puts the weight {name}*g into {key}: look up what {key} consists of",
                name=name, key=key,
            )  # fmt: skip
            for op in ("+", "-"):
                cause = computed(f"{op} weight of {name} {x.number}", words)
                yield Edit(LEAST, cause, {x.number: (op, x, ("*", m, g))})


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
        if part != own.text and unit(part).to_base(1.0, system) != 1:
            words = Words(
                "does not convert the {part} in {name}: the rest is in other units",
                part=part, name=name,
            )  # fmt: skip
            yield LESS, f"part {part}", words, ("*", s, 1 / unit(part).to_base(1.0, system))
            yield LESS, f"part {part}", words, ("*", s, unit(part).to_base(1.0, system))


def _is_of_turns(own):
    """True of a unit with revolutions in it, and of radians."""
    return own.is_of_turning and abs(own.to_base(1.0, SI) - pi / 180) > 1e-9


def _ratios(own, system):
    """The factors by which a quantity is wrong if its number is used as if in SI, or in feet and
    pounds.
    """
    found = set()
    for other in (SI, US):
        there = own.to_base(1.0, other)
        meant = float(other.factor(own.dimension) / system.factor(own.dimension))
        ratio = meant / own.to_base(1.0, system)
        if abs(there - 1) > 1e-9 and (other is SI or own.is_of_feet or other is system):
            found.add(ratio)
    return sorted(found)


def of_planes(sums: Iterable[Step]) -> Iterator[Edit]:
    """Of a sum of products of two givens, as a scalar product, both givens of one left out."""
    for s in sums:
        products = [x.args for _, x in terms_of(s) if isinstance(x, Step) and x.op == "*"]
        pairs = [p for p in products if p[0] is not p[1] and all(map(_is_argument, p))]
        for a, b in pairs if len(pairs) > 1 else ():
            names = joined(x.args[0] for x in (a, b))
            words = Words("leaves out {names}: they are not zero here", names=names)
            cause = computed(f"no {a.number} {b.number}", words, "", LEFT_OUT, names)
            yield Edit(LESS, cause, {a.number: 0.0, b.number: 0.0})


def _is_argument(x):
    return isinstance(x, Step) and x.op == "argument"


def of_earlier(given: Mapping[str, Step], components: Mapping[str, str]) -> Iterator[Edit]:
    """An earlier vector of the student's left out, all of its ``components``."""
    for name in dict.fromkeys(components.values()):
        own = [s.number for n, s in given.items() if components.get(n) == name]
        words = Words("leaves out {name}: it is not zero here", name=name)
        cause = computed(f"without {name}", words, name, ZERO, name)
        yield Edit(RARER, cause, dict.fromkeys(own, 0.0))


def of_exchanged(given: Mapping[str, Step], read: Mapping[str, Unit]) -> Iterator[Edit]:
    """Two givens, each in the place of the other."""
    for (a, s), (b, t) in combinations(given.items(), 2):
        words = Words("exchanges {a} and {b}: each has its own place", a=a, b=b)
        if not _are_confused(read[a].dimension, read[b].dimension):
            continue
        rank = LESS if read[a].text == read[b].text else LEAST + 2
        yield Edit(rank, computed(f"exchanged {a} {b}", words), {s.number: t, t.number: s})


def of_vectors(answers: Mapping[str, Sequence[Any]]) -> Iterator[Edit]:
    """The givens that are the components of one vector, those in the same place in all components
    of an answer: reversed or left out, taken for the answer, or added to it.
    """
    found = dict[frozenset[Step], tuple[Step, ...]]()
    for key, components in answers.items():
        parts = [x for x in components if not is_nothing(x)]
        if len(parts) > 1 and all(isinstance(x, Step) for x in parts):
            own = dict.fromkeys(_alike(parts))
            for steps in own:
                found.setdefault(frozenset(steps), steps)
            yield from _of_whole_vectors(key, parts, own) if len(components) == 3 else ()
            yield from _of_factors(parts)
            for one, other in combinations(own, 2) if len(components) == 3 else ():
                yield from _of_both(key, parts, one, other)
    for one, other in permutations(found.values(), 2):
        if len(one) == len(other):
            yield from _of_another_vector(one, other)
            a, b = (joined(s.args[0] for s in steps) for steps in (one, other))
            words = Words("exchanges {a} with {b}: each is a vector of its own", a=a, b=b)
            instead = dict(zip((s.number for s in (*one, *other)), (*other, *one), strict=True))
            yield Edit(LESS, computed(f"exchanged {a} with {b}", words), instead)
    for steps in found.values():
        names = joined(s.args[0] for s in steps)
        turned = Words("takes {names} with the opposite sign: they are one vector", names=names)
        zero = Words("leaves out {names}: they are one vector, and not zero here", names=names)
        yield Edit(
            SIMPLE, computed(f"turned {names}", turned), {s.number: ("neg", s) for s in steps}
        )
        cause = computed(f"no {names}", zero, "", LEFT_OUT, names)
        yield Edit(SIMPLE, cause, {s.number: 0.0 for s in steps})


def _of_another_vector(one, other):
    """The vector from one place to another, for one of them."""
    a, b = (joined(s.args[0] for s in steps) for steps in (one, other))
    words = Words("takes the difference of {a} and {b} for {a}: each is a vector", a=a, b=b)
    for sign, pair in (("-", lambda s, t: ("-", s, t)), ("+", lambda s, t: ("-", t, s))):
        instead = {s.number: pair(s, t) for s, t in zip(one, other, strict=True)}
        yield Edit(LESS, computed(f"{a} {sign} {b}", words), instead)


def _of_both(key, parts, one, other):
    """The mean of two vectors, or their products in pairs, for the answer."""
    a, b = (joined(s.args[0] for s in steps) for steps in (one, other))
    for kind, text, op in ("mean", MEAN, "+"), ("pairs", PAIRS, "*"):
        words = Words(text, a=a, b=b, key=key)
        both = [(op, s, t) for s, t in zip(one, other, strict=True)]
        both = [("*", x, 0.5) for x in both] if op == "+" else both
        instead = {x.number: y for x, y in zip(parts, both, strict=True)}
        yield Edit(LEAST, computed(f"{kind} {a} {b} for {key}", words), instead)


def _of_factors(steps):
    """Such givens as factors: left out of the products in one place of each component."""
    ops = {s.op for s in steps}
    for k, own in enumerate(zip(*(s.args for s in steps), strict=False) if len(ops) == 1 else ()):
        if not all(isinstance(x, Step) for x in own):
            continue
        if ops == {"*"} and len(set(own)) == len(own) and {x.op for x in own} == {"argument"}:
            names = joined(x.args[0] for x in own)
            words = Words("leaves out the factors {names}: they are one vector", names=names)
            instead = {s.number: s.args[1 - k] for s in steps}
            yield Edit(LESS, computed(f"without {names} {[*instead]}", words), instead)
        yield from _of_factors(own)


def _of_whole_vectors(key, parts, vectors):
    for steps in vectors:
        names = joined(s.args[0] for s in steps)
        alone = Words(
            "takes {names} for {key}: look up what {key} stands for", names=names, key=key
        )
        more = Words("adds {names} to {key}: {key} alone is asked for", names=names, key=key)
        pairs = [*zip(parts, steps, strict=True)]
        yield Edit(LESS, computed(f"{names} for {key}", alone), {x.number: s for x, s in pairs})
        added = {x.number: ("+", x, s) for x, s in pairs}
        yield Edit(LESS, computed(f"{names} and {key}", more), added)


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


def of_one_unit(
    given: Mapping[str, Step], read: Mapping[str, Unit], system: System
) -> Iterator[Edit]:
    """All givens in one unit used unconverted."""
    for stated in dict.fromkeys(u.text for u in read.values()):
        steps = [s for n, s in given.items() if read[n].text == stated]
        for ratio in _ratios(unit(stated), system) if len(steps) > 1 else ():
            cause = unconverted(Words("what is given"), stated)
            yield Edit(SIMPLE, cause, {s.number: ("*", s, ratio) for s in steps})
            words = Words(INVERTED, name=Words("what is given"), unit=stated)
            cause = Cause("unit", f"{stated} back", words)
            yield Edit(LESS + 1, cause, {s.number: ("*", s, ratio * ratio) for s in steps})
        if len(steps) > 1 and _is_of_turns(unit(stated)):
            cause = computed(f"2 pi of all in {stated}", Words(TWO_PI, name=stated))
            yield Edit(SIMPLE, cause, {s.number: ("*", s, 0.5 / pi) for s in steps})
