"""Facts about a computation that its edits need."""

from collections.abc import Sequence
from functools import cached_property
from typing import Any

from newton_euler.algebra.linear import Solved
from newton_euler.algebra.trace import Step
from newton_euler.algebra.units import SI, US, Dimension, System, unit

from .formulas import PRODUCT, Formulas, dimensions_of, steps_in, steps_needed, users_of
from .typed import Product, repeats

NUMBER, MASS, LENGTH, TIME = Dimension(), Dimension(1), Dimension(0, 1), Dimension(0, 0, 1)
FORCE, GRAVITY = Dimension(1, 1, -2), Dimension(0, 1, -2)
AREA, INERTIA, ENERGY = Dimension(0, 2), Dimension(1, 2), Dimension(1, 2, -2)
G, G_OF_FEET = 9.81, 32.2  # values of g, where the text gives none


class Facts:
    """Facts about a computation that its edits need.

    steps : those that the answers need
    given : the givens among them; ``anything``: all givens, also those that no answer needs;
        ``numbers``: those that are not symbols
    read : {given: its unit}
    dimensions : {step: its dimension, or None}; ``of`` returns that of a step
    own : the system of units in which a student computes
    users : {step: those that use it}
    written, unwritten : the steps that a student writes down, and the others
    products : the products with all their factors, each once
    """

    def __init__(self, formulas: Formulas):
        self.formulas, self.answers = formulas, formulas.answers
        self.system, self.stages = formulas.system, formulas.stages
        self.systems = square(formulas.systems)
        parts = [x for a in self.answers.values() for x in a.parts]
        self.steps = steps_needed(parts)
        self.given = {s.args[0]: s for s in self.steps if s.op == "argument"}
        self.numbers = {n: s for n, s in self.given.items() if n not in formulas.symbols}
        self.anything = {**formulas.given, **self.given}
        self.read = {name: unit(formulas.units[name]) for name in self.anything}
        unknowns = (x for s in self.systems for x in s.values.values())
        on_the_way = (x for stage in self.stages for x in stage.parts)
        every = steps_needed([*parts, *on_the_way, *self.anything.values(), *unknowns])
        units = {n: unit(u) for n, u in formulas.units.items()}
        self.dimensions = dimensions_of(every, units)
        self.of = self.dimensions.get
        stated = [*self.read.values(), *(unit(a.unit) for a in self.answers.values())]
        self.own = _students(stated)
        self.users = users_of(self.steps)
        self.unwritten = _unwritten(self.users)
        self.written = _varying(self.steps) - self.unwritten - _of_elimination(self.systems)
        leaves = {x for x in parts if isinstance(x, Step)}
        leaves |= {x for system in self.systems for x in entries(system)}
        self.products = {
            s: None for s, users in self.users.items()
            if s.op in PRODUCT and s in self.written
            if s in leaves or not _is_factor(users) or self._is_squared_alone(users)
        }  # fmt: skip

    def is_known(self, x: Any) -> bool:
        """True for a step whose dimension is known."""
        return isinstance(x, Step) and self.of(x) is not None

    def alike(self, a: Any, x: Any) -> bool:
        """True for an expression with the dimension of a component, or for two equal constants."""
        if not isinstance(a, Step):
            return not isinstance(x, Step) and x == a
        while isinstance(x, tuple):
            x = x[-1] if x[0] != "sqrt" else x[1]
        return self.of(a) is not None and self.of(x) == self.of(a)

    def number(self, s: Step) -> Any:
        """The number that a student writes for a step: if the text has feet and pounds, or all
        lengths in one other unit, not the number in the ``system`` in which the steps are computed.
        """
        dimension = self.of(s)
        if dimension is None:
            return s
        times = self.system.factor(dimension) / self.own.factor(dimension)
        return s if times == 1 else ("*", s, float(times))

    def _is_squared_alone(self, users):
        """True for a step that is used only as a square, in a sum or under a root."""
        (square,) = users
        return square.args[0] is square.args[1] and not _is_factor(self.users[square])

    @property
    def g(self) -> Any:
        """g in base units, where the text does not give it."""
        of, size = ("ft/s^2", G_OF_FEET) if self.own.mass == US.mass else ("m/s^2", G)
        return self.given.get("g", unit(of).to_base(size, self.system))

    @cached_property
    def factors(self) -> set[Step]:
        """The factors of products with several."""
        powers = [Product(s).powers for s in self.products]
        return {x for own in powers for x in own if len(own) > 1}

    @property
    def vectors(self) -> list[tuple[str, Sequence[Any]]]:
        """Those of :attr:`named` that are vectors."""
        stages = [(s.means, s.parts) for s in self.stages if s.means and s.kind.is_vector]
        return [*stages, *((key, a.parts) for key, a in self.answers.items() if a.kind.is_vector)]

    @property
    def named(self) -> list[tuple[str, Sequence[Any]]]:
        """(words, components) of each quantity that has words, and of each answer."""
        stages = [(s.means, s.parts) for s in self.stages if s.means]
        return [*stages, *((key, a.parts) for key, a in self.answers.items())]


def square(systems: Sequence[Solved]) -> list[Solved]:
    """The systems with two unknowns or more and as many equations, each once."""
    found: dict[tuple[Any, ...], Solved] = {}
    for s in systems:
        numbers = tuple(x.number for x in s.values.values() if isinstance(x, Step))
        if numbers and 1 < len(s.equations) == len(s.names) == len(s.values):
            found.setdefault(numbers, s)
    return list(found.values())


def entries(system: Solved) -> list[Any]:
    """The coefficients and the right side of each equation, row by row."""
    return [to_float(x) for row, right in system.equations for x in (*row, right)]


def to_float(x: Any) -> Any:
    """A number; a traced one as it is."""
    return x if isinstance(x, Step) else float(x)


def _of_elimination(systems):
    """The steps between equations and their unknowns, which a student does not write down."""
    found = set[Step]()
    for system in systems:
        known = {s.number for s in steps_needed(entries(system))}
        unknowns = {s.number for s in system.values.values() if isinstance(s, Step)}
        inside = steps_needed(system.values.values())
        found |= {s for s in inside if s.number not in known | unknowns and s.op != "argument"}
    return found


def _students(units):
    """SI, or feet and pounds; with the unit of length of the text where all is in that."""
    usual = US if any(u.is_of_feet for u in units) else SI
    lengths = {u.factor for u in units if u.dimension == LENGTH}
    for own in (System(x, usual.mass) for x in lengths if len(lengths) == 1):
        if all(u.factor == own.factor(u.dimension) for u in units if any(u.dimension.powers[:2])):
            return own
    return usual


def _unwritten(users_in):
    """The sums that repeat a given, and the steps used only in them: a student does not write
    them.
    """
    found = {s for s in users_in if repeats(s)}
    for s, users in reversed(users_in.items()):
        if s.op in (*PRODUCT, "+", "-") and users and found.issuperset(users):
            found.add(s)
    return found


def _varying(steps):
    """The steps that depend on a given: a student does not write down the others, such as
    cos(pi/2).
    """
    found = set[Step]()
    for s in steps:
        if s.op == "argument" or any(a in found for a in steps_in(s)):
            found.add(s)
    return found


def _is_factor(users):
    """True for a step that is used only in a product."""
    return len(users) == 1 and users[0].op in PRODUCT
