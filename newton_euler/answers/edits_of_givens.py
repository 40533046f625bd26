"""Slips in what is given: one for another, twice or half of it, its sign, its unit, weight for
mass.
"""

from collections.abc import Callable, Iterator, Mapping
from math import pi
from typing import Any

from ..algebra.trace import Step
from ..algebra.units import SI, US, Dimension, System, Unit, unit
from .causes import unconverted
from .formulas import LESS, RARER, SIMPLE, Edit

MASS, LENGTH = Dimension(1), Dimension(0, 1)
FORCE, GRAVITY = Dimension(1, 1, -2), Dimension(0, 1, -2)
G = 9.81  # m/s^2, where the text gives none
CONFUSED = {"km": "mi", "mi": "km", "in": "ft", "ft": "in", "mm": "cm", "cm": "mm"}

Slip = tuple[int, str, Any, Any]  # rank, kind, words or cause, what stands for the given


def of_given(
    s: Step,
    given: Mapping[str, Step],
    read: Mapping[str, Unit],
    number: Callable[[Step], Any],
    means: str,
) -> Iterator[Slip]:
    """One given for another, twice or half of it, its sign, weight for mass; ``means`` are its
    words in the text.
    """
    name, own = s.args[0], read[s.args[0]]
    is_it = f"{name} is the {means}" if means else f"the formula has {name} there"
    not_one = "it is not 1 here" if own.dimension == Dimension() else "then the units do not fit"
    for other, step in given.items():
        if other != name and read[other].dimension == own.dimension:
            rank = RARER if read[other].text == own.text else LESS
            yield rank, f"given {other}", f"takes {other} for {name}: {is_it}", step
    if own.dimension != MASS:
        words = f"takes {name} with the opposite sign: the text gives its sense"
        yield RARER, "sign", words, ("neg", s)
    rank = RARER if own.dimension == LENGTH else LESS
    yield rank, "doubled", f"takes twice {name}: {is_it}", ("*", s, 2.0)
    yield rank, "halved", f"takes half of {name}: {is_it}", ("*", s, 0.5)
    yield LESS, "zero", f"leaves out {name}: it is not zero here", ("*", s, 0.0)
    yield LESS, "one", f"leaves out the factor {name}: {not_one}", ("/", s, number(s))
    if own.dimension in (MASS, FORCE):
        g = next((number(x) for n, x in given.items() if read[n].dimension == GRAVITY), G)
        is_weight = own.dimension == FORCE
        words = (
            f"takes {name} for a mass: it is a weight" if is_weight else f"multiplies {name} by g"
        )
        yield RARER, "g", words if is_weight else f"{words}: it is a mass already", ("*", s, g)
        why = "it is a force already" if is_weight else "it is a mass, not a weight"
        yield LESS, "g", f"divides {name} by g: {why}", ("/", s, g)


def of_unit(s: Step, own: Unit, system: System) -> Iterator[Slip]:
    """A given used with its number in another unit."""
    name, factor = s.args[0], own.to_base(1.0, system)
    for ratio in _ratios(own, system):
        yield SIMPLE, "unit", unconverted(name, own.text), ("*", s, ratio)
        words = f"converts {name} from {own.text} the wrong way: its factor is inverted"
        yield LESS, "wrong way", words, ("*", s, ratio * ratio)
    if own.is_of_turning and abs(factor - pi / 180) > 1e-9:
        words = f"leaves out 2*pi in {name}: a revolution is 2*pi radians"
        yield SIMPLE, "2 pi", words, ("*", s, 0.5 / pi)
    for part in own.parts:
        if part in CONFUSED:
            other = CONFUSED[part]
            words = f"takes {other} for {part} in {name}: it is given in {own.text}"
            ratio = unit(other).to_base(1.0, SI) / unit(part).to_base(1.0, SI)
            yield LESS, f"confused {part}", words, ("*", s, ratio)
        if part != own.text and unit(part).to_base(1.0, system) != 1:
            words = f"does not convert the {part} in {name}: the rest is in other units"
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


def of_one_unit(
    given: Mapping[str, Step], read: Mapping[str, Unit], system: System
) -> Iterator[Edit]:
    """All givens in one unit with their numbers."""
    for stated in dict.fromkeys(u.text for u in read.values()):
        steps = [s for n, s in given.items() if read[n].text == stated]
        for ratio in _ratios(unit(stated), system) if len(steps) > 1 else ():
            cause = unconverted("what is given", stated)
            yield Edit(SIMPLE, cause, {s.number: ("*", s, ratio) for s in steps})
