"""Equal components, distinguished by their places in a formula: v_x^2 + v_y^2 where v_x is the
given v too, and omega_z v_x along y where v_y = -v_x.
"""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from typing import Any

from newton_euler.algebra.late import sympy
from newton_euler.answers.kinds import Kind

from .names import unsigned


@dataclass
class Roles:
    """The components of the vectors shown so far.

    vectors : {vector: its components}
    places : {component: (its vector, its axis)}
    formulas : {component: its formula}
    equal : {number of a traced scalar: its names, each with its sign}
    """

    vectors: dict[str, Sequence[Any]] = field(default_factory=dict)
    places: dict[Any, tuple[str, int]] = field(default_factory=dict)
    formulas: dict[Any, Any] = field(default_factory=dict)
    equal: dict[int, list[tuple[Any, int]]] = field(default_factory=dict)

    def give(self, x: Any, symbol: Any) -> None:
        """Add a given."""
        self.equal[x.number] = [(symbol, 1)]

    def add(
        self, key: str, parts: Sequence[Any], symbols: Sequence[Any], formulas: Sequence[Any]
    ) -> None:
        """Add a vector by its traced components, their names and formulas, if it has these."""
        if None in formulas:
            return
        self.vectors[key] = symbols
        self.formulas |= dict(zip(symbols, formulas, strict=True))
        for axis, (part, symbol) in enumerate(zip(parts, symbols, strict=True)):
            x, sign = unsigned(part)
            self.places[symbol] = key, axis
            if (number := getattr(x, "number", None)) is not None:
                self.equal.setdefault(number, []).append((symbol, sign))

    def placed(self, formulas: Sequence[Any], kind: Kind, apart: Collection[str]) -> Sequence[Any]:
        """The formulas of all components of a quantity with the names that their places ask for,
        but for those ``apart``.
        """
        if None in formulas or not self.vectors:
            return formulas
        if kind.is_matrix:
            return self._of_one_place(formulas)
        others = self._others(apart)
        if kind.is_vector:
            formulas = self._of_all(formulas)
            formulas = [
                sympy.Add(*(self._crossed(x, n, others) for x in sympy.Add.make_args(f)))
                for n, f in enumerate(formulas)
            ]
        placed = [
            f.replace(lambda x: x.is_Add, lambda x: self._paired([x], others)[0])
            for f in self._paired(formulas, others)
        ]
        before, after = ({x for f in fs for x in f.free_symbols} for fs in (formulas, placed))
        new = {_plain(x) for own in before & after for x in others.get(own, ())}
        return formulas if new & (after - before) else placed  # a given has one name in a formula

    def _others(self, apart):
        """{name: equal components, with their signs}."""
        found: dict[Any, list[Any]] = {}
        for names in self.equal.values():
            for own, sign in names:
                found.setdefault(own, []).extend(
                    sign * n * x
                    for x, n in names
                    if x != own and x in self.places and x.name not in apart
                )
        return found

    def _used(self, formulas):
        return {x for f in formulas for x in f.free_symbols if x in self.places}

    # -- a product of two vectors

    def _crossed(self, term, place, others):
        """A term along an axis with components of two vectors along the other two."""
        factors = [x for x in sympy.Mul.make_args(term) if x in self.places]
        if len({self.places[x][0] for x in factors}) != 2 or len(factors) != 2:
            return term
        if self._are_crossed(place, *factors):
            return term
        for x, y in (factors, factors[::-1]):
            for other in others.get(x, ()):
                same = self.places[_plain(other)][0] == self.places[x][0]
                if same and self._are_crossed(place, _plain(other), y):
                    return term.xreplace({x: other})
        return term

    def _are_crossed(self, place, *factors):
        return len({place, *(self.places[x][1] for x in factors)}) == 3

    # -- a given that is a component

    def _paired(self, formulas, others):
        """Formulas with a component for a given, where another term has another component of its
        vector in the same role: with equal factors, or with those of one other vector.
        """
        sums = [[*sympy.Add.make_args(f)] for f in formulas]
        for terms in sums:
            for n in range(len(terms)):
                rest = [
                    x for other in sums for m, x in enumerate(other) if other is not terms or m != n
                ]
                terms[n] = self._in_its_role(terms[n], rest, others)
        return [sympy.Add(*terms) for terms in sums]

    def _in_its_role(self, term, rest, others):
        for x, power in [] if not self._used(rest) else [*term.as_powers_dict().items()]:
            for other in others.get(x, ()) if x not in self.places else ():
                of = {*self.vectors[self.places[_plain(other)][0]]} - {_plain(other)}
                for sibling in rest:
                    for y, n in sibling.as_powers_dict().items():
                        if y not in of or not 0 < n <= power:
                            continue
                        if self._are_alike(term / x**n, sibling / y**n, others):
                            changed = term / x**n * other**n
                            return self._in_its_role(changed, rest, others)
        return term

    def _are_alike(self, one, other, others):
        """Whether factors are equal but for the sign, or but for components of one vector."""
        if one in (other, -other):
            return True
        pairs = ((x, y) for x in one.free_symbols for y in other.free_symbols if x != y)
        return any(
            self._of(x, others) & self._of(y, others) and one / x in (other / y, -other / y)
            for x, y in pairs
        )

    def _of(self, x, others):
        """The vectors of a component, or of the components that equal a given."""
        own = [x] if x in self.places else map(_plain, others.get(x, ()))
        return {self.places[y][0] for y in own}

    # -- sums over bodies

    def _of_all(self, formulas):
        """A given times the sum of all vectors so far, if a vector is that."""
        if len(self.vectors) < 2 or self._used(formulas):
            return formulas
        sums = [
            sympy.Add(*(x for x in column if self.formulas[x] != 0))
            for column in zip(*self.vectors.values(), strict=True)
        ]
        found = [x.xreplace(self.formulas) for x in sums]
        pairs = [(f, x) for f, x in zip(formulas, found, strict=True) if (f, x) != (0, 0)]
        factors = {sympy.cancel(f / x) if x != 0 else x for f, x in pairs}
        factor = factors.pop() if len(factors) == 1 else sympy.Integer(0)
        return [factor * x for x in sums] if factor.is_Symbol else formulas

    def _of_one_place(self, formulas):
        """A matrix of inertia by the place of its centre of mass, d: I + m (d^2 - d d)."""
        for d in sorted({self.places[x][0] for x in self._used(formulas)}):
            names = [x if self.formulas[x] != 0 else 0 for x in self.vectors[d]]
            square = sum(x**2 for x in names)
            others = {x for f in formulas for x in f.free_symbols} - self.places.keys()
            for m in sorted(others, key=str):
                added = [
                    m * ((square if i == k else 0) - a * b)
                    for i, a in enumerate(names)
                    for k, b in enumerate(names)
                ]
                rest = [
                    sympy.expand((f - x).xreplace(self.formulas))
                    for f, x in zip(formulas, added, strict=True)
                ]
                if all(x.is_Symbol or x == 0 for x in rest):
                    return [x + y for x, y in zip(rest, map(sympy.expand, added), strict=True)]
        return formulas


def _plain(name):
    """A name without its sign."""
    return -name if name.could_extract_minus_sign() else name
