"""Names in formulas for the numbers of a traced computation."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import permutations
from operator import mul, truediv
from typing import Any

from newton_euler.algebra.trace import Step
from newton_euler.answers.kinds import KINDS, Kind
from newton_euler.classroom.practising.programs import operate

ROUND_OFF = 1e-12

_ByQuantity = dict[int, dict[str, dict[int, Any]]]


@dataclass
class Names:
    """The symbols of traced numbers.

    fixed : of givens, and of the unknowns of equations
    found : of the components of quantities: {number: {quantity: {place: symbol}}}
    opposite : the same for numbers with the opposite sign, with a minus sign
    sheets : unrelated numbers for the givens, and the traced numbers that follow from them
    by_value : {numbers on the sheets: {name: its place in a matrix}}
    kinds : by quantity
    uses : how often each occurs in the quantity that is written
    place, kind : index of the component that is written, kind of its quantity
    whole : the numbers of its components on the sheets
    indices : the indices of its name, as AB of I_AB
    apart : the quantities that are not used now, and the names of their components
    scalars : the quantities that are one number, on the sheets
    givens : {numbers on the sheets: given}
    """

    fixed: dict[int, Any]
    sheets: Sequence[tuple[Any, dict]]
    found: _ByQuantity = field(default_factory=dict)
    opposite: _ByQuantity = field(default_factory=dict)
    kinds: dict[str, Kind] = field(default_factory=dict)
    uses: Counter[str] = field(default_factory=Counter)
    place: int = 0
    kind: Kind = KINDS["number"]
    whole: set[tuple[str, ...]] = field(default_factory=set)
    indices: set[str] = field(default_factory=set)
    apart: set[str] = field(default_factory=set)
    scalars: list[tuple[Any, Sequence[float]]] = field(default_factory=list)
    givens: dict[tuple[str, ...], Any] = field(default_factory=dict)
    by_value: dict[tuple[str, ...], dict[Any, int | None]] = field(default_factory=dict)

    def give(self, x: Step, symbol: Any) -> None:
        """Name a given."""
        self.fixed[x.number] = symbol
        if numbers := self._numbers(x):
            self.givens[_rounded(numbers)] = symbol

    def add(self, key: str, kind: Kind, parts: Sequence[Any], symbols: Sequence[Any]) -> None:
        """Name the components of a quantity."""
        self.kinds[key] = kind
        for n, (x, symbol) in enumerate(zip(parts, symbols, strict=True)):
            inner, sign = unsigned(x)
            if numbers := self._numbers(x):
                place = n if kind.is_matrix else None
                self.by_value.setdefault(_rounded(numbers), {})[symbol] = place
                self.scalars += [(symbol, numbers)] * (len(parts) == 1 and 0 not in numbers)
            if isinstance(inner, Step):
                self.found.setdefault(x.number, {}).setdefault(key, {})[n] = symbol
            if isinstance(inner, Step) and sign < 0:
                self.opposite.setdefault(inner.number, {}).setdefault(key, {})[n] = -symbol

    def look_at(self, key: str, kind: Kind, parts: Sequence[Any]) -> None:
        """Count how often a quantity's formulas use each earlier one: of partly equal quantities
        the most used is meant, or of equally used ones the one with the same index.
        """
        self.place, self.kind, self.uses = 0, kind, Counter()
        self.whole = {_rounded(self._numbers(x)) for x in parts} - {()}
        self.indices = _indices(key)
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
        """The name of a traced number, or None."""
        candidates = self._candidates(x)
        if x.number in self.fixed:
            return self._component(candidates) or self.fixed[x.number]
        if not candidates or (x.op == "neg" and x.args[0].number in self.fixed):
            return None
        if self.kind.is_matrix and not (candidates := self._in_place(candidates)):
            return None
        same = [k for k in candidates if self.indices and _indices(k) == self.indices]
        used = max(self.uses[k] for k in candidates)
        key, *others = (k for k in candidates if self.uses[k] == used)
        steps = [a for a in x.args if isinstance(a, Step)]
        is_plain = x.args and all(a.number in self.fixed for a in steps)
        if len(candidates) > 1 and len(same) != 1 and is_plain and (others or self.kind.length > 1):
            return None  # b/2, say, of two bodies side by side
        same = [k for k in same if k in (key, *others)] or [
            k
            for k in (key, *others)
            if self.kind.is_vector and "xyz"[self.place] in k.split("_")[-1]
        ]
        if others and len(same) == 1:
            key, others = same[0], []
        is_of_vector = self.kind.is_matrix and self.kinds[key].is_vector
        if is_of_vector and len(candidates[key]) > 1 and x.args:
            return None  # the axis is ambiguous
        return self._at_place(candidates[key], self.kinds[key])

    def _component(self, candidates):
        """In an entry of a matrix the component of the vector with its index that a given is, on
        the axes of that entry, as d_y and d_z in I_xx; None if there are two.
        """
        own = [x for k, x in candidates.items() if self.indices and _indices(k) == self.indices]
        if not self.kind.is_matrix or len(own) != 1:
            return None
        entry = {*divmod(self.place, 3)}
        axes = {0, 1, 2} - entry if len(entry) == 1 else entry
        found = [x for axis, x in own[0].items() if axis in axes]
        return found[0] if len(found) == 1 else None

    def of_body(self, x: Any, factor: Any) -> Any:
        """The component at this place of the vector that has the index of a factor, as d_block_x
        beside V_block, even if it is a given; or None.
        """
        whole = self.of(unsigned(factor)[0]) if isinstance(factor, Step) else None
        indices = _indices(getattr(whole, "name", ""))
        if not self.kind.is_vector or not isinstance(x, Step) or not indices:
            return None
        same = {key: at for key, at in self._candidates(x).items() if _indices(key) == indices}
        found = [
            at[self.place]
            for key, at in same.items()
            if self.kinds[key].is_vector and self.place in at
        ]
        return found[0] if len(found) == 1 else None

    def equal(self, x: Step) -> Any:
        """The name of the given, or for a sum of the single earlier quantity, with the same value
        on all sheets, however it was computed; or None. Products, sums of named quantities, and
        whole quantities equal others by chance only.
        """
        numbers, here = self._numbers(x), self.place if self.kind.is_matrix else None
        is_whole = _rounded(numbers) in self.whole
        given = self.givens.get(_rounded(numbers))
        parts = [a for a in x.args if isinstance(a, Step)]
        is_multiple = len(parts) == 1 and self.of(parts[0]) is not None
        if given is not None and not is_multiple and not (is_whole and self.kind.length == 1):
            return given
        inner = (unsigned(a)[0] for a in parts)
        if x.op not in "+-" or is_whole or all(self.of(a) is not None for a in inner):
            return None
        for sign in (1, -1):
            found = self.by_value.get(_rounded(numbers, sign), {})
            names = {name: x for name, x in found.items() if name.name not in self.apart}
            if len(names) == 1 and here in names.values():
                return sign * next(iter(names))
        return None

    def of_two(self, x: Any) -> Any:
        """A number as the ratio or product of two earlier ones, however computed; or None."""
        numbers = self._numbers(x)
        for (a, of_a), (b, of_b) in permutations(self.scalars if numbers else (), 2):
            if _rounded(numbers) == _rounded(map(truediv, of_a, of_b)):
                return a / b
            if _rounded(numbers) == _rounded(map(mul, of_a, of_b)):
                return a * b
        return None

    def vanishes(self, x: Any) -> bool:
        """True if two numbers cancel on all sheets up to round-off."""
        if not isinstance(x, Step) or x.op not in "+-" or not (sizes := self._numbers(x.args[0])):
            return False
        rest = [value_of(x, *sheet) for sheet in self.sheets]
        pairs = zip(rest, sizes, strict=True)
        return all(n is not None and abs(n) <= ROUND_OFF * abs(size) for n, size in pairs)

    def _numbers(self, x):
        """A traced number on the sheets; () if it is the same on all, or undefined on one."""
        found = [value_of(x, *sheet) for sheet in self.sheets] if isinstance(x, Step) else []
        return () if None in found or len({*found}) < 2 else found

    def _in_place(self, candidates):
        """The candidates without entries at other places of other matrices, which are equal by
        chance; the latest first.
        """
        return {
            k: by_place
            for k, by_place in reversed(candidates.items())
            if not self.kinds[k].is_matrix or self.place in by_place
        }

    def _candidates(self, x):
        found, other = self.found.get(x.number, {}), self.opposite.get(x.number, {})

        def in_row(key, at):
            return self.kinds[key].is_matrix and any(n // 3 == self.place for n in at)

        if self.kind.is_vector:  # from a matrix take the entry in this row, -T_zx and not T_xz
            own = {key for key, at in found.items() if in_row(key, at)}
            found = found | {k: at for k, at in other.items() if in_row(k, at) and k not in own}
        return {key: x for key, x in (found or other).items() if key not in self.apart}

    def _at_place(self, by_place, kind):
        """The component of the same axis; of a matrix in a vector's formula, that of the row."""
        rows = (
            {n // 3: x for n, x in reversed(by_place.items())}
            if kind.is_matrix and self.kind.is_vector
            else {}
        )
        return (rows or by_place).get(self.place, next(iter(by_place.values())))


def unsigned(x: Any) -> tuple[Any, int]:
    """A traced number without its minus sign, and the sign."""
    return (x.args[0], -1) if isinstance(x, Step) and x.op == "neg" else (x, 1)


def _indices(key):
    """The indices of a name, as {"AB"} of I_AB."""
    return {*key.split("_")[1:]}


def _rounded(numbers, sign=1):
    """Numbers rounded for comparison."""
    return tuple(f"{sign * x:.11g}" for x in numbers)


def value_of(x: Any, values: Any, memo: dict[int, float | None]) -> float | None:
    """The number of a traced quantity for these givens, or None if it is undefined."""
    if not isinstance(x, Step):
        return float(x)
    if x.number not in memo:
        try:
            args = (
                [getattr(values, x.args[0])] if x.op == "argument"
                else [value_of(a, values, memo) for a in x.args]
            )  # fmt: skip
            memo[x.number] = operate("value" if x.op == "argument" else x.op, *args)
        except (TypeError, ValueError, ArithmeticError, KeyError):
            memo[x.number] = None
    return memo[x.number]
