"""Checks of a problem: solve and prove agree, units fit, mistakes differ from the key."""

import random
from collections.abc import Mapping
from contextlib import suppress
from itertools import combinations
from typing import Any

from mpmath import mp, mpc, mpf

from newton_euler.algebra.late import np
from newton_euler.algebra.scalars import SingularError, max_abs
from newton_euler.algebra.units import Dimension, DimensionError, unit
from newton_euler.algebra.vectors import Vector

from .errors import error_sentence, meant
from .following import earlier_answers, follow
from .model import CatalogueError, Problem
from .overlooked import overlooked
from .proofs import DIGITS
from .steps import faults as step_faults
from .steps import in_unit, steps
from .units import lineage
from .variants import apart, at_points, distance, draw, flat, symbol_points, symbol_values
from .words import word

# relative, of solve in floats and prove; in 50 digits the limit is its square
AGREEMENT = 1e-9
_SEED = b"check"


def check(p: Problem, seeds: int = 1) -> list[str]:
    """The faults of problem ``p``, as sentences.

    Checks the book's numbers (seed 0) and ``seeds - 1`` drawn variants: answers and steps against
    prove, in floats and in 50 digits; each mistake against the key; and once, by running ``solve``
    and ``steps`` on dimensions, the units of answers and steps.
    """
    try:
        proof = _Proof(p)
        faults = _fit(p, proof) or _dimensions(p)
        for n in _different(p, seeds):
            faults = faults or [f"{fault} (seed {n})" for fault in _agreement(p, n, proof)]
        return faults or overlooked(p, seeds)
    except CatalogueError as error:
        return [str(error)]
    except Exception as error:  # problem code may raise anything
        return [error_sentence(p.id, error)]


class _Proof:
    """Results of ``prove`` in 50 digits, cached: they take half the time of a check."""

    def __init__(self, p):
        self.p, self.found = p, {}

    def __call__(self, given):
        numbers = tuple(given.items())
        if numbers not in self.found:
            with mp.workdps(DIGITS):  # the precision at which roots and series stop
                self.found[numbers] = self.p.code.prove(_precise(self.p, given))
        return self.found[numbers]


def alike(p: Problem, seeds: int = 1) -> list[str]:
    """Warnings, as sentences: mistakes that give the same wrong answer for all numbers, so that a
    diagnosis cannot tell them apart; and those with the dimension of another answer.
    """
    same = None
    for n in _different(p, seeds):
        wrong = at_points(p, values(p, n))[1]
        pairs = {
            (key, one, other)
            for one, other in combinations(wrong, 2)
            for key in wrong[one].keys() & wrong[other].keys()
            # mistakes in one of few words often coincide
            if not p.answer(key).kind.has_options and _same(wrong[one][key], wrong[other][key])
        }
        same = pairs if same is None else same & pairs
    return [
        f"the mistakes {one} and {other} give the same wrong {key}: a student sees both texts"
        for key, one, other in sorted(same or ())
    ] + _exchanged(p)


def _same(a, b):
    """Whether two wrong answers, tuples of points, agree."""
    return all(distance(x, y) <= AGREEMENT for x, y in zip(a, b, strict=True))


def _different(p, seeds):
    """The seeds below ``seeds`` that give different numbers: seed 0 alone if nothing varies."""
    varies = p.symbols or any(g.vary for g in p.givens.values())
    return range(seeds if varies else min(seeds, 1))


def values(p: Problem, seed: int) -> dict[str, float]:
    """The numbers of the book (seed 0) or of a variant, with a value for every symbol."""
    given = p.book_values if seed == 0 else draw(p, _SEED + str(seed).encode())
    return {**given, **symbol_values(p, random.Random(f"{p.id}:{seed}"))}


def _fit(p, proof):
    """Faults where the names in the text and in the code differ."""
    # arrays, which give nan where floats raise: formulas need not be real here
    g = p.base({n: np.atleast_1d(float(x)) for n, x in values(p, 0).items()})
    with np.errstate(all="ignore"):
        solved = p.code.solve(g)
        before = _frames(solved)  # now, since frames of a call to come may be in the same trees
        again, named = p.code.solve(g), p.code.mistakes(g)
    asked = [a.key for a in p.answers]
    proved = dict.fromkeys(asked)
    with suppress(SingularError):  # not real here either
        proved = proof(values(p, 0))
    if any(isinstance(x, Vector) for x in proved.values()):
        return ["prove returns vectors of the engine: find the answers in another way, as lists"]
    todo = "is in {}.yaml but not computed; compute it, or move it to struck: with a reason"
    faults = [f"the mistake {m} {todo.format(p.name)}" for m in p.mistakes if m not in named]
    undescribed = [m for m in named if m not in p.mistakes]
    lacks = f"is computed but not in {p.name}.yaml"
    faults += [f"the mistake {m} {lacks}{meant(m, p.mistakes)}" for m in undescribed]
    for what, got in (("solve", list(solved)), ("prove", list(proved)[: len(asked)])):
        if got != asked:
            close = "".join(meant(k, asked) for k in got if k not in asked)
            return [*faults, f"{what} returns {got} but the problem asks for {asked}{close}"]
    faults += _shared_frames(before, again)
    for name, answers in named.items():
        if not answers or not set(answers) <= set(asked):
            gives = f"gives {list(answers)}"
            faults.append(f"the mistake {name} must give some of {asked}, but {gives}")
        for key, answer in answers.items():
            here = getattr(answer, "frame", None)
            if key in solved and here and lineage(here) != lineage(there := solved[key].frame):
                faults.append(
                    f"{key} is in {there.name}, but the mistake {name} has it in {here.name}: use "
                    "in_frame"
                )
    return faults


def _frames(answers):
    """All frames in the trees of the answers."""
    return {f for x in answers.values() if isinstance(x, Vector) for f in x.frame.tree}


def _shared_frames(before, answers):
    """A fault if frames of answers share a tree with those ``before``, of another call, which would
    mix them in a diagnosis.
    """
    for key, x in answers.items():
        tree = x.frame.tree if isinstance(x, Vector) else []
        earlier = [f.name for f in tree if f in before]
        if 0 < len(earlier) < len(tree):
            return [
                f"{key} has the frame {earlier[-1]} of an earlier call in its tree: turn frames "
                "from a ground that solve makes, not from one of the module"
            ]
    return []


def _dimensions(p):
    """Faults of solve on dimensions: unlike quantities added, or not the dimension of the unit."""
    try:
        answers = p.code.solve(p.dimensions())
    except DimensionError as error:
        return [f"solve adds unlike quantities: {error_sentence(p.id, error)}"]
    faults = []
    for key, answer in answers.items():
        a = p.answer(key)
        if a.kind.is_word:
            continue
        asked = unit(a.unit).dimension
        for x in flat(answer):
            if x != asked if isinstance(x, Dimension) else x and any(asked.powers):
                faults.append(f"{key} is asked for in {a.unit} ({asked}), but solve gives {x}")
    return faults


def _exchanged(p):
    """Mistakes whose answer has the dimension of another: perhaps stored under the wrong key."""
    try:
        named = p.code.mistakes(p.dimensions())
    except DimensionError:  # a wrong model may add unlike quantities
        return []
    asked = {a.key: unit(a.unit).dimension for a in p.answers if not a.kind.is_word}
    faults = []
    for name, answers in named.items():
        for key, answer in answers.items():
            found = {x for x in flat(answer) if isinstance(x, Dimension)}
            found = found - {asked.get(key)} if len(found) == 1 else ()  # mixed ones are not a swap
            others = [k for k, d in asked.items() if key in asked and d in found]
            gives = f"the mistake {name} gives {key} the dimension of"
            faults += [f"{gives} {k}: is it stored under its key?" for k in others]
    return faults


def _precise(p, given):
    with mp.workdps(DIGITS):
        return p.base({n: mpf(repr(v)) for n, v in given.items()}, mpf(1))


def _agreement(p, seed, proof):
    faults = []
    try:
        given, right, proved, precise = _both_ways(p, values(p, seed), proof)
    except CatalogueError as error:
        return [str(error)]
    for a in p.answers:
        found = right[a.key]
        if a.kind.is_word:
            faults += _word_faults(a, found[0], word(proved[a.key]))
            continue
        ways = {"solve in floats": found, "solve in 50 digits": flat(precise[a.key])}
        with mp.workdps(DIGITS):
            (by_proof,) = a.kind.like((flat(proved[a.key]),), (flat(precise[a.key]),))
        faults += _differences(a.key, ways, by_proof, a.atol)
    faults += (step_faults(p, given) if seed == 0 else []) or _steps_against_proof(p, given, proof)
    faults += _hidden(p, given, p.same_in_book if seed == 0 else ())
    return faults or _following(p, given, right)


def _both_ways(p, given, proof):
    """(values, solve in floats, prove, solve in 50 digits) where all are real."""
    points = symbol_points(p)
    rows = zip(*points.values(), strict=True)
    others = [dict(zip(points, map(float, row), strict=True)) for row in rows]
    for symbols in ({}, *others):
        here = {**given, **symbols}
        right = {k: x for k, (x,) in at_points(p, here)[0].items()}
        if not all(map(_is_real, right.values())):
            continue
        with mp.workdps(DIGITS), suppress(SingularError):  # say the root of a negative number
            proved = {a.key: x for a, x in zip(p.answers, proof(here).values(), strict=False)}
            precise = p.in_units(p.code.solve(_precise(p, here)))
            proved = p.in_units(proved)
            if all(_is_real(flat(x)) for x in (*proved.values(), *precise.values())):
                return here, right, proved, precise
    tried = ", ".join(f"{n} = {x:.6g}" for n, x in given.items()) or "no numbers"
    raise CatalogueError(f"solve and prove are nowhere both real; tried {tried}")


def _differences(key, ways, proved, atol):
    """Faults: numbers of ``ways``, {how: numbers}, that differ from the proof."""
    faults = []
    for how, numbers in ways.items():
        tolerance = AGREEMENT if how.endswith("floats") else AGREEMENT**2
        gap = _gap(numbers, proved)
        if not gap <= tolerance and not _both_zero(numbers, proved, atol, tolerance):
            faults.append(
                f"{key}: {how} and prove differ by {gap:.1e} of its size: {_as_text(numbers)} "
                f"against {_as_text(proved)}"
            )
    return faults


def proved_steps(
    p: Problem, given: Mapping[str, float], proof: _Proof | None = None
) -> dict[str, Any]:
    """{key: value in base units} of the steps that ``prove`` returns, in 50 digits."""
    found, asked = (proof or _Proof(p))(given), {a.key for a in p.answers}
    return {key: x for key, x in found.items() if key not in asked}


def _steps_against_proof(p, given, proof):
    """Faults: steps that differ from the proof, at the numbers ``given``."""
    proved = proved_steps(p, given, proof)
    if not proved:
        return []
    in_floats = {s.key: s for s in steps(p, given)}
    unknown = [key for key in proved if key not in in_floats]
    if unknown:
        return [f"prove returns {unknown[0]}, which is neither asked for nor one of the steps"]
    faults = []
    with mp.workdps(DIGITS):
        precise = {s.key: s for s in steps(p, {n: mpf(repr(x)) for n, x in given.items()}, mpf(1))}
        for key, x in proved.items():
            ways = {
                "the step in floats": flat(in_floats[key].value),
                "the step in 50 digits": flat(precise[key].value),
            }
            by_proof = flat(in_unit(x, in_floats[key].unit, p.system))
            faults += _differences(key, ways, by_proof, 1e-6)
    return faults


def _is_real(numbers):
    """Whether all numbers are real and finite; words count as real."""
    return all(
        not isinstance(x, (float, complex, mpf, mpc)) or (mp.im(x) == 0 and mp.isfinite(x))
        for x in numbers
    )


def _word_faults(answer, solved, proved):
    if answer.kind.has_options and solved not in answer.of:
        return [f"{answer.key}: solve says {solved!r}, which is not one of {', '.join(answer.of)}"]
    if answer.kind.is_word and not answer.kind.readings(solved, answer.form, {}, []):
        return [f"{answer.key}: solve gives {solved!r}, which is not a whole number"]
    if solved != proved:
        return [f"{answer.key}: solve says {solved}, prove says {proved}"]
    return []


def _hidden(p, given, exempt):
    """Faults: mistakes close to the key; for words, only with the numbers of the book."""
    faults = []
    right, wrong = at_points(p, {n: given[n] for n in p.givens})
    book = all(given[n] == x for n, x in p.book_values.items())
    for name, answers in wrong.items():
        for key, points in answers.items():
            a, real = p.answer(key), list(filter(_is_real, points))
            if a.kind.has_options and not {x for (x,) in points} <= set(a.of):
                faults.append(f"the mistake {name} gives {key} a word that is not one of {a.of}")
            elif not real and book:
                faults.append(f"the mistake {name} gives no real {key}")
            elif name in exempt or (a.kind.is_word and not book):
                continue
            elif _is_hidden(a.kind, points, right[key]):
                faults.append(
                    f"the mistake {name} gives nearly the right {key}: {_as_text(points[0])}; if "
                    "it does so only with the numbers of the book, write same_in_book: true"
                )
    return faults


def _is_hidden(kind, points, key):
    return points == key if kind.is_word else not apart(kind.like(points, key), key)


def _following(p, given, right):
    """Faults of ``follows``, which must turn right earlier answers into right later ones."""
    faults, asked = [], [a.key for a in p.answers]
    for key, earlier in earlier_answers(p).items():
        strange = [n for n in (key, *earlier) if n not in asked]
        if strange:
            asks = f"the problem asks for {', '.join(asked)}"
            return [f"follows has {', '.join(strange)}; {asks}{meant(strange[0], asked)}"]
        found = follow(p, key, given, {n: right[n] for n in earlier})
        if p.answer(key).kind.is_word:
            same = tuple(found) == tuple(right[key])
        else:
            same = distance(found, right[key]) <= AGREEMENT
        if not same:
            faults.append(
                f"{key} does not follow from {' and '.join(earlier)}: follows gives "
                f"{_as_text(found)}, solve {_as_text(right[key])}"
            )
    return faults


def _gap(a, b):
    with mp.workdps(DIGITS):
        if len(a) != len(b):
            return float("inf")
        whole = mp.sqrt(sum(mpf(y) ** 2 for y in b))
        square = sum((mpf(x) - y) ** 2 for x, y in zip(a, b, strict=True))
        return float(mp.sqrt(square) / (whole or 1))


def _both_zero(a, b, atol, tolerance):
    """Whether both are zero, to far less than ``atol``."""
    with mp.workdps(DIGITS):
        size = mp.sqrt(sum(mpf(x) ** 2 for x in (*a, *b)))
        return bool(len(a) == len(b) and size <= atol * mp.sqrt(tolerance))


def _as_text(numbers):
    sized = lambda x: f"{max_abs(x) * (1 if x >= 0 else -1):.6g}"
    return f"({', '.join(x if isinstance(x, str) else sized(x) for x in numbers)})"
