"""The slips that can be made in a traced computation, as edits of its steps, simplest first."""

from functools import partial
from math import pi
from typing import Any

from ..algebra.source import WITHIN
from ..algebra.trace import Step
from ..algebra.units import SI, US, Dimension, unit
from .causes import Cause, computed
from .edits_of_givens import of_given, of_one_unit, of_unit
from .edits_of_operations import (
    PRODUCT,
    of_angles,
    of_constants,
    of_moment,
    of_operation,
    of_product,
)
from .formulas import (
    LEAST,
    LESS,
    RARER,
    Edit,
    Formulas,
    Stage,
    dimensions_of,
    needed,
    users_of,
)

MANY = 8  # uses of a step, of which no single one is looked at


def edits_of(formulas: Formulas) -> list[Edit]:
    """The edits of the steps that the answers need, each with the place where the book has it."""
    stages = [s for s in formulas.stages if any(isinstance(x, Step) for x in s.parts)]
    cones = sorted(
        (({s.number for s in needed(stage.parts)}, stage.where) for stage in stages),
        key=lambda cone: len(cone[0]),
    )
    found = sorted(_edits(formulas), key=lambda e: e.rank)
    return [e._replace(cause=_placed(e, cones, formulas.where)) for e in found]


def _placed(edit, cones, otherwise):
    """The cause with the place of the first quantity that is computed by what is edited."""
    edited = edit.instead.keys()
    where = next((where for cone, where in cones if where and edited <= cone), otherwise)
    return edit.cause.at(where)


def _edits(formulas):
    answers, system = formulas.answers, formulas.system
    steps = needed(x for a in answers.values() for x in a.parts)
    given = {s.args[0]: s for s in steps if s.op == "argument"}
    read = {name: unit(formulas.units[name]) for name in given}
    every = needed(x for a in (*answers.values(), *formulas.stages) for x in a.parts)
    dimensions = dimensions_of(every, {n: unit(u) for n, u in formulas.units.items()})
    own = US if any(u.is_of_feet for u in read.values()) else SI
    number = partial(_number, dimensions, system, own)
    yield from of_angles(steps)
    yield from of_constants(steps)
    yield from of_one_unit(given, read, system)
    yield from _of_wholes(answers, given, number)
    yield from _of_stages(answers, formulas.stages, dimensions)
    yield from _of_angles(answers)
    leaves = {x for a in answers.values() for x in a.parts if isinstance(x, Step)}
    for s, users in users_of(steps).items():
        slips = [*of_operation(s), *of_moment(s, dimensions[s])]
        if s.op == "argument":
            name = s.args[0]
            slips += of_given(s, given, read, number, formulas.means.get(name, ""))
            slips += of_unit(s, read[name], system)
        if s.op in PRODUCT and (s in leaves or not _is_factor(users)):
            slips += of_product(s, number, lambda s: dimensions.get(s) != Dimension())
        for n, slip in enumerate(slips):
            yield from _everywhere_and_once(s, n, slip, users)


def _is_factor(users):
    """True of what is a factor of one product."""
    return len(users) == 1 and users[0].op in PRODUCT


def _number(dimensions, system, own, s):
    """The number by which a student multiplies for a step: in feet and pounds, where the text is,
    another one than in the ``system`` in which the steps are computed.
    """
    dimension = dimensions[s]
    if system is own or dimension is None:
        return s
    return ("*", s, float(system.factor(dimension) / own.factor(dimension)))


def _everywhere_and_once(s, place, slip, users):
    """The edit wherever the step is used, and in one use alone if there are several."""
    rank, kind, words, expression = slip
    cause = words if isinstance(words, Cause) else computed(f"{kind} {s.number} {place}", words)
    yield Edit(rank, cause, {s.number: expression})
    users = [user for user in users if user.op not in WITHIN] if len(users) > 1 else []
    for user in users if len(users) <= MANY and rank <= LESS else ():
        once = (user.op, *(expression if a is s else a for a in user.args))
        name = f"{kind} {s.number} {place} {user.number}"
        in_one_place = f"{cause.what}, in one place: {cause.why}"
        yield Edit(rank + 2, computed(name, in_one_place), {user.number: once})


def _of_wholes(answers, given, number):
    """Whole answers with a given too many or too few."""
    components = [x for a in answers.values() for x in a.parts if isinstance(x, Step)]
    for name, step in given.items():
        for op, words in (("/", "few"), ("*", "many")):
            text = f"has one factor {name} too {words}: put your units into the whole formula"
            cause = computed(f"whole {op} {name}", text)
            instead = {x.number: (op, x, number(step)) for x in components if x is not step}
            yield Edit(LESS, cause, instead)


def _of_angles(answers):
    """The other angle between two lines, and that to the other axis."""
    angles = [a.parts[0] for a in answers.values() if unit(a.unit).is_of_angle]
    angles = [x for x in angles if isinstance(x, Step)]
    others = (
        (pi, "the supplement of the angle: the other one between the lines is meant"),
        (pi / 2, "the angle to the normal: that to the line itself is meant"),
    )
    for whole, words in others if angles else ():
        cause = computed(f"{whole} - angle", f"gives {words}")
        yield Edit(RARER, cause, {x.number: ("-", whole, x) for x in angles})


def _of_stages(answers, stages, dimensions):
    """Answers that stop on the way: a quantity of the same dimension, its size, a component."""
    vectors = [Stage(key, "", a.parts) for key, a in answers.items() if len(a.parts) == 3]
    for key, answer in answers.items():
        for stage in (*stages, *(vectors if len(answer.parts) == 1 else ())):
            for what, rank, parts in _instead(stage.parts, len(answer.parts)):
                instead = dict(zip(answer.parts, parts, strict=True))
                moved = {a: x for a, x in instead.items() if isinstance(a, Step) and a is not x}
                if moved and all(_are_alike(a, x, dimensions) for a, x in instead.items()):
                    named = f"the {stage.means}" if stage.means else stage.name
                    text = f"gives {what}{named} here: {key} is asked for"
                    cause = computed(f"{what} {stage.name} {key}", text)
                    yield Edit(rank, cause, {a.number: x for a, x in moved.items()})


def _instead(parts, length):
    """(words, rank, expressions) of what a quantity may be for an answer of this length."""
    if len(parts) == length:
        yield "", RARER, parts
    elif length == 1 and len(parts) == 3:
        squares: Any = [("*", x, x) for x in parts]
        yield "the size of ", RARER, [("sqrt", ("+", ("+", *squares[:2]), squares[2]))]
        for x in parts:
            yield "a component of ", LEAST, [("abs", x)]


def _are_alike(a, x, dimensions):
    """True if an expression has the dimension of a component, or both are constants."""
    if not isinstance(a, Step):
        return not isinstance(x, Step) and x == a
    while isinstance(x, tuple):
        x = x[-1] if x[0] != "sqrt" else x[1]
    return dimensions.get(a) is not None and dimensions.get(x) == dimensions[a]
