"""How each quantity of a problem follows from the givens and from the quantities before it, as
formulas of SymPy: read off the traced computation.
"""

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any

from exercises.catalogue import Givens, Problem
from exercises.catalogue.tracing import before, numbers_of, traced_quantities
from exercises.catalogue.variants import draw, symbol_values
from newton_euler.algebra.linear import Solved
from newton_euler.algebra.scalars import FUNCTIONS
from newton_euler.algebra.trace import Step

from .names import Names, unsigned, value_of
from .tidy import (  # fmt: skip
    LONGEST,
    constant,
    is_atom,
    is_forced,
    is_long,
    readable,
    simplest,
    two_sides,
    without_unknown,
)

LONGEST_LIST = 60  # operations of all components that a reader follows
SHEETS = 4  # on which sums are compared
SHORT = 1  # operations of what is read as easily as the name of a component of another vector
NAMES = {"abs": "Abs", "**": "Pow", "pow": "Pow", **{name: name for name in (*FUNCTIONS, "atan2")}}


@dataclass(frozen=True)
class Derivation:
    """How a quantity is found.

    formulas : of its components, each None where it is no formula to read
    together : equations that are solved first, as pairs of their two sides
    unknowns : the names of their unknowns
    solved : True if it is itself an unknown of such equations, of these or of earlier ones
    varies : True if it depends on what is given
    after : the answers that are shown before it, since it is found from them
    """

    formulas: tuple = ()
    together: tuple = ()
    unknowns: frozenset = frozenset()
    solved: bool = False
    varies: bool = False
    after: tuple[str, ...] = ()


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
    cases = [value_of(c, g, memo) for c in _choices(found)]
    scalars = {key: parts[0] for key, parts in found.components.items() if len(parts) == 1}
    positive = {key for key, x in scalars.items() if (value_of(x, g, memo) or 0.0) > 0}
    usual = all(low <= values[n] <= high for n, (low, high) in _ranges(p).items())
    return _derivations(p, tuple(c and c > 0 for c in cases), frozenset(positive), usual)


def _unrelated(p, n):
    """Numbers of the givens and symbols, also for those that all students share."""
    rng, drawn = random.Random(n), draw(p, bytes([n]))
    shared = {
        k: (q.value or 1.0) * rng.uniform(0.97, 1.03) for k, q in p.givens.items() if not q.vary
    }
    return symbol_values(p, rng) | drawn | shared


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
        return traced_quantities(p, with_all_terms=True)
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
    reader = _Reader(
        found, dict(zip(numbers, cases, strict=True)), {*positive}, asked, drawn, p.units,
        [(p.base(_unrelated(p, n)), {}) for n in range(SHEETS * usual)],
    )  # fmt: skip
    for key in reader.order():
        reader.derive(key)
    return reader.derivations


@dataclass
class _Reader:
    """Writes traced numbers as formulas, cut at what is known already."""

    found: Any
    cases: Mapping[int, Any]
    positive: set[str]
    asked: set[str]
    drawn: Sequence[Givens]
    units: Mapping[str, str]  # units of the givens
    sheets: Sequence[tuple[Givens, dict]]  # unrelated numbers, and what follows from them
    shown: set[int] = field(default_factory=set)
    derivations: dict[str, Derivation] = field(default_factory=dict)

    def __post_init__(self):
        self.answers = set()  # the numbers of what was an unknown of equations that are shown
        self.given_by = {x.number: name for name, x in self.found.givens.items()}
        self.names = Names({n: self.symbol(name) for n, name in self.given_by.items()}, self.sheets)
        self.nameless = {}  # {symbol of an unknown that is no quantity: what it is equal to}
        self.unknowns = {}  # number of a traced value: (its equations, its name, the sign of it)
        for equations in self.found.solved:
            for name, x in equations.values.items():
                x, sign = unsigned(x)
                # one that is equal to a coefficient is no unknown by whose name this is written
                plain = self._is_traced(x) and x.number not in self.given_by
                if plain and x.number not in before(equations.equations):
                    self.unknowns.setdefault(x.number, (equations, name, sign))
        # formulas for which a later one has the name, and components that are as short as theirs
        self.called, self.shorter, self.short = {}, [], {}
        self.products = {}  # {name: formula} of products of givens
        self.constants = {}  # {number: name} of those that are the same for all givens
        self.met = set()  # the names by which a formula has numbers of the computation itself
        self.terms = {s.key: s.of for s in self.found.steps if s.of in self.asked}
        first = {}  # {number: the quantity that has its name}
        for key in sorted(self.found.components, key=lambda k: k in self.terms):
            parts = self.found.components[key]
            for n, x in enumerate(parts):
                x, sign = unsigned(x)
                if isinstance(x, Step) and x.number not in self.called:
                    self.called[x.number] = component(key, n, len(parts)), sign
                    first[x.number] = key
        self.answers_by = {}  # {answer: its numbers}, where no step has them
        for key in self.asked & {*self.found.components}:
            numbers = numbers_of(self.found.components[key]) - {*self.given_by}
            if numbers and all(first[n] == key for n in numbers):
                self.answers_by[key] = numbers
        components = self.found.components.items()
        self.taken = {*self.found.givens}
        self.taken |= {component(k, n, len(x)) for k, x in components for n in range(len(x))}

    def _is_traced(self, x):
        """Whether it is a number of this computation, and not of one within a root or integral."""
        steps = self.found.trace.steps
        return isinstance(x, Step) and x.number < len(steps) and steps[x.number] is x

    def symbol(self, name):
        """The symbol of a name; positive where its number is, or all that are drawn for it."""
        import sympy

        return sympy.Symbol(name, real=True, positive=True if name in self.positive else None)

    def order(self):
        """The quantities as they are shown: the terms of an answer just before it."""
        keys = list(self.found.components)
        steps = [k for k in keys if k not in self.asked and k not in self.terms]
        answers = [k for k in keys if k in self.asked]
        return steps + [
            x for a in answers for x in (*(t for t in self.terms if self.terms[t] == a), a)
        ]

    def derive(self, key):
        """Derives a quantity; a step after the answers that it is found from."""
        after = self._found_before(key)
        for other in after:
            self.derive(other)
        if key not in self.derivations:
            self.derivations[key] = replace(self._derived(key), after=after)

    def _found_before(self, key):
        """The answers that a step is found from, and that are not shown yet."""
        if key in self.asked or key in self.terms:
            return ()
        parts = self.found.components[key]
        found = before(parts) - numbers_of(parts)
        answers = [a for a in self.found.components if a in self.answers_by]
        return tuple(
            a for a in answers if a not in self.derivations and self.answers_by[a] <= found
        )

    def _derived(self, key):
        """The derivation of a quantity, which is known from now on."""
        parts = self.found.components[key]
        names = [component(key, n, len(parts)) for n in range(len(parts))]
        self.together, self.wanted = [], set()
        self.names.look_at(parts)
        formulas = tuple(map(self._formula, range(len(parts)), parts, names))
        formulas = self._explicit(formulas, names)
        solved = any(getattr(unsigned(x)[0], "number", None) in self.answers for x in parts)
        self._remember(key, parts, names, formulas)
        if sum(f.count_ops() for f in {*formulas} - {None}) > LONGEST_LIST:
            formulas = ()
        varies = any(isinstance(x, Step) for x in parts)
        return Derivation(formulas, tuple(self.together), frozenset(self.wanted), solved, varies)

    def _explicit(self, formulas, names):
        """The formulas, with the solution of one equation that is linear in its one unknown in the
        place of what has no other formula, and of an unknown that is no quantity of the problem.
        """
        if len(self.together) != 1 or len(self.wanted) != 1:
            return formulas
        unknown = self.symbol(*self.wanted)
        difference = self.together[0][0] - self.together[0][1]
        slope = difference.diff(unknown)
        if slope.has(unknown) or slope == 0:
            return formulas
        solution = simplest(readable(-difference.subs(unknown, 0) / slope))
        if unknown.name not in self.taken:
            fixed = self.names.fixed
            fixed |= {n: f.subs(unknown, solution) for n, f in fixed.items() if f.has(unknown)}
            return tuple(
                None if f is None else readable(f.subs(unknown, solution)) for f in formulas
            )
        pairs = zip(formulas, names, strict=True)
        return tuple(solution if f is None and n == unknown.name else f for f, n in pairs)

    def _remember(self, key, parts, names, formulas):
        """Makes a quantity known to later ones, but for the terms of an answer, whose names no line
        has.
        """
        import sympy

        if key in self.terms:
            return
        if len(parts) == 1 and formulas[0] is not None and formulas[0].is_positive:
            self.positive.add(key)
        symbols = list(map(self.symbol, names))
        self.names.add(key, parts, symbols)
        if len(parts) == 1:
            self._rename(key, parts[0])
        named = [(f, x) for f, x in zip(formulas, symbols, strict=True) if f is not None]
        self.constants |= {float(f): x for f, x in named if f.is_Float}
        givens = {*self.found.givens}
        self.products |= {
            x: f for f, x in named if f.is_Mul and {s.name for s in f.free_symbols} <= givens
            and not f.has(sympy.Add, sympy.Function)
        }  # fmt: skip
        if len(parts) == 1 or any(f.count_ops() > SHORT for f, _ in named):
            # a vector's w/2 is of several bodies that lie side by side
            shared = {f for f, _ in named if len(parts) > 1 and f.as_coeff_Mul()[1].is_Symbol}
            longer = [(f, x) for f, x in named if f not in shared]
            self.shorter += [(f, x) for f, x in longer if not is_atom(f) and not f.is_number]
        else:
            self.short |= {x: f for f, x in named}

    def _rename(self, key, x):
        """A given that a step states with the other sign, or in another unit, has its name then."""
        x, sign = unsigned(x)
        given = self.given_by.get(getattr(x, "number", None))
        if given and (sign < 0 or self.units[given] != self.found.units[key]):
            self.names.fixed[x.number] = sign * self.symbol(key)

    def _formula(self, place, x, name):
        """The formula of a component called ``name``, None where there is none to read."""
        self.names.place, self.met = place, set()
        if self.names.vanishes(x):
            return constant(0)
        try:
            formula = self._shortened(self._without_bars(readable(self._written(x, {}))))
            formula = self._without_ones(formula)
            if is_atom(formula):
                formula = formula.xreplace(self.short)
            formula = self._without_multiples(formula)
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
                signs = {inside.subs(values).is_positive for values in draws}
                if signs in ({True}, {False}):
                    formula = formula.xreplace({bars: inside if True in signs else -inside})
        return formula

    def _without_multiples(self, formula):
        """The formula with products of givens written out that are equal by chance: where a number
        times one stands alone, as 4*I_1/3, and beside one that differs by a given of the same unit,
        as m_1*d^2 and m_2*d^2.
        """
        import sympy

        terms = [x.as_coeff_Mul() for x in sympy.Add.make_args(formula)]
        own = self.products.keys() - self.met
        products = [x for _, x in terms if {s.name for s in x.free_symbols} <= {*self.units}]

        def written_out(c, x):
            whole = self.products.get(x, x)
            alike = any(self._differ_by_one(whole, y) for y in products)
            return c * (whole if alike or (abs(c) != 1 and x in own) else x)

        return sympy.Add(*(written_out(c, x) for c, x in terms))

    def _differ_by_one(self, one, other):
        """Whether two products differ by a given in the place of another of the same unit."""
        ratio = [str(x) for x in (one / other).as_numer_denom()]
        return ratio[0] != ratio[1] and len({self.units.get(x, x) for x in ratio}) == 1

    def _without_ones(self, formula):
        """The formula without squares of components of a unit vector that add up to one."""
        import sympy

        squared = {x.base for x in formula.atoms(sympy.Pow) if x.exp == 2}
        if len(squared & self.short.keys()) < 2:
            return formula
        shorter = sympy.trigsimp(formula.xreplace(self.short))
        return shorter if shorter.count_ops() < formula.count_ops() else formula

    def _shortened(self, formula):
        """The formula with earlier quantities in the place of theirs."""
        for other, name in reversed(self.shorter):
            shorter = formula.subs(other, name)
            if shorter == formula and not other.is_Add:
                shorter = formula.subs(1 / other, 1 / name)
            if shorter.count_ops() < formula.count_ops() and not is_forced(name, other, shorter):
                formula = shorter
        return formula

    def _written(self, x, memo):
        import sympy

        if not isinstance(x, Step):
            number = constant(x)
            return self.constants.get(float(x), number) if number.is_Float else number
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
            self.names.fixed[x.number] = variable
            return variable
        limits = self._written(start, memo), self._written(end, memo)
        if not formula.has(variable):
            return formula * (limits[1] - limits[0])
        return sympy.Integral(formula, (variable, *limits)) if formula != 0 else formula

    def _solved(self, x):
        """The name of an unknown, after its equations are shown; None if they are too long."""
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
            self.answers.add(x.number)
        self.names.fixed[x.number] = sign * self.nameless.get(found, found)
        return self.names.fixed[x.number]

    def _without_nameless(self, rows, unknowns):
        """Linear equations without the unknowns that are no quantities of the problem, whose names
        tell a reader nothing; :attr:`nameless` says what these are.
        """
        angles = ("cos_", "sin_", "tan_")
        for u in unknowns:
            if u.name not in self.taken and not u.name.startswith(angles):
                rows, found = without_unknown(rows, u)
                self.nameless = {k: x.subs(found) for k, x in self.nameless.items()} | found
        rows = [self._tidy(*row) for row in rows]
        return [row for row in rows if row[0] != row[1]]

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
            x, sign = unsigned(equations.values.get(name))
            called, other = self.called.get(getattr(x, "number", None), (self._free(name), sign))
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
