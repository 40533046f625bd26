"""Slips in setting up a system: a point or a vector along another axis, a rotation about another
one, parallel-axis terms left out. A trace holds no zeros, so each slip is traced anew.
"""

from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import partial
from itertools import combinations
from typing import Any

from newton_euler.algebra.jets import Moving
from newton_euler.algebra.language import Words, joined
from newton_euler.algebra.otherwise import built_otherwise
from newton_euler.algebra.scalars import ZERO, NewtonEulerError, sqrt
from newton_euler.algebra.source import WITHIN
from newton_euler.algebra.trace import Step
from newton_euler.algebra.vectors import add3, cross3, dot3, scale3, sub3
from newton_euler.answers.causes import LEFT_OUT, computed
from newton_euler.answers.near import LEAST, LESS, RARER

from .edits_of_terms import is_there, rotated_components, scalars_in
from .formulas import Edit, steps_needed
from .typed import described

Answers = Mapping[str, Sequence[Any]]
Parts = tuple[Any, ...]
Way = tuple[int, str, Parts]  # rank, words, the parts instead

MOVED = Words("puts {what} along another axis: look where it points in the figure")
EXCHANGED = Words("exchanges two components of the vector with {what}: each has its axis")
SIDE = Words("has {what} on the other side: look where it points in the figure")
AT_REST = Words("leaves out the motion with {what}: that point is not at rest")
NOT_LESS = Words("does not subtract {what}: the difference of two vectors is needed")
NOTHING = Words("leaves out the vector of {what}: it is not zero here")
NO_TURN = Words("leaves out the rotation with {what}: it goes on at this instant")
ONE_TURN = Words(
    "leaves out one of the rotations of a body: all of them add to its angular velocity"
)
OTHER_WAY = Words("turns {what} the other way: look for its sense in the figure")
ABOUT = Words("has {what} about another axis: look for its axis in the figure")
NO_TRANSFER = Words(
    "leaves out the parallel-axis terms of the body with its centre at {what}: "
    "the axes do not pass through it"
)
NO_PARTICLE = Words("leaves out the particle at {what}: it has a moment of inertia, too")
NO_TRANSFERS = Words(
    "leaves out all parallel-axis terms: the axes do not pass through the centres of the bodies"
)
LINEAR = Words("keeps {name} to first order only: it is not small")
TRANSFERRED = Words("the parallel-axis terms")
BRIEF = 16  # letters of a component that is named
AT_G = Words("takes the moments of inertia about the centre of mass: another point is asked for")
OF_MASS = Words("the body of mass {m}")
NO_BODY = Words("leaves out {body}: it contributes, too")
AS_PARTICLE = Words("takes {body} as a particle: it has moments of inertia of its own")
TURNS_ONLY = Words("leaves out the translation of {body}: its centre of mass moves")
PARTICLES = Words("takes all bodies as particles: they have moments of inertia of their own")
NOT_CUT = Words("adds {body}, which is cut out: it is subtracted")
ITSELF = Words("does not differentiate the vector: its rate is asked for")
NO_COSINE = Words(
    "multiplies the magnitudes of two vectors: only the component along the other counts"
)
SINE = Words("takes the sine of the angle between two vectors: a scalar product has its cosine")
VELOCITY = Words("takes a velocity for the acceleration: that is its rate")
IN_GROUND = Words(
    "uses the velocity in the ground in the Coriolis term: "
    "it needs that relative to the moving frame"
)
TO_ORIGIN = Words(
    "takes omega^2 r as the centripetal acceleration: it points to the axis, not to the origin"
)
CONSTANT = Words("takes {what} as constant: it changes with time")
INNER = Words("leaves out the inner derivative {what}: the chain rule brings it in")
SLOPE = Words(
    "has the wrong sign in differentiating a function of {what}: the derivative of a cosine is "
    "minus the sine"
)
SIMPLE = ("+", "-", "*", "neg", "argument", "item")
MANY = 12  # parts of a kind in a problem, beyond which none is set up otherwise


def of_setups(
    compute: Callable[[Mapping[str, Any]], Answers],
    given: Mapping[str, Step],
    vectors: Collection[str],
) -> Iterator[Edit]:
    """The answers with one part of the system set up otherwise, or with a given taken as small;
    ``compute`` returns them for other values of some givens. ``vectors``: those that are vectors.
    """
    built: dict[Any, tuple[str, Parts, Parts]] = {}
    trace = next(iter(given.values())).trace if given else None

    def note(kind, parts, of):
        inside = [*scalars_in((*parts, *of))]
        # unknowns, and what is inside an integral, have no steps of their own
        usual = all(x is ZERO or isinstance(x, (Step, float, int, str)) for x in inside)
        steps = [x for x in inside if isinstance(x, Step)]
        if steps and usual and all(x.trace is trace for x in steps):
            built.setdefault(_key(kind, parts, of), (kind, parts, tuple(of)))
        return parts

    with built_otherwise(note):
        right = compute({})
    seen, known = {_same(right)}, _within(right)
    curved = _curved(right)
    # a single component of a turn about another axis fits other mistakes, too
    in_space = [k for k, x in right.items() if k in vectors and sum(map(is_there, x)) > 1]
    for kind, name, rank, words, find in (
        *_otherwise(compute, built, in_space),
        *_small(compute, {n: s for n, s in given.items() if s in curved}),
    ):
        try:
            answers = find()
        except (NewtonEulerError, ArithmeticError, TypeError, ValueError):
            continue
        same = _same(answers)
        if same not in seen and _within(answers) <= known:
            seen.add(same)
            if kind == "axis":
                answers = {key: answers[key] for key in in_space}
            does = (LEFT_OUT, TRANSFERRED) if kind == "transfer" else ()
            yield Edit(rank, computed(name, words, "", *does), {}, answers)


def _otherwise(compute, built, in_space):
    """(kind, name, rank, words, function that returns the answers) of one part set up otherwise, of
    all parallel-axis terms left out, of all bodies as particles.
    """
    kinds = Counter(kind for kind, _, _ in built.values())
    own = {key for key, (kind, _, of) in built.items() if kind == "transfer" and _is_body(of)}
    bodies = {k for k, (kind, parts, _) in built.items() if kind == "body" and _is_body(parts)}
    for kind, keys, words, instead in (
        ("transfer", own, NO_TRANSFERS, lambda parts: (0,)),
        ("body", bodies, PARTICLES, lambda parts: (parts[0], *[0] * len(parts[1:]))),
    ):
        if len(keys) > 1:
            yield kind, f"every {kind}", RARER, words, partial(_answers, compute, keys, instead)
    for n, (key, (kind, parts, of)) in enumerate(built.items()):
        ways = [kind, *["axis"] * (kind == "turn" and bool(in_space))]
        for what in ways if kinds[kind] <= MANY else ():
            for m, (rank, words, instead) in enumerate(_WAYS[what](parts, of)):
                find = partial(_answers, compute, {key}, lambda _, new=instead: new)
                yield what, f"{what} {n} {m}", rank, words, find


def _answers(compute, keys, instead):
    def change(kind, parts, of):
        return instead(parts) if _key(kind, parts, of) in keys else parts

    with built_otherwise(change):
        return compute({})


def _small(compute, given):
    """The same with each given as if it were small: linearised in it."""
    for name, step in given.items():
        words = Words(LINEAR, name=name)
        yield "linear", f"linear {name}", LEAST, words, partial(_linear, compute, name, step)


def _linear(compute, name, step):
    return {
        key: [x.value + x.rate if isinstance(x, Moving) else x for x in parts]
        for key, parts in compute({name: Moving(0.0, step)}).items()
    }


def _curved(answers):
    """The steps in which the answers are not polynomial."""
    inside = []
    for s in steps_needed(x for parts in answers.values() for x in parts):
        inside += s.args[1:] if s.op == "/" else () if s.op in SIMPLE else s.args
    return {*steps_needed(inside)}


def _within(answers):
    """The integrals and roots in the answers: others may have no value."""
    leaves = [x for parts in answers.values() for x in parts]
    return {s.number for s in steps_needed(leaves) if s.op in WITHIN}


def _key(kind, parts, of):
    return kind, *map(_plain, (*scalars_in(parts), *scalars_in(of)))


def _plain(x):
    """A key by which scalars of the same value are equal; of other kinds of number none are."""
    if isinstance(x, Step):
        return Step, x.number
    return (type(x), x) if x is ZERO or isinstance(x, (float, int, str)) else object()


def _same(answers):
    return tuple((key, *map(_plain, parts)) for key, parts in answers.items())


def _named(parts):
    """Components in words, as they are typed; "" if one has none, or long ones."""
    steps = [[s for s in scalars_in([x]) if isinstance(s, Step)] for x in parts]
    words = [described(s.args[0] if s.op == "neg" else s) for s, *_ in filter(None, steps)]
    return joined(words) if words and all(0 < len(x) <= BRIEF for x in words) else ""


def _of_vector(parts, of):
    """A vector with other components, not subtracted, or left out."""
    yield from _of_components(parts, of)
    there = [x for x in parts if is_there(x)]
    differ = all(isinstance(x, Step) and x.op == "-" for x in there)
    if differ and (what := _named([x.args[1] for x in there])):
        minuend = tuple(x.args[0] if isinstance(x, Step) else x for x in parts)
        yield LESS, Words(NOT_LESS, what=what), minuend
    if what := _named(parts):
        yield LEAST, Words(NOTHING, what=what), (0, 0, 0)


def _of_components(parts, of):
    """A point or a vector with a component reversed or along another axis, two exchanged, or at
    rest.
    """
    there = [n for n, x in enumerate(parts) if is_there(x)]
    for n in there:
        if what := _named([parts[n]]):
            reversed_one = tuple(-x if m == n else x for m, x in enumerate(parts))
            yield LEAST, Words(SIDE, what=what), reversed_one
    moving = [x for x in parts if isinstance(x, Moving)]
    if what := _named([Moving(x.rate, x.acceleration) for x in moving]):
        at_rest = tuple(x.value if isinstance(x, Moving) else x for x in parts)
        yield LESS, Words(AT_REST, what=what), at_rest
    for n, m in combinations(range(3), 2):
        if not {n, m} & {*there}:
            continue
        what = _named([parts[k] for k in (n, m) if k in there])
        if not what:
            continue
        if {n, m} <= {*there}:
            yield LESS, Words(EXCHANGED, what=what), rotated_components(parts, n, m, 1, 1)
        else:
            yield LESS, Words(MOVED, what=what), rotated_components(parts, n, m, 1, -1)
            yield LESS, Words(MOVED, what=what), rotated_components(parts, n, m, -1, 1)


def _of_turn(parts, of):
    axis, angle = parts
    what = _named([angle.rate])
    if any(isinstance(x, Step) for x in scalars_in([Moving(angle.rate, angle.acceleration)])):
        yield LEAST, Words(NO_TURN, what=what) if what else ONE_TURN, (axis, Moving(angle.value))
    if what := what or _named([angle.value]):
        yield LEAST, Words(OTHER_WAY, what=what), (axis, -angle)


def _of_axis(parts, of):
    axis, angle = parts
    what = _named([angle.rate]) or _named([angle.value])
    own = axis.removeprefix("-") if isinstance(axis, str) else ""
    for other in "xyz" if own and what else "":
        for sign in ("", "-") if other != own else ():
            # rarer than taking one given for another, which may give the same answers
            yield LEAST + 2, Words(ABOUT, what=what), (sign + other, angle)


def _of_transfer(parts, of):
    _, *way = of[:4]
    words = NO_TRANSFER if _is_body(of) else NO_PARTICLE
    if what := _named(way):
        yield RARER, Words(words, what=what), (0,)


def _is_body(parts):
    """False of a particle: its own moments of inertia, the last of the parts, are zero."""
    return any(map(is_there, parts[-3:]))


def _of_matrix(parts, of):
    if of:
        yield RARER, AT_G, of


def _of_rate(parts, of):
    yield LESS, ITSELF, of


def _of_body(parts, of):
    mass, *own = parts
    words = described(mass)
    body = Words(OF_MASS, m=words) if words else ""
    if body and any(map(is_there, own)):
        yield RARER, Words(AS_PARTICLE, body=body), (mass, *[0] * len(own))
        yield LEAST, Words(TURNS_ONLY, body=body), (0, *own)
    if body:
        yield LESS, Words(NO_BODY, body=body), (0,) * len(parts)
    if body and isinstance(mass, Step) and mass.op == "neg":
        yield LESS, Words(NOT_CUT, body=body), tuple(-x for x in parts)


def _of_motion(parts, of):
    v, v_r, omega, own, r = (of[n : n + 3] for n in range(0, 15, 3))
    yield LEAST, VELOCITY, v
    if all(any(map(is_there, x)) for x in (v_r, omega)):
        off = cross3(omega, scale3(2, sub3(v, v_r)))
        yield LEAST, IN_GROUND, add3(parts, off)
    if is_there(along := dot3(own, r)):  # omega x (omega x r) = omega (omega . r) - omega^2 r
        yield LEAST, TO_ORIGIN, sub3(parts, scale3(along, own))


def _of_dot(parts, of):
    """The product of the magnitudes, or the size of the cross product, for a scalar product."""
    if is_there(parts[0]):
        a, b = of[:3], of[3:]
        yield LEAST, NO_COSINE, (sqrt(dot3(a, a)) * sqrt(dot3(b, b)),)
        c = cross3(a, b)
        yield LEAST, SINE, (sqrt(dot3(c, c)),)


def _of_coordinate(parts, of):
    (r,) = parts
    if (what := _named([r])) and any(isinstance(x, Step) for x in (r.rate, r.acceleration)):
        yield LESS, Words(CONSTANT, what=what), (Moving(r.value),)


def _of_chain(parts, of):
    rate, growth, slope, curvature = parts
    if what := _named([rate]):
        yield LESS, Words(INNER, what=what), (1, ZERO, slope, curvature)
    if what := _named(of):
        for sign in (-1, 1):
            yield LEAST, Words(SLOPE, what=what), (rate, growth, -slope, sign * curvature)


_WAYS: Mapping[str, Callable[[Parts, Parts], Iterator[Way]]] = {
    "point": _of_components,
    "vector": _of_vector,
    "turn": _of_turn,
    "axis": _of_axis,
    "transfer": _of_transfer,
    "matrix": _of_matrix,
    "rate": _of_rate,
    "body": _of_body,
    "motion": _of_motion,
    "dot": _of_dot,
    "coordinate": _of_coordinate,
    "chain": _of_chain,
}
