"""How each quantity of a problem follows from the givens and from the quantities before it, as
formulas of SymPy: read off the traced computation.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

from exercises.catalogue import Givens, Problem
from exercises.catalogue.tracing import traced_quantities
from exercises.catalogue.variants import draw
from newton_euler.algebra.linear import Solved
from newton_euler.algebra.scalars import FUNCTIONS
from newton_euler.algebra.trace import Step
from newton_euler.classroom.practising.programs import operate

from .tidy import LONGEST, constant, is_atom, is_long, is_raised, readable, two_sides

LONGEST_LIST = 60  # operations of all components that a reader follows
SHORT = 2  # operations of what is read as easily as the name of a component of another vector
NAMES = {"abs": "Abs", "**": "Pow", "pow": "Pow", **{name: name for name in (*FUNCTIONS, "atan2")}}


@dataclass(frozen=True)
class Derivation:
    """How a quantity is found.

    formulas : of its components, each None where it is no formula to read
    together : equations that are solved first, as pairs of their two sides
    unknowns : the names of their unknowns
    solved : True if it is itself an unknown of such equations, of these or of earlier ones
    varies : True if it depends on what is given
    """

    formulas: tuple = ()
    together: tuple = ()
    unknowns: frozenset = frozenset()
    solved: bool = False
    varies: bool = False


@dataclass(eq=False)
class Unwritten(Exception):
    """A computation that no short formula shows."""


def component(key: str, n: int, count: int) -> str:
    """The name of a component of the quantity ``key``: "v_x" of the vector v."""
    if count == 1:
        return key
    axes = ("xx xy xz yx yy yz zx zy zz" if count == 9 else "x y z").split()
    return f"{key}_{axes[n] if n < len(axes) else n + 1}"


def derivations(p: Problem, values: Mapping[str, Any]) -> Mapping[str, Derivation]:
    """The :class:`Derivation` of each step and answer of ``p``; empty where its computation cannot
    be traced. ``values`` decide between cases.
    """
    found = _traced(p)
    if found is None:
        return {}
    g = p.base({**p.sympy_symbols(), **values})
    memo: dict[int, float | None] = {}
    cases = [_value(c, g, memo) for c in _choices(found)]
    scalars = {key: parts[0] for key, parts in found.components.items() if len(parts) == 1}
    positive = {key for key, x in scalars.items() if (_value(x, g, memo) or 0.0) > 0}
    usual = all(low <= values[n] <= high for n, (low, high) in _ranges(p).items())
    return _derivations(p, tuple(c and c > 0 for c in cases), frozenset(positive), usual)


def _ranges(p):
    """The lowest and highest number of each given."""
    return {n: q.vary or (q.value, q.value) for n, q in p.givens.items()}


def _choices(found):
    """What decides between cases in a traced computation: conditions, and what has an absolute
    value.
    """
    return [s.args[0] for s in found.trace.steps if s.op in ("where", "abs")]


@lru_cache(maxsize=400)
def _traced(p):
    try:
        return traced_quantities(p)
    except (TypeError, ValueError, ArithmeticError, AttributeError):
        return None


@lru_cache(maxsize=400)
def _derivations(p, cases, positive, usual):
    """The derivations where the choices of the computation, in their order, are ``cases``, and
    these quantities are ``positive``; ``usual`` if the givens are within their ranges.
    """
    found = _traced(p)
    numbers = [c.number if isinstance(c, Step) else None for c in _choices(found)]
    lowest = {n: low for n, (low, _) in _ranges(p).items() if usual}
    lowest |= {n: q.vary[0] for n, q in p.symbols.items()}
    positive |= {n for n, low in lowest.items() if low > 0}
    asked = {a.key for a in p.answers}
    drawn = [p.base({**p.sympy_symbols(), **draw(p, bytes([n]))}) for n in range(8 * usual)]
    reader = _Reader(found, dict(zip(numbers, cases, strict=True)), {*positive}, asked, drawn)
    return {key: reader.derived(key) for key in found.components}


@dataclass
class _Reader:
    """Writes traced numbers as formulas, cut at what is known already."""

    found: Any
    cases: Mapping[int, Any]
    positive: set[str]
    asked: set[str]
    drawn: Sequence[Givens]
    known: dict[int, Any] = field(default_factory=dict)
    shown: set[int] = field(default_factory=set)

    def __post_init__(self):
        self.answers = set()  # the numbers of what was an unknown of equations that are shown
        for name, x in self.found.givens.items():
            self._name(x, name)
        self.unknowns = {}  # number of a traced value: (its equations, its name)
        for equations in self.found.solved:
            for name, x in equations.values.items():
                x, _ = _unsigned(x)
                if isinstance(x, Step) and x.number not in self.known:
                    self.unknowns.setdefault(x.number, (equations, name))
        # formulas for which a later one has the name, and components that are as short as theirs
        self.called, self.shorter, self.short = {}, [], {}
        self.terms = {s.key: s.of for s in self.found.steps if s.of in self.asked}
        self.of_sums = {}  # {sum: its terms, known while it is derived}
        for key, parts in self.found.components.items():
            for n, x in enumerate(parts):
                x, sign = _unsigned(x)
                if isinstance(x, Step):
                    self.called.setdefault(x.number, (component(key, n, len(parts)), sign))

        components = self.found.components.items()
        self.taken = {*self.found.givens}
        self.taken |= {component(k, n, len(x)) for k, x in components for n in range(len(x))}

    def symbol(self, name):
        """The symbol of a name; positive where its number is, or all that are drawn for it."""
        import sympy

        return sympy.Symbol(name, real=True, positive=True if name in self.positive else None)

    def _name(self, x, name, known=None):
        x, sign = _unsigned(x)
        if isinstance(x, Step):
            (self.known if known is None else known).setdefault(x.number, sign * self.symbol(name))

    def derived(self, key):
        """The derivation of a quantity, which is known from now on."""
        parts = self.found.components[key]
        names = [component(key, n, len(parts)) for n in range(len(parts))]
        self.together, self.wanted = [], set()
        terms = {n: x for n, x in self.of_sums.get(key, {}).items() if n not in self.known}
        self.known |= terms
        formulas = tuple(map(self._formula, parts, names))
        for number in terms:
            del self.known[number]
        solved = any(getattr(_unsigned(x)[0], "number", None) in self.answers for x in parts)
        self._remember(key, parts, names, formulas)
        if sum(f.count_ops() for f in {*formulas} - {None}) > LONGEST_LIST:
            formulas = ()
        varies = any(isinstance(x, Step) for x in parts)
        return Derivation(formulas, tuple(self.together), frozenset(self.wanted), solved, varies)

    def _remember(self, key, parts, names, formulas):
        """Makes a quantity known to later ones; the terms of an answer to it only, as no line has
        their names.
        """
        known = self.of_sums.setdefault(self.terms[key], {}) if key in self.terms else None
        for x, name, formula in zip(parts, names, formulas, strict=True):
            if len(parts) == 1 and formula is not None and formula.is_positive:
                self.positive.add(name)
            self._name(x, name, known)
            if known is None and formula is not None and formula.count_ops() > SHORT:
                self.shorter.append((formula, self.symbol(name)))
            elif known is None and formula is not None and len(parts) > 1:
                self.short[self.symbol(name)] = formula

    def _formula(self, x, name):
        """The formula of a component called ``name``, None where there is none to read."""
        try:
            formula = self._shortened(self._without_bars(readable(self._written(x, {}))))
            if is_atom(formula):
                formula = formula.xreplace(self.short)
        except Unwritten:
            return None
        is_itself = formula.is_Symbol and formula.name == name and name not in self.found.givens
        return None if is_itself or is_long(formula) else formula

    def _without_bars(self, formula):
        """The formula without the bars around what is positive for all numbers that are drawn."""
        import sympy

        for bars in formula.atoms(sympy.Abs):
            inside, free = bars.args[0], bars.free_symbols
            if self.drawn and {x.name for x in free} <= {*self.found.givens}:
                draws = ({x: getattr(g, x.name) for x in free} for g in self.drawn)
                if all(inside.subs(values).is_positive for values in draws):
                    formula = formula.xreplace({bars: inside})
        return formula

    def _shortened(self, formula):
        """The formula with earlier quantities in the place of theirs."""
        for other, name in reversed(self.shorter):
            shorter = formula.subs(other, name)
            if shorter.count_ops() < formula.count_ops() and not is_raised(name, shorter):
                formula = shorter
        return formula

    def _written(self, x, memo):
        import sympy

        if not isinstance(x, Step):
            return constant(x)
        if x.number in self.known:
            return self.known[x.number]
        if x.number in memo:
            return memo[x.number]
        if x.number in self.unknowns and (name := self._solved(x)) is not None:
            return name
        memo[x.number] = formula = self._operation(x, memo)
        if isinstance(formula, sympy.Basic) and formula.has(sympy.zoo, sympy.nan):
            raise Unwritten
        return formula

    def _operation(self, x, memo):
        import sympy

        if x.op == "pi":
            return sympy.pi
        if x.op == "abs" and self.cases.get(x.args[0].number):
            return self._written(x.args[0], memo)
        if x.op == "where":
            return self._written(x.args[1 if self._holds(x.args[0]) else 2], memo)
        if x.op == "item" and isinstance(x.args[0], Step):
            return self._within(x.args[0], x.args[1], memo, x)
        return _applied(x.op, [self._written(a, memo) for a in x.args])

    def _holds(self, condition):
        """Which case holds for the values of this sheet."""
        case = self.cases.get(getattr(condition, "number", None))
        if case is None:
            raise Unwritten
        return case

    # -- a root, an integral, and linear equations

    def _within(self, whole, n, memo, x):
        """A root or an integral of a formula within this one."""
        import sympy

        if whole.op not in ("root", "integral"):
            raise Unwritten
        inner, start, end, *outside = whole.args
        root = whole.op == "root"
        name = self.called.get(x.number, (self._free("u"), 1))[0] if root else self._free("u")
        variable = self.symbol(name)
        own = dict(zip(inner.parameters, [variable, *outside], strict=True))
        reader = _Inner(self, own, memo)
        formula = sympy.sympify(reader.written(inner.leaves[n]))
        if formula.count_ops() > 2 * LONGEST:
            raise Unwritten
        if root:
            self._show_together([self._tidy(formula, 0)], {name})
            self.answers.add(x.number)
            self.known[x.number] = variable
            return variable
        limits = self._written(start, memo), self._written(end, memo)
        return sympy.Integral(formula, (variable, *limits)) if formula != 0 else formula

    def _solved(self, x):
        """The name of an unknown, after its equations are shown; None if they are too long."""
        equations, name = self.unknowns[x.number]
        name, sign = self.called.get(x.number, (self._free(name), 1))
        if id(equations) not in self.shown:
            rows = self._rows(equations)
            if not rows:
                return None
            self.shown.add(id(equations))
            self._show_together(rows, {str(n) for n in self._unknowns(equations).values()})
        self.answers.add(x.number)
        self.known[x.number] = sign * self.symbol(name)
        return self.known[x.number]

    def _free(self, name):
        """A name for what is no quantity of the problem, other than theirs."""
        return name if name not in self.taken else next(x for x in "uwqXYZ" if x not in self.taken)

    def _rows(self, equations: Solved) -> Sequence[tuple[Any, Any]]:
        """Linear equations as pairs of their two sides; none if one of them is too long."""
        names = self._unknowns(equations)
        everything = self.unknowns
        # their own unknowns, here and from now on where they are too long
        self.unknowns = {n: x for n, x in everything.items() if x[0] is not equations}
        rows = []
        try:
            for coefficients, right in equations.equations:
                parts = zip(coefficients, equations.names, strict=True)
                left = sum(self._written(c, {}) * names[name] for c, name in parts)
                rows.append(self._tidy(left, self._written(right, {})))
        except Unwritten:
            return ()
        rows = [row for row in rows if row[0] != row[1]]
        if any(is_long(left - right) for left, right in rows):
            return ()
        self.unknowns = everything
        return rows

    def _unknowns(self, equations):
        """The unknowns of linear equations as symbols, by the names that the code has for them."""
        symbols = {}
        for name in equations.names:
            x, sign = _unsigned(equations.values.get(name))
            called, other = self.called.get(getattr(x, "number", None), (self._free(name), 1))
            symbols[name] = sign * other * self.symbol(called)
        return symbols

    def _tidy(self, left, right):
        return self._shortened(readable(left)), self._shortened(readable(right))

    def _show_together(self, rows, unknowns):
        if any(is_long(left - right) for left, right in rows):
            raise Unwritten
        self.together += [row for row in map(two_sides, rows) if row not in self.together]
        self.wanted |= {name.removeprefix("-") for name in unknowns}


@dataclass
class _Inner:
    """Writes the formula within a root or integral; ``own`` are its arguments by name."""

    outer: _Reader
    own: Mapping[str, Any]
    memo: dict

    def written(self, x):
        """The formula of a traced number of the inner trace."""
        import sympy

        if not isinstance(x, Step):
            return constant(x)
        if x.op == "argument":
            value = self.own[x.args[0]]
            known = isinstance(value, sympy.Basic)
            return value if known else self.outer._written(value, self.memo)
        if x.op == "pi":
            return sympy.pi
        return _applied(x.op, [self.written(a) for a in x.args])


def _applied(op, args):
    """An operation on formulas."""
    import sympy

    if op in _WRITTEN:
        return _WRITTEN[op](*args)
    if op not in NAMES:
        raise Unwritten
    return getattr(sympy, NAMES[op])(*args)


_WRITTEN: Mapping[str, Any] = {
    "+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a * b,
    "/": lambda a, b: a / b, "neg": lambda a: -a,
}  # fmt: skip


def _unsigned(x):
    """A traced number without its minus sign, and the sign."""
    return (x.args[0], -1) if isinstance(x, Step) and x.op == "neg" else (x, 1)


def _value(x, values, memo):
    """The number of a traced condition for givens, None where it has none."""
    if not isinstance(x, Step):
        return float(x)
    if x.number not in memo:
        try:
            args = (
                [getattr(values, x.args[0])] if x.op == "argument"
                else [_value(a, values, memo) for a in x.args]
            )  # fmt: skip
            memo[x.number] = operate("value" if x.op == "argument" else x.op, *args)
        except (TypeError, ValueError, ArithmeticError, KeyError):
            memo[x.number] = None
    return memo[x.number]
