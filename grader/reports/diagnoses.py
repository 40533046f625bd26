"""How often the grader recognises the mistakes that the exercises list."""

import math
import random
from collections import Counter
from collections.abc import Callable, Iterable, Mapping

from rich.table import Table

from exercises.catalogue import Problem
from exercises.catalogue.variants import draw
from newton_euler.answers.fit import EXACT, Fit
from newton_euler.answers.receipts import record
from newton_euler.answers.slips import multiples
from newton_euler.answers.tolerance import is_apart
from newton_euler.answers.verdicts import Judged, explain

from ..scoring import score_receipt
from ..scoring.numbers import numbers_of, points_of
from .slips_made import made
from .tables import plain_table

OUTCOMES = ("named", "misnamed", "unnamed", "passed")


def diagnosis_shares(
    problems: Iterable[Problem], draws: int, progress: Callable[[], object] | None = None
) -> dict[str, Counter[str]]:
    """{problem id: Counter of :data:`OUTCOMES`} over the book's numbers and ``draws`` - 1 drawn
    sets: each listed mistake is made, written as a student would, and scored.

    named: recognised, if need be among others that give the same answer; misnamed: taken for
    another mistake; unnamed: wrong without an explanation; passed: taken for right.
    """
    found: dict[str, Counter[str]] = {}
    for p in problems:
        found[p.id] = Counter()
        for n in range(draws if p.givens else 1):
            values = p.book_values if n == 0 else draw(p, f"diagnose {n}".encode())
            found[p.id].update(_outcomes(p, values))
        if progress:
            progress()
    return found


def _outcomes(p, values):
    right = p.solve({**p.sympy_symbols(), **values})
    for name, answers in p.wrong({**p.sympy_symbols(), **values}).items():
        if name in p.same_in_book and values == p.book_values:
            continue
        # a mistake in a word may give the right one
        made = {k: x for k, x in answers.items() if not p.answer(k).kind.is_word or x != right[k]}
        for key, tree in _trees(p, made).items():
            part = next(
                x for x in score_receipt(p, values, {"answers": {key: tree}}).parts if x.key == key
            )
            yield _outcome(part, name)


def _trees(p, answers):
    """Answers as a student's receipt holds them."""
    forms = {a.key: a.form for a in p.answers if a.key in answers}
    read, faults = record(forms, {n: s.unit for n, s in p.symbols.items()}, answers)
    if faults:
        raise ValueError(f"a listed mistake of {p.id} cannot be handed in: {faults}")
    return read


def _outcome(part, mistake):
    if part.verdict == "right":
        return "passed"
    named = any((c.group, c.name) == ("listed", mistake) for c in part.causes)
    return "named" if named else "misnamed" if part.causes else "unnamed"


def shares_table(found: Mapping[str, Counter[str]], title: str = "Listed mistakes") -> Table:
    """The shares as a table for the terminal, with their sum."""
    table = plain_table(title, "problem", ">made", *(f">{name} %" for name in OUTCOMES))
    for problem_id, counts in found.items():
        table.add_row(problem_id, *_row(counts))
    table.add_section()
    table.add_row("all", *_row(sum(found.values(), Counter())))
    return table


def _row(counts):
    made = sum(counts.values())
    return str(made), *(f"{100 * counts[o] / made:.1f}" if made else "–" for o in OUTCOMES)


# -- slips that nobody listed

DIGITS = (4, 6, 17)  # in which an answer may be written
RANDOM = "random numbers"


def slip_shares(
    problems: Iterable[Problem], draws: int, progress: Callable[[], object] | None = None
) -> dict[str, Counter[str]]:
    """{kind of slip: Counter} over drawn numbers: of the wrong answers of :func:`.slips_made.made`
    how many are named with a cause that gives the same numbers, how many are followed, silent, or
    misnamed.
    """
    found: dict[str, Counter[str]] = {}
    for p in problems:
        for n in range(draws):
            rng = random.Random(f"slips in {p.id} {n}")
            for kind, outcome in _of_slips(p, draw(p, rng.randbytes(8)), rng):
                found.setdefault(kind, Counter())[outcome] += 1
        if progress:
            progress()
    return dict(sorted(found.items()))


def _of_slips(p, values, rng):
    numbers = numbers_of(p, values)
    for slip in made(p, values, rng):
        exact = {k: points_of(p.answer(k), x) for k, x in slip.answers.items()}
        digits = rng.choice(DIGITS)
        judged = {k: _judged(p.answer(k), _written(x, digits), numbers) for k, x in exact.items()}
        for key in slip.wrong:
            finite = all(map(math.isfinite, exact[key][0]))
            if finite and judged[key].verdict == "wrong" and is_apart(exact[key], numbers.key[key]):
                yield slip.kind, _named(p.answer(key), judged, numbers, exact[key])
    for a in p.answers:
        for _ in range(5 if a.kind.length > 0 and not a.kind.is_word else 0):
            given = _written(_random(numbers.key[a.key], rng), rng.choice(DIGITS))
            judged = {a.key: _judged(a, given, numbers)}
            if judged[a.key].verdict == "wrong":
                yield RANDOM, _named(a, judged, numbers, None)


def _written(points, digits):
    return (
        tuple(tuple(float(f"{float(x):.{digits}g}") for x in point) for point in points)
        if (len(points) == 1)
        else points
    )


def _random(points, rng):
    size = math.hypot(*points[0]) or 1.0
    return tuple(
        tuple(
            size * rng.choice((-1, 1)) * 3 ** rng.uniform(-1, 1) / len(point) ** 0.5 for _ in point
        )
        for point in points
    )


def _judged(asked, given, numbers):
    right = asked.kind.is_right(given, numbers.key[asked.key], asked.atol)
    return Judged("right" if right else "wrong", "", given)


def _named(asked, judged, numbers, exact):
    why = explain(asked, judged, numbers)
    if why.earlier:
        return "followed"
    causes = [c for c in why.causes if not c.is_observation]
    if not causes:
        return "silent"
    return "named" if exact is None or _gives(causes, exact, asked, numbers) else "misnamed"


def _gives(causes, exact, asked, numbers):
    """True if one of these causes gives these numbers, to all digits."""
    key, kind = numbers.key[asked.key], asked.kind
    fit = Fit(exact, kind.like(key, exact), kind.rtol)
    models = [
        *numbers.wrong(asked.key),
        *multiples(fit, kind.factors(asked.unit)),
        *kind.slips(fit),
    ]
    models += [(c, x) for c in causes for x in numbers.slips.of(asked.key, c)]
    models += [(c, numbers.book[asked.key]) for c in causes if c.group == "book"]
    models += [(c, numbers.key[c.name]) for c in causes if c.group == "exchanged"]
    return any(fit(kind.like(x, exact)) == EXACT for cause, x in models if cause in causes)
