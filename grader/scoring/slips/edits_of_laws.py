"""Answers by another law: products of powers of a few givens that have the right dimension, the
roots of such products, and sums of two givens.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import permutations, product
from typing import Any, NamedTuple

from newton_euler.algebra.language import Words
from newton_euler.algebra.trace import Step
from newton_euler.algebra.units import Unit, unit
from newton_euler.answers.near import LEAST, LESS

from .facts import Facts
from .formulas import Edit, edit

MOST = 8  # givens: of more, no laws are tried
FACTORS = 3  # the most in a law, besides a pure number
POWERS = (1, -1, 2, -2)
LAWS = 12  # the most for one answer, the simplest ones
CONSTANTS = 1.0, 0.5, 2.0
OF_ROOTS = *CONSTANTS, 0.25, 4.0
OTHER = Words("takes {law} for {key}: look up the law that gives {key}")

Powers = tuple[float, ...]
Factors = tuple[tuple[str, int], ...]


class Law(NamedTuple):
    """A product of powers of givens, {given: power}, or its root."""

    powers: Factors
    is_root: bool

    @property
    def size(self) -> int:
        """How long it is to write."""
        return sum(1 + abs(p) for _, p in self.powers) + self.is_root

    def written(self, constant: float = 1.0, function: str = "") -> str:
        """The law as it is typed, times a constant, with a function of an angle as a factor."""
        over = [f"{n}^{p}" if p > 1 else n for n, p in self.powers if p > 0]
        under = [f"{n}^{-p}" if p < -1 else n for n, p in self.powers if p < 0]
        over[:0] = [f"{constant:g}"] if constant > 1 else []
        under[:0] = [f"{1 / constant:g}"] if constant < 1 else []
        over += [function] if function and not self.is_root else []
        below = f"/({'*'.join(under)})" if len(under) > 1 else "".join(f"/{n}" for n in under)
        text = ("*".join(over) or "1") + below
        text = f"sqrt({text})" if self.is_root else text
        return f"{text}*{function}" if function and self.is_root else text

    def of(self, given: Mapping[str, Step], constant: float = 1.0) -> Any:
        """The expression of these givens."""
        whole: Any = constant
        for n, p in self.powers:
            whole = ("*", whole, given[n] if p == 1 else ("**", given[n], float(p)))
        return ("sqrt", ("abs", whole)) if self.is_root else whole


def of_laws(f: Facts) -> Iterator[Edit]:
    """Each answer that is one number by the simplest other laws, also with the sine or cosine of a
    given angle. Of a formula they would only repeat what the student wrote.
    """
    given = f.anything
    angles = [n for n in given if f.read[n].is_of_angle]
    plain = {n: _powers(f.read[n]) for n in given if f.read[n].text != "deg"}
    for key, answer in f.answers.items() if len(plain) <= MOST else ():
        x, *others = answer.parts
        own = _powers(unit(answer.unit))
        if others or answer.points > 1 or not isinstance(x, Step) or not any(own):
            continue
        for a, b in permutations([n for n in plain if plain[n] == own], 2):
            pair = given[a], given[b]
            yield _edit(key, x, f"{a} - {b}", ("-", *pair), LESS)
            if a < b:
                yield _edit(key, x, f"{a} + {b}", ("+", *pair), LESS)
                yield _edit(key, x, f"({a} + {b})/2", ("*", ("+", *pair), 0.5), LESS)
        for law in _laws(plain, own):
            for c in OF_ROOTS if law.is_root else CONSTANTS:
                yield _edit(key, x, law.written(c), law.of(given, c), LEAST + 2 + (c != 1))
            for function, angle in product(("sin", "cos"), angles):
                turned = ("*", law.of(given), (function, given[angle]))
                yield _edit(key, x, law.written(1.0, f"{function}({angle})"), turned, LEAST + 3)


def _edit(key, x, law, expression, rank):
    return edit(
        rank, f"law {law} for {key}", Words(OTHER, law=law, key=key), {x.number: expression}
    )


def _powers(of: Unit) -> Powers:
    return tuple(map(float, of.dimension.powers))


def _laws(plain: Mapping[str, Powers], own: Powers) -> Sequence[Law]:
    """The simplest laws that give this dimension."""
    order = [*plain]
    factors = {(n, p): tuple(p * x for x in plain[n]) for n in order for p in POWERS}
    giving: dict[Powers, list[tuple[str, int]]] = {}
    for factor, dimension in factors.items():
        giving.setdefault(dimension, []).append(factor)
    found = list[Law]()
    begun: list[tuple[Factors, Powers]] = [((), (0.0, 0.0, 0.0))]
    for _ in range(FACTORS):
        longer = []
        for some, total in begun:
            after = order.index(some[-1][0]) + 1 if some else 0
            for whole, is_root in (own, False), (tuple(2 * x for x in own), True):
                rest = tuple(a - b for a, b in zip(whole, total, strict=True))
                last = [x for x in giving.get(rest, ()) if order.index(x[0]) >= after]
                found += [Law((*some, x), is_root) for x in last]
            for x in ((n, p) for n in order[after:] for p in POWERS):
                sum_of = tuple(a + b for a, b in zip(total, factors[x], strict=True))
                longer.append(((*some, x), sum_of))
        begun = longer
    real = (law for law in found if not law.is_root or any(p % 2 for _, p in law.powers))
    return sorted(real, key=lambda law: law.size)[:LAWS]
