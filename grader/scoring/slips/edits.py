"""The slips that can be made in a traced computation, as edits of its steps, simplest first."""

from dataclasses import replace
from functools import cached_property
from math import pi
from typing import Any

from newton_euler.algebra.language import Words
from newton_euler.algebra.source import WITHIN
from newton_euler.algebra.trace import Step
from newton_euler.algebra.units import SI, US, Dimension, System, unit
from newton_euler.answers.causes import FACTOR_2, INSTEAD, LEFT_OUT, REVERSED, Cause, computed
from newton_euler.answers.near import FIRST, LEAST, LESS, RARER, SIMPLE

from . import edits_of_equations as equations
from . import edits_of_givens as givens
from . import edits_of_groups as groups
from . import edits_of_operations as operations
from . import edits_of_quantities as quantities
from .edits_of_integrals import of_integrals
from .edits_of_laws import of_laws
from .edits_of_operations import PRODUCT
from .edits_of_roots import of_roots
from .edits_of_wholes import (
    of_quantities_in_wholes,
    of_sides,
    of_single_terms,
    of_sums,
    of_unneeded,
    of_wholes,
)
from .formulas import Edit, Formulas, Stage, dimensions_of, needed, steps_in, users_of
from .typed import Product, described, is_nothing, repeats

MANY = 8  # uses of a step, beyond which single uses are not tried
INVERTED = Words("inverts the ratio of {key} to {name}: it is the other way round").template
ONCE = 4  # added to the rank of a slip in one use, over that of the same slip in all


def edits_of(formulas: Formulas) -> list[Edit]:
    """The edits of the steps that the answers need, each with the place where the book has it."""
    stages = [s for s in formulas.stages if any(isinstance(x, Step) for x in s.parts)]
    _call(formulas)
    cones = sorted(
        (({s.number for s in needed(stage.parts)}, stage.where) for stage in stages),
        key=lambda cone: len(cone[0]),
    )
    found = sorted(_edits(formulas), key=lambda e: e.rank)
    return [e._replace(cause=_placed(e, cones, formulas.where)) for e in found]


def _call(formulas):
    """Name the steps that are answers, and give those that are quantities their words."""
    for key, answer in formulas.answers.items():
        for x in answer.parts if len(answer.parts) == 1 else ():
            if isinstance(x, Step):
                x.trace.called.setdefault(x.number, key)
    for stage in formulas.stages:
        words = stage.means
        if len(stage.parts) > 1:
            words = Words("a component of {what}", what=stage.means)
        for x in stage.parts if stage.means else ():
            if isinstance(x, Step):
                x.trace.meant.setdefault(x.number, words)


def _placed(edit, cones, otherwise):
    """The cause with the place of the first quantity that is computed by what is edited."""
    edited = edit.instead.keys()
    around = (where for cone, where in cones if where and edited and edited <= cone)
    where = next(around, otherwise)
    return edit.cause.at(where)


class _Facts:
    """What the edits of a computation ask about it.

    steps : those that the answers need
    given : the givens among them; ``anything``: all givens, also those that no answer needs
    read : {given: its unit}
    dimensions : {step: its dimension, or None}
    own : the system of units in which a student computes
    users : {step: those that use it}
    written, unwritten : the steps that a student writes down, and that nobody does
    products : the products with all their factors, each once
    """

    def __init__(self, formulas):
        self.formulas, self.answers = formulas, formulas.answers
        self.system, self.units = formulas.system, formulas.units
        self.steps = needed(x for a in self.answers.values() for x in a.parts)
        self.given = {s.args[0]: s for s in self.steps if s.op == "argument"}
        self.anything = {**formulas.given, **self.given}
        self.read = {name: unit(self.units[name]) for name in self.anything}
        parts = (x for a in (*self.answers.values(), *formulas.stages) for x in a.parts)
        systems = equations.square(formulas.systems)
        unknowns = (x for s in systems for x in s.values.values())
        every = needed([*parts, *self.anything.values(), *unknowns])
        self.dimensions = dimensions_of(every, {n: unit(u) for n, u in self.units.items()})
        stated = [*self.read.values(), *(unit(a.unit) for a in self.answers.values())]
        self.own = _students(stated)
        self.users = users_of(self.steps)
        self.unwritten = _unwritten(self.users)
        of_elimination = equations.of_elimination(formulas.systems)
        self.written = _varying(self.steps) - self.unwritten - of_elimination
        leaves = {x for a in self.answers.values() for x in a.parts if isinstance(x, Step)}
        leaves |= {x for system in systems for x in equations.entries(system)}
        self.products = {
            s: None for s, users in self.users.items()
            if s.op in PRODUCT and s in self.written
            if s in leaves or not _is_factor(users) or self._is_squared_alone(users)
        }  # fmt: skip

    def number(self, s):
        """The number by which a student multiplies for a step: where the text has feet and pounds,
        or lengths in one other unit, not that in the ``system`` in which the steps are computed.
        """
        dimension = self.dimensions[s]
        if dimension is None:
            return s
        times = self.system.factor(dimension) / self.own.factor(dimension)
        return s if times == 1 else ("*", s, float(times))

    def _is_squared_alone(self, users):
        """True of a step whose only use is its square, as a term, or in a root."""
        (square,) = users
        return square.args[0] is square.args[1] and not _is_factor(self.users[square])

    @property
    def g(self):
        """g in base units, where the text does not give it."""
        of, size = ("ft/s^2", givens.G_OF_FEET) if self.own.mass == US.mass else ("m/s^2", givens.G)
        return self.given.get("g", unit(of).to_base(size, self.system))

    @cached_property
    def factors(self):
        """The factors of products with several."""
        powers = [Product(s).powers for s in self.products]
        return {x for own in powers for x in own if len(own) > 1}

    @property
    def named(self):
        """(words, components) of each quantity that has words, and of each answer."""
        stages = [(s.means, s.parts) for s in self.formulas.stages if s.means]
        return [*stages, *((key, a.parts) for key, a in self.answers.items())]


def _students(units):
    """The system in which a student computes: with the one unit of length of the text, as inches or
    millimetres, if nothing in it needs another.
    """
    usual = US if any(u.is_of_feet for u in units) else SI
    lengths = {u.factor for u in units if u.dimension == givens.LENGTH}
    for own in (System(x, usual.mass) for x in lengths if len(lengths) == 1):
        if all(u.factor == own.factor(u.dimension) for u in units if any(u.dimension.powers[:2])):
            return own
    return usual


def _edits(formulas):
    f = _Facts(formulas)
    yield from formulas.setups
    yield from _of_givens(f)
    yield from _of_quantities(f)
    for s, users in f.users.items():
        for n, slip in enumerate(_of_step(f, s, users) if s in f.written else ()):
            yield from _everywhere_and_once(s, n, slip, [u for u in users if u not in f.unwritten])


def _of_givens(f):
    """The edits of givens, and of whole answers by them."""
    of, vectors = f.dimensions.get, {key: a.parts for key, a in f.answers.items()}
    yield from operations.of_angles(f.steps)
    yield from groups.of_constants(f.steps, of)
    yield from givens.of_one_unit(f.given, f.read, f.system)
    yield from givens.of_exchanged(f.given, f.read)
    yield from givens.of_planes(s for s in f.steps if s.op in ("+", "-"))
    yield from givens.of_rates(f.anything, f.read)
    yield from of_wholes(f.answers, f.given, f.number)
    yield from of_sides(f.answers, f.given, f.number)
    yield from of_unneeded(f.anything, f.answers, f.number, of)
    yield from givens.of_lengths(f.given, f.read)
    yield from givens.of_loads(f.anything, f.read)
    yield from givens.of_vectors(vectors)
    yield from givens.of_earlier(f.given, f.formulas.components)
    yield from givens.of_projections(vectors, f.given, f.read)
    yield from of_integrals(f.steps)
    yield from of_roots(f.steps)
    numbers = {n: s for n, s in f.given.items() if n not in f.formulas.symbols}
    masses = {n: s for n, s in numbers.items() if f.read[n].dimension == givens.MASS}
    yield from givens.of_weights(vectors, masses, f.g, of)


def _of_quantities(f):
    """The edits of quantities on the way, of equations, and of several places at once."""
    of, stages = f.dimensions.get, f.formulas.stages
    yield from _instead_of(f.answers, _of_answers(f))
    yield from _of_angles(f.answers)
    yield from equations.of_equations(f.formulas.systems, f.number, of)
    yield from quantities.of_quantities(f.answers, stages, f.steps, of)
    yield from quantities.of_rods(stages)
    yield from quantities.of_cross_products(f.named)
    yield from quantities.of_distances(f.given, f.products, of)
    yield from quantities.of_givens_in_products(f.products, f.read, f.given)
    yield from quantities.of_mean_rates(f.named, f.given, of)
    yield from quantities.of_densities(f.given, f.steps, of)
    yield from quantities.of_areas(f.answers, f.given, f.steps, of)
    yield from quantities.of_transfers(f.given, f.steps, of)
    yield from quantities.of_masses(f.steps, f.number, of)
    yield from quantities.of_squares(f.products, f.number, of)
    yield from quantities.of_sums_squared(f.steps, f.products)
    yield from quantities.of_slopes(f.steps)
    yield from quantities.of_differences_of_squares(f.steps)
    yield from groups.of_terms(f.steps, f.units)
    yield from groups.of_factors(f.products, f.number)


def _of_answers(f):
    """The edits that put something else in place of a whole answer."""
    of, stages = f.dimensions.get, f.formulas.stages
    yield from of_quantities_in_wholes(f.answers, f.named, f.number, of)
    yield from of_sums(f.answers)
    yield from of_single_terms(f.answers)
    yield from _of_unchanged(f.answers, f.given, f.read)
    numbers = {n: s for n, s in f.given.items() if n not in f.formulas.symbols}
    yield from _of_differences(f.answers, numbers, stages, f.dimensions)
    yield from _of_stages(f.answers, stages, f.dimensions)
    yield from quantities.of_ratios(f.named, f.answers, f.given, of)
    yield from of_laws(f.answers, f.anything, f.read)


def _instead_of(answers, edits):
    """The edits, each with the answers that it replaces."""
    keys: dict[int, set[str]] = {}
    for key, answer in answers.items():
        for x in answer.parts:
            keys.setdefault(getattr(x, "number", -1), set()).add(key)
    for edit in edits:
        names = " ".join(sorted({key for n in edit.instead for key in keys.get(n, ())}))
        cause = edit.cause if edit.cause.does else replace(edit.cause, does=INSTEAD, of=names)
        yield edit._replace(cause=cause)


def _of_step(f, s, users):
    """The slips in one step."""
    of, factors = f.dimensions.get, f.factors
    yield from operations.of_operation(s, f.number)
    yield from operations.of_moment(s, of)
    if s.op == "argument":
        name, means = s.args[0], f.formulas.means.get(s.args[0], "")
        one = f.read[name].to_base(1.0, f.system)
        symbols = f.formulas.symbols  # nobody takes a number of the text for one of them
        others = {n: x for n, x in f.anything.items() if (n in symbols) == (name in symbols)}
        if name in f.formulas.components:
            others = {n: x for n, x in others.items() if n not in f.formulas.components}
        found = givens.of_given(s, others, f.read, f.number, means, one)
        # a given alone in its term, as H in D^2 + H^2, is not a factor
        is_factor = s in factors or any(user.op in WITHIN for user in users)
        yield from (slip for slip in found if slip[1] != givens.ONE or is_factor)
        # nobody converts the symbols of a formula
        if name not in f.formulas.symbols:
            yield from givens.of_unit(s, f.read[name], f.system)
    if s in f.products:
        yield from operations.of_product(s, f.number, of)
        yield from quantities.of_shared(s) if len(users) > 1 else ()


def _unwritten(users_in):
    """The sums that repeat a given, and the steps used in them alone: nobody writes them."""
    found = {s for s in users_in if repeats(s)}
    for s, users in reversed(users_in.items()):
        if s.op in (*PRODUCT, "+", "-") and users and found.issuperset(users):
            found.add(s)
    return found


def _varying(steps):
    """The steps that depend on a given: nobody writes the others down, as cos(pi/2)."""
    found = set[Step]()
    for s in steps:
        if s.op == "argument" or any(a in found for a in steps_in(s)):
            found.add(s)
    return found


def _is_factor(users):
    """True of a step whose only use is in a product."""
    return len(users) == 1 and users[0].op in PRODUCT


def _everywhere_and_once(s, place, slip, users):
    """The edit wherever the step is used, and in one use alone if there are several."""
    rank, kind, words, expression, *does = slip
    named = f"{kind} {s.number} {place}"
    cause = words if isinstance(words, Cause) else computed(named, words, "", *does)
    yield Edit(rank, cause, {s.number: expression})
    if kind in (givens.TWICE, givens.HALF, givens.FOREIGN):
        return  # of one quantity, or a factor of one term; a unit is read once
    users = [user for user in users if user.op not in WITHIN] if len(users) > 1 else []
    if s.op in ("+", "-"):  # the square of a sum is written once
        products = {user for user in users if user.op in PRODUCT}
        pairs = [{a, b} for b in products for a in steps_in(b) if a in products]
        users = [user for user in users if not any(user in pair for pair in pairs)]
    for user in users if len(users) <= MANY and rank <= LESS else ():
        once = (user.op, *(expression if a is s else a for a in user.args))
        name = f"{kind} {s.number} {place} {user.number}"
        more, *in_one_place = _in_one_place(s, cause, kind, user)
        yield Edit(rank + more, computed(name, *in_one_place), {user.number: once})


def _in_one_place(s, cause, kind, user):
    """The rank added to a slip in one use, its words and what it does: a given that is zero or of
    the other sign in one product makes the product so.
    """
    is_factor = s.op == "argument" and user.op in PRODUCT
    term = described(user, "the term") if is_factor else ""
    if term and kind == "zero":
        words = Words("leaves out {term}: it is not zero here", term=term)
        return 1, words, "", LEFT_OUT, term
    if term and kind == "sign":
        words = Words("has {term} with the opposite sign: it points the other way", term=term)
        return ONCE, words, "", REVERSED, term
    words = Words("{cause.what}, in one place: {cause.why}", cause=cause.text)
    return ONCE, words, "", cause.does, cause.of


def _of_unchanged(answers, given, read):
    """A given, or its half, as the answer, or as the only component of it that is not zero; or the
    answer with its ratio to a given inverted.
    """
    for key, answer in answers.items():
        own, there = unit(answer.unit).dimension, [x for x in answer.parts if not is_nothing(x)]
        if len(there) != 1 or not isinstance(there[0], Step) or own == Dimension():
            continue
        (x,) = there
        for name, step in given.items():
            if x is step or read[name].dimension != own:
                continue
            for rank, part, other in ((FIRST, name, step), (LEAST, f"{name}/2", ("*", step, 0.5))):
                words = Words(
                    "takes {name} alone for {key}, as if nothing else counted", name=part, key=key
                )
                # where the answer is its half, a factor of 2 says it all
                cause = computed(f"{part} for {x.number}", words, does=FACTOR_2)
                yield Edit(rank, cause, {x.number: other})
            words = Words(INVERTED, key=key, name=name)
            inverted = ("/", ("*", step, step), x)
            yield Edit(LESS, computed(f"inverted {name} {x.number}", words), {x.number: inverted})


def _of_differences(answers, given, stages, dimensions):
    """Answers from another origin: a given subtracted or added; a quantity subtracted from all
    components.
    """
    less = Words("subtracts {name} from {key}: the whole is asked for")
    for key, answer in answers.items():
        for x in answer.parts:
            for name, step in given.items() if isinstance(x, Step) else ():
                if x is step or dimensions[x] is None or dimensions[x] != dimensions[step]:
                    continue
                more = Words("adds {name} to {key}: {key} alone is asked for", name=name, key=key)
                rest = Words("gives what is left of {name}: {key} is asked for", name=name, key=key)
                whole, half = (Words(less.template, name=n, key=key) for n in (name, f"{name}/2"))
                for what, text, other in (
                    ("less", whole, ("-", x, step)), ("more", more, ("+", x, step)),
                    ("rest", rest, ("-", step, x)),
                    ("less half", half, ("-", x, ("*", step, 0.5))),
                ):  # fmt: skip
                    cause = computed(f"{what} {name} {x.number}", text)
                    yield Edit(LEAST, cause, {x.number: other})
        for stage in stages if len(answer.parts) == 3 else ():
            pairs = [*zip(answer.parts, stage.parts, strict=False)]
            moved = [(a, x) for a, x in pairs if isinstance(x, Step)]
            if stage.means and moved and all(_are_alike(a, x, dimensions) for a, x in moved):
                words = Words(less.template, name=stage.means, key=key)
                instead = {a.number: ("-", a, x) for a, x in moved}
                yield Edit(LEAST, computed(f"less {stage.name} {key}", words), instead)


def _of_angles(answers):
    """The other angle between two lines, and that to the other axis."""
    angles = [a.parts[0] for a in answers.values() if unit(a.unit).is_of_angle]
    angles = [x for x in angles if isinstance(x, Step)]
    others = (
        (pi, Words("gives the supplement of the angle: the other one is asked for")),
        (pi / 2, Words("gives the angle to the normal: that to the line itself is asked for")),
    )
    for whole, words in others if angles else ():
        cause = computed(f"{whole} - angle", words)
        yield Edit(SIMPLE, cause, {x.number: ("-", whole, x) for x in angles})


def _of_stages(answers, stages, dimensions):
    """Answers that stop half way: a quantity of the same dimension, its size, a component."""
    vectors = [Stage(key, "", a.parts, key) for key, a in answers.items() if len(a.parts) == 3]
    known = {s.number for s, of in dimensions.items() if of is not None or s.op not in PRODUCT}
    for key, answer in answers.items():
        named = [s for s in stages if s.means]  # the others have no words
        for stage in (*named, *(vectors if len(answer.parts) == 1 else ())):
            for what, rank, parts in _instead(stage.parts, len(answer.parts)):
                instead = [*zip(answer.parts, parts, strict=True)]
                alike = all(_are_alike(a, x, dimensions) for a, x in instead)
                # no other quantity meets a vector of formulas by chance
                if not alike and not (answer.points > 1 and len(parts) == 3):
                    continue
                moved = {a.number: x for a, x in instead if isinstance(a, Step) and a is not x}
                there = {n: x for n, x in moved.items() if n in known}  # no component that is zero
                for n, some in enumerate([moved, there][: 2 if 0 < len(there) < len(moved) else 1]):
                    text = Words(
                        "takes {part}{quantity} for {key}: look up what {key} stands for",
                        part=what, quantity=stage.means, key=key,
                    )  # fmt: skip
                    if some:
                        yield Edit(rank, computed(f"{what} {stage.name} {key} {n}", text), some)


def _instead(parts, length):
    """(words, rank, expressions) by which a quantity stands for an answer of this length."""
    if len(parts) == length:
        yield "", RARER, parts
    elif length == 1 and len(parts) == 3:
        squares: Any = [("*", x, x) for x in parts]
        yield Words("the magnitude of "), RARER, [("sqrt", ("+", ("+", *squares[:2]), squares[2]))]
        for x in parts:
            yield Words("a component of "), LEAST, [("abs", x)]


def _are_alike(a, x, dimensions):
    """True if an expression has the dimension of a component, or both are constants."""
    if not isinstance(a, Step):
        return not isinstance(x, Step) and x == a
    while isinstance(x, tuple):
        x = x[-1] if x[0] != "sqrt" else x[1]
    return dimensions.get(a) is not None and dimensions.get(x) == dimensions[a]
