"""Traced numbers as SymPy formulas, with the equations solved on the way."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from exercises.catalogue.tracing import TracedProblem, before
from newton_euler.algebra.late import sympy
from newton_euler.algebra.linear import Solved
from newton_euler.algebra.scalars import FUNCTIONS
from newton_euler.algebra.trace import Step

from .known import KnownFormulas
from .names import Names, unsigned
from .tidy import LONGEST, constant, is_long, readable, two_sides, without_unknown

NAMES = {"abs": "Abs", "**": "Pow", "pow": "Pow", **{name: name for name in (*FUNCTIONS, "atan2")}}


@dataclass(eq=False)
class NoFormulaError(Exception):
    """The computation has no short formula."""


@dataclass
class Writer:
    """Writes traced numbers as formulas in terms of named quantities.

    found : the traced computation
    cases : {number of a deciding quantity: the case that holds}
    names, known : of the givens and of earlier quantities
    called : {number: (name, sign)} of all quantities, for the unknowns of equations
    taken : all names of the problem
    positive : names of positive quantities

    together, wanted : the equations met since :meth:`start`, and the names of their unknowns
    met : the names that replace numbers of the computation itself
    solved : the numbers that were unknowns of displayed equations
    nameless : {unknown that is not a quantity of the problem: its value}
    """

    found: TracedProblem
    cases: Mapping[Any, Any]
    names: Names
    known: KnownFormulas
    called: Mapping[int, tuple[str, int]]
    taken: set[str]
    positive: set[str]
    together: list[tuple[Any, Any]] = field(default_factory=list)
    wanted: set[str] = field(default_factory=set)
    met: set[Any] = field(default_factory=set)
    solved: set[int] = field(default_factory=set)
    nameless: dict[Any, Any] = field(default_factory=dict)

    def __post_init__(self):
        self.shown = set()  # equations
        self.unknowns = {}  # number of a traced value: (its equations, its name, the sign of it)
        givens = {x.number for x in self.found.givens.values()}
        for equations in self.found.solved:
            for name, x in equations.values.items():
                x, sign = unsigned(x)
                # not an unknown if it equals a coefficient
                plain = self._is_traced(x) and x.number not in givens
                if plain and x.number not in before(equations.equations):
                    self.unknowns.setdefault(x.number, (equations, name, sign))

    def _is_traced(self, x):
        """Whether it is a number of this computation, not of one inside a root or integral."""
        steps = self.found.trace.steps
        return isinstance(x, Step) and x.number < len(steps) and steps[x.number] is x

    def symbol(self, name: str) -> Any:
        """The symbol of a name, positive if its numbers are."""
        return sympy.Symbol(name, real=True, positive=True if name in self.positive else None)

    def start(self, key: str, parts: Sequence[Any]) -> None:
        """Begin the quantity ``key`` with these components."""
        self.together, self.wanted = [], set()
        self.names.look_at(key, self.found.kinds[key], parts)

    def formula(self, place: int, x: Any, name: str) -> Any:
        """The formula of the component at ``place``, called ``name``, or None without a readable
        one.
        """
        self.names.place, self.met = place, set()
        self.known.entry = name[-3:] if self.names.kind.is_matrix else ""
        if self.names.vanishes(x):
            return constant(0)
        try:
            formula = self.known.shortened(self._written(x, {}), self.met)
            if formula.count_ops() > 2 and self.known.is_of_givens(formula):
                formula = self.names.of_two(x) or formula
        except NoFormulaError:
            return None
        is_itself = formula.is_Symbol and formula.name == name and name not in self.found.givens
        return None if is_itself or is_long(formula) else formula

    def _written(self, x, memo):
        if not isinstance(x, Step):
            number = constant(x)
            return self.known.constants.get(float(x), number) if number.is_Float else number
        if (name := self.names.of(x)) is not None:
            self.met |= name.free_symbols
            return name
        if x.number in memo:
            return memo[x.number]
        if x.number in self.unknowns and (name := self._solved(x)) is not None:
            return name
        if (name := self.names.equal(x)) is not None:
            return name
        memo[x.number] = formula = self._operation(x, memo)
        if isinstance(formula, sympy.Basic) and formula.has(sympy.zoo, sympy.nan):
            raise NoFormulaError
        return formula

    def _operation(self, x, memo):
        if x.op == "pi":
            return sympy.pi
        if x.op == "abs" and self.cases.get(x.args[0].number):
            return self._written(x.args[0], memo)
        if x.op == "where":
            return self._written(x.args[1 if self._holds(x.args[0]) else 2], memo)
        if x.op == "item" and isinstance(x.args[0], Step):
            return self._within(x.args[0], x.args[1], memo, x)
        return _applied(x.op, [self._written(a, memo) for a in x.args] if x.op != "*" else [
            self._written(a, memo) if (name := self.names.of_body(a, b)) is None else name
            for a, b in (x.args, x.args[::-1])
        ])  # fmt: skip

    def _holds(self, condition):
        """The case that applies to this sheet."""
        case = self.cases.get(getattr(condition, "number", None))
        if case is None:
            raise NoFormulaError
        return case

    # -- a root, an integral, and linear equations

    def _within(self, whole, n, memo, x):
        """A root or an integral inside this formula."""
        if whole.op not in ("root", "integral"):
            raise NoFormulaError
        inner, start, end, *outside = whole.args
        root = whole.op == "root"
        name = self._free("u" if root else inner.variable or "u")
        name = self.called.get(x.number, (name, 1))[0] if root else name
        variable = self.symbol(name)
        own = dict(zip(inner.parameters, [variable, *outside], strict=True))
        formula = sympy.sympify(self._inner(inner.leaves[n], own, memo))
        if formula.count_ops() > 2 * LONGEST:
            raise NoFormulaError
        if root:
            self._show_together([self._tidy(formula, 0)], {name})
            self.solved.add(x.number)
            self.names.fixed[x.number] = variable
            return variable
        limits = self._written(start, memo), self._written(end, memo)
        if not formula.has(variable):
            return formula * (limits[1] - limits[0])
        return sympy.Integral(formula, (variable, *limits)) if formula != 0 else formula

    def _inner(self, x, own, memo):
        """A traced number inside a root or integral; ``own``: {argument there: its formula}."""
        if not isinstance(x, Step):
            return constant(x)
        if x.op == "argument":
            value = own[x.args[0]]
            return value if isinstance(value, sympy.Basic) else self._written(value, memo)
        if x.op == "pi":
            return sympy.pi
        return _applied(x.op, [self._inner(a, own, memo) for a in x.args])

    def _solved(self, x):
        """Show the equations of an unknown and return its name; None if they are too long."""
        equations, name, own = self.unknowns[x.number]
        name, sign = self.called.get(x.number, (self._free(name), own))
        if id(equations) not in self.shown:
            rows = self._rows(equations)
            if not rows:
                return None
            self.shown.add(id(equations))
            unknowns = [n.free_symbols.pop() for n in self._unknowns(equations).values()]
            rows = self._without_nameless(rows, unknowns)
            self._show_together(rows, {n.name for n in unknowns if n not in self.nameless})
        found = self.symbol(name)
        if found not in self.nameless:
            self.solved.add(x.number)
        self.names.fixed[x.number] = sign * self.nameless.get(found, found)
        return self.names.fixed[x.number]

    def _without_nameless(self, rows, unknowns):
        """Linear equations without unknowns that are not quantities of the problem; their values
        are in :attr:`nameless`.
        """
        angles = ("cos_", "sin_", "tan_")
        for u in unknowns:
            if u.name not in self.taken and not u.name.startswith(angles):
                rows, found = without_unknown(rows, u)
                self.nameless = {k: x.subs(found) for k, x in self.nameless.items()} | found
        rows = [self._tidy(*row) for row in rows]
        return [row for row in rows if row[0] != row[1]]

    def _free(self, name):
        """An unused name for a number that is not a quantity of the problem."""
        return name if name not in self.taken else next(x for x in "uwqXYZ" if x not in self.taken)

    def _rows(self, equations: Solved) -> Sequence[tuple[Any, Any]]:
        """Linear equations as pairs of sides; none if one is too long."""
        names = self._unknowns(equations)
        everything = self.unknowns
        # their own unknowns are left out; for good if they are too long
        self.unknowns = {n: x for n, x in everything.items() if x[0] is not equations}
        rows = []
        try:
            for coefficients, right in equations.equations:
                parts = zip(coefficients, equations.names, strict=True)
                left = sum(self._written(c, {}) * names[name] for c, name in parts)
                rows.append(self._tidy(left, self._written(right, {})))
        except NoFormulaError:
            return ()
        rows = [row for row in rows if row[0] != row[1]]
        if any(is_long(left - right) for left, right in rows):
            return ()
        self.unknowns = everything
        return rows

    def _unknowns(self, equations):
        """{name in the code: symbol} of the unknowns of linear equations."""
        symbols = {}
        for name in equations.names:
            x, sign = unsigned(equations.values.get(name))
            called, other = self.called.get(getattr(x, "number", None), (self._free(name), sign))
            symbols[name] = sign * other * self.symbol(called)
        return symbols

    def _tidy(self, left, right):
        return self.known.named(readable(left)), self.known.named(readable(right))

    def _show_together(self, rows, unknowns):
        if any(is_long(left - right) for left, right in rows):
            raise NoFormulaError
        self.wanted |= {name.removeprefix("-") for name in unknowns}
        rows = [two_sides(row, self.wanted) for row in rows]
        self.together += [row for row in rows if row not in self.together]


def _applied(op, args):
    """An operation on formulas."""
    if op in _WRITTEN:
        return _WRITTEN[op](*args)
    if op not in NAMES:
        raise NoFormulaError
    if op in ("sin", "cos") and isinstance(args[0], sympy.atan):
        y, x = sympy.fraction(args[0].args[0])  # two sides of a right triangle
        return (
            (y if op == "sin" else x) / sympy.sqrt(x**2 + y**2)
            if x.is_positive
            else (getattr(sympy, op)(*args))
        )
    return getattr(sympy, NAMES[op])(*args)


_WRITTEN: Mapping[str, Any] = {
    "+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a * b,
    "/": lambda a, b: a / b, "neg": lambda a: -a,
}  # fmt: skip
