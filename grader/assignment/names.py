"""The names under which a formula has the numbers of a traced computation."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from newton_euler.algebra.trace import Step

_ByQuantity = dict[int, dict[str, dict[int, Any]]]


@dataclass
class Names:
    """The symbols of traced numbers.

    fixed : of givens, and of the unknowns of equations
    found : of the components of quantities: {number: {quantity: {place: symbol}}}
    opposite : the same for numbers that have the other sign, with a minus sign
    """

    fixed: dict[int, Any]
    found: _ByQuantity = field(default_factory=dict)
    opposite: _ByQuantity = field(default_factory=dict)
    sizes: dict[str, int] = field(default_factory=dict)  # of the quantities
    uses: Counter[str] = field(default_factory=Counter)
    place: int = 0  # of the component that is written
    size: int = 1  # of its quantity

    def add(self, key: str, parts: Sequence[Any], symbols: Sequence[Any]) -> None:
        """Gives names to the components of a quantity."""
        self.sizes[key] = len(parts)
        for n, (x, symbol) in enumerate(zip(parts, symbols, strict=True)):
            inner, sign = unsigned(x)
            if isinstance(inner, Step):
                self.found.setdefault(x.number, {}).setdefault(key, {})[n] = symbol
            if isinstance(inner, Step) and sign < 0 and inner.number not in self.fixed:
                self.opposite.setdefault(inner.number, {}).setdefault(key, {})[n] = -symbol

    def look_at(self, parts: Sequence[Any]) -> None:
        """Counts for the formulas of a quantity how many numbers of each earlier one they have: of
        quantities that are partly equal, the one that is used most is meant.
        """
        self.size, self.uses = len(parts), Counter()
        seen, waiting = set(), [*parts]
        while waiting:
            a = waiting.pop()
            if isinstance(a, (tuple, list)):
                waiting += a
            elif isinstance(a, Step) and a.number not in seen:
                seen.add(a.number)
                self.uses.update(list(self._candidates(a)))
                waiting += () if self.of(a) is not None else a.args

    def of(self, x: Step) -> Any:
        """The name of a traced number, None if it has none."""
        if x.number in self.fixed:
            return self.fixed[x.number]
        candidates = self._candidates(x)
        if not candidates or (x.op == "neg" and x.args[0].number in self.fixed):
            return None
        if self.size == 9 and not (candidates := self._in_place(candidates)):
            return None
        used = max(self.uses[k] for k in candidates)
        key, *others = (k for k in candidates if self.uses[k] == used)
        if others and x.args and all(self._is_plain(a) for a in x.args):
            return None  # as b/2, of two bodies that lie side by side
        if (self.size, self.sizes[key]) == (9, 3) and len(candidates[key]) > 1 and x.args:
            return None  # of which axis it is does not show
        return self._at_place(candidates[key], self.sizes[key])

    def _in_place(self, candidates):
        """Without the entries of other matrices that stand elsewhere in these, and so are equal by
        chance; the latest first.
        """
        return {
            k: by_place
            for k, by_place in reversed(candidates.items())
            if self.sizes[k] != 9 or self.place in by_place
        }

    def _is_plain(self, a):
        return not isinstance(a, Step) or a.number in self.fixed

    def _candidates(self, x):
        return self.found.get(x.number) or self.opposite.get(x.number, {})

    def _at_place(self, by_place, size):
        """The component of the same axis; of a matrix that multiplies a vector, that of the row."""
        rows = (
            {n // 3: x for n, x in reversed(by_place.items())}
            if (size, self.size) == (9, 3)
            else {}
        )
        return (rows or by_place).get(self.place, next(iter(by_place.values())))


def unsigned(x: Any) -> tuple[Any, int]:
    """A traced number without its minus sign, and the sign."""
    return (x.args[0], -1) if isinstance(x, Step) and x.op == "neg" else (x, 1)
