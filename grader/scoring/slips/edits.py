"""The slips that can be made in a traced computation, as edits of its steps, simplest first."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import product
from math import pi
from typing import Any

from newton_euler.algebra.language import Words
from newton_euler.algebra.source import WITHIN
from newton_euler.algebra.trace import Step
from newton_euler.algebra.units import unit
from newton_euler.answers.causes import FACTOR_2, INSTEAD, LEFT_OUT, REVERSED, Cause, computed
from newton_euler.answers.near import FIRST, LEAST, LESS, RARER, SIMPLE

from . import edits_of_givens as givens
from . import edits_of_groups as groups
from . import edits_of_operations as operations
from . import edits_of_quantities as quantities
from . import edits_of_wholes as wholes
from .edits_of_equations import of_equations
from .edits_of_integrals import of_integrals
from .edits_of_laws import of_laws
from .edits_of_roots import of_roots
from .facts import NUMBER, Facts
from .formulas import (
    PRODUCT,
    SUM,
    Edit,
    Formulas,
    Intermediate,
    edit,
    steps_in,
    steps_needed,
    total,
)
from .typed import described, is_nothing

MANY = 8  # uses of a step, beyond which single uses are not tried
INVERTED = Words("inverts the ratio of {key} to {name}: it is the other way round")
ONCE = 4  # added to the rank of a slip in one use, over that of the same slip in all
LESS_THAN = Words("subtracts {name} from {key}: the whole is asked for")
MORE_THAN = Words("adds {name} to {key}: {key} alone is asked for")
REST_OF = Words("gives what is left of {name}: {key} is asked for")
HALF_WAY = Words("takes {part}{quantity} for {key}: look up what {key} stands for")
OTHER_ANGLES = (
    (pi, Words("gives the supplement of the angle: the other one is asked for")),
    (pi / 2, Words("gives the angle to the normal: the angle to the line itself is asked for")),
)


def edits_of(formulas: Formulas) -> list[Edit]:
    """The edits of the steps that the answers need, each with the place where the book has it."""
    stages = [s for s in formulas.stages if any(isinstance(x, Step) for x in s.parts)]
    _call(formulas)
    cones = sorted(
        (({s.number for s in steps_needed(stage.parts)}, stage.where) for stage in stages),
        key=lambda cone: len(cone[0]),
    )
    found = sorted(_edits(Facts(formulas)), key=lambda e: e.rank)
    return [e._replace(cause=_placed(e, cones, formulas.where)) for e in found]


def _call(formulas):
    """Name the steps that are answers, and describe those that are quantities."""
    for key, answer in formulas.answers.items():
        for x in answer.parts if len(answer.parts) == 1 else ():
            if isinstance(x, Step):
                x.trace.called.setdefault(x.number, key)
    for stage in formulas.stages:
        words = stage.means
        if len(stage.parts) > 1:
            words = Words("a component of {what}", what=stage.means)
        is_named = len(stage.parts) == 1 or stage.kind.is_along_axes
        for x in stage.parts if stage.means and is_named else ():
            if isinstance(x, Step):
                x.trace.meant.setdefault(x.number, words)


def _placed(edit, cones, otherwise):
    """The cause with the place of the first quantity that is computed by what is edited."""
    edited = edit.instead.keys()
    around = (where for cone, where in cones if where and edited and edited <= cone)
    where = next(around, otherwise)
    return edit.cause.at(where)


def _edits(f):
    yield from f.formulas.setups
    for edits in OF_GIVENS:
        yield from edits(f)
    yield from _instead_of(f.answers, (edit for edits in OF_ANSWERS for edit in edits(f)))
    for edits in OF_QUANTITIES:
        yield from edits(f)
    for s, users in f.users.items():
        for n, slip in enumerate(_of_step(f, s, users) if s in f.written else ()):
            yield from _everywhere_and_once(s, n, slip, [u for u in users if u not in f.unwritten])


def _instead_of(answers, edits):
    """The edits, each with the answers that it replaces."""
    keys: dict[int, set[str]] = {}
    for key, answer in answers.items():
        for x in answer.parts:
            keys.setdefault(getattr(x, "number", -1), set()).add(key)
    for e in edits:
        names = tuple(sorted({key for n in e.instead for key in keys.get(n, ())}))
        cause = e.cause if e.cause.does else replace(e.cause, does=INSTEAD, answers=names)
        yield e._replace(cause=cause)


def _of_step(f, s, users):
    """The slips in one step."""
    yield from operations.of_operation(s, f.number)
    yield from operations.of_moment(s, f.of)
    if s.op == "argument":
        # a given alone in its term, as H in D^2 + H^2, is not a factor
        is_factor = s in f.factors or any(user.op in WITHIN for user in users)
        yield from (x for x in givens.of_given(s, f) if x[1] != givens.ONE or is_factor)
        if s.args[0] in f.numbers:  # symbols of a formula need no conversion
            yield from givens.of_unit(s, f.read[s.args[0]], f.system)
    if s in f.products:
        yield from operations.of_product(s, f.number, f.of)
        yield from quantities.of_shared(s) if len(users) > 1 else ()


def _everywhere_and_once(s, place, slip, users):
    """The edit wherever the step is used, and in one use alone if there are several."""
    rank, kind, words, expression, *does = slip
    named = f"{kind} {s.number} {place}"
    cause = words if isinstance(words, Cause) else computed(named, words, "", *does)
    yield Edit(rank, cause, {s.number: expression})
    if kind in (givens.TWICE, givens.HALF, givens.FOREIGN):
        return  # twice and half have edits of single uses elsewhere; a unit is read once
    users = [user for user in users if user.op not in WITHIN] if len(users) > 1 else []
    if s.op in SUM:  # the square of a sum is written once
        products = {user for user in users if user.op in PRODUCT}
        pairs = [{a, b} for b in products for a in steps_in(b) if a in products]
        users = [user for user in users if not any(user in pair for pair in pairs)]
    for user in users if len(users) <= MANY and rank <= LESS else ():
        once = (user.op, *(expression if a is s else a for a in user.args))
        name = f"{kind} {s.number} {place} {user.number}"
        more, *in_one_place = _in_one_place(s, cause, kind, user)
        yield Edit(rank + more, computed(name, *in_one_place), {user.number: once})


def _in_one_place(s, cause, kind, user):
    """The rank added to a slip in one use, its words, and what it does to which term."""
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


def _of_unchanged(f):
    """A given, or its half, as the answer; the ratio of the answer to a given inverted."""
    for key, answer in f.answers.items():
        own, there = unit(answer.unit).dimension, [x for x in answer.parts if not is_nothing(x)]
        if len(there) != 1 or not isinstance(there[0], Step) or own == NUMBER:
            continue
        (x,) = there
        for name, step in f.given.items():
            if x is step or f.read[name].dimension != own:
                continue
            for rank, part, other in ((FIRST, name, step), (LEAST, f"{name}/2", ("*", step, 0.5))):
                words = Words(
                    "takes {name} alone for {key}, as if nothing else counted", name=part, key=key
                )
                # where the answer is its half, a factor of 2 says it all
                yield edit(rank, f"{part} for {x.number}", words, {x.number: other}, FACTOR_2)
            inverted = ("/", ("*", step, step), x)
            words = Words(INVERTED, key=key, name=name)
            yield edit(LESS, f"inverted {name} {x.number}", words, {x.number: inverted})


def _of_differences(f):
    """A given added to an answer or subtracted; a quantity subtracted from a vector."""
    for key, answer in f.answers.items():
        steps = [x for x in answer.parts if isinstance(x, Step) and f.of(x) is not None]
        for x, (name, step) in product(steps, f.numbers.items()):
            if x is step or f.of(x) != f.of(step):
                continue
            for what, n, text, other in (
                ("less", name, LESS_THAN, ("-", x, step)),
                ("more", name, MORE_THAN, ("+", x, step)),
                ("rest", name, REST_OF, ("-", step, x)),
                ("less half", f"{name}/2", LESS_THAN, ("-", x, ("*", step, 0.5))),
            ):
                words = Words(text, name=n, key=key)
                yield edit(LEAST, f"{what} {name} {x.number}", words, {x.number: other})
        for stage in f.stages if answer.kind.is_vector else ():
            pairs = [*zip(answer.parts, stage.parts, strict=False)]
            moved = [(a, x) for a, x in pairs if isinstance(x, Step)]
            if stage.means and moved and all(f.alike(a, x) for a, x in moved):
                words = Words(LESS_THAN, name=stage.means, key=key)
                instead = {a.number: ("-", a, x) for a, x in moved}
                yield edit(LEAST, f"less {stage.name} {key}", words, instead)


def _of_angles(f):
    """The other angle between two lines, and that to the other axis."""
    angles = [a.parts[0] for a in f.answers.values() if unit(a.unit).is_of_angle]
    angles = [x for x in angles if isinstance(x, Step)]
    for whole, words in OTHER_ANGLES if angles else ():
        instead: dict[int, Any] = {x.number: ("-", whole, x) for x in angles}
        yield edit(SIMPLE, f"{whole} - angle", words, instead)


def _of_stages(f):
    """Answers that stop half way: a quantity of the same dimension, its size, a component."""
    vectors = [
        Intermediate(key, "", a.parts, a.kind, key)
        for key, a in f.answers.items()
        if a.kind.is_vector
    ]
    known = {s.number for s, of in f.dimensions.items() if of is not None or s.op not in PRODUCT}
    for key, answer in f.answers.items():
        named = [s for s in f.stages if s.means]  # the others have no words
        for stage in (*named, *(vectors if len(answer.parts) == 1 else ())):
            for what, rank, parts in _instead(stage, len(answer.parts)):
                instead = [*zip(answer.parts, parts, strict=True)]
                alike = all(f.alike(a, x) for a, x in instead)
                # no other quantity agrees with a vector of formulas by chance
                if not alike and not (answer.points > 1 and answer.kind.is_vector):
                    continue
                moved = {a.number: x for a, x in instead if isinstance(a, Step) and a is not x}
                there = {n: x for n, x in moved.items() if n in known}  # no component that is zero
                words = Words(HALF_WAY, part=what, quantity=stage.means, key=key)
                for n, some in enumerate([moved, there][: 2 if 0 < len(there) < len(moved) else 1]):
                    if some:
                        yield edit(rank, f"{what} {stage.name} {key} {n}", words, some)


def _instead(stage, length):
    """(words, rank, expressions) of a quantity in place of an answer of this length."""
    if len(stage.parts) == length:
        yield "", RARER, stage.parts
    elif length == 1 and stage.kind.is_vector:
        size = ("sqrt", total(("*", x, x) for x in stage.parts))
        yield Words("the magnitude of "), RARER, [size]
        for x in stage.parts:
            yield Words("a component of "), LEAST, [("abs", x)]


Edits = tuple[Callable[[Facts], Iterator[Edit]], ...]
# edits of givens, and of whole answers by them
OF_GIVENS: Edits = (
    operations.of_angles, groups.of_constants, givens.of_one_unit, givens.of_exchanged,
    givens.of_planes, givens.of_rates, wholes.of_wholes, wholes.of_sides, wholes.of_unneeded,
    givens.of_lengths, givens.of_loads, givens.of_vectors, givens.of_earlier,
    givens.of_projections, of_integrals, of_roots, givens.of_weights,
)  # fmt: skip
# edits that put something else in place of a whole answer
OF_ANSWERS: Edits = (
    wholes.of_quantities_in_wholes, wholes.of_sums, wholes.of_single_terms, _of_unchanged,
    _of_differences, _of_stages, quantities.of_ratios, of_laws,
)  # fmt: skip
# edits of quantities on the way, of equations, and of several places at once
OF_QUANTITIES: Edits = (
    _of_angles, of_equations, quantities.of_quantities, quantities.of_rods,
    quantities.of_cross_products, quantities.of_distances, quantities.of_givens_in_products,
    quantities.of_mean_rates, quantities.of_densities, quantities.of_areas,
    quantities.of_transfers, quantities.of_masses, quantities.of_squares,
    quantities.of_sums_squared, quantities.of_slopes, quantities.of_differences_of_squares,
    groups.of_terms, groups.of_factors,
)  # fmt: skip
