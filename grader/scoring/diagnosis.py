"""Finds the mistake that explains a wrong answer. A mistake is reported only if it alone fits the
answer and differs clearly from the key.
"""

import numpy as np

from exercises.variants import SEPARATION, flat
from newton_euler.algebra.vectors import Vector

FACTORS = {
    "rad/s against rev/min": 60 / (2 * np.pi), "rad against degrees": 180 / np.pi,
    "m against mm": 1000.0, "ft against in": 12.0, "a factor of 2": 2.0,
    "weight against mass (g = 9.81)": 9.81, "weight against mass (g = 32.2)": 32.2,
}  # fmt: skip


def diagnose(problem, answer, given, key, sample, mistakes, rtol):
    """The mistake that gives the wrong answer ``given``, as a sentence for the student, or None.

    Arrays have the shape (components, points); ``mistakes`` maps the names of the problem's listed
    mistakes to the answers that they give.
    """
    listed = [(problem.mistakes[name], numbers) for name, numbers in mistakes.items()]
    for candidates in (
        lambda: listed,
        lambda: _term_mistakes(problem, answer, sample),
        lambda: _unit_mistakes(problem, answer, sample),
        lambda: _whole_answer_mistakes(problem, answer, key, sample),
    ):
        with np.errstate(all="ignore"):
            found = _only_fit(candidates(), given, key, rtol)
        if found is not None:
            return found or None
    return None


def _only_fit(candidates, given, key, rtol):
    """The only text whose numbers fit; "" if several texts fit, None if none does."""
    size = np.sqrt((key**2).sum(axis=0))
    fits = []
    for text, numbers in candidates:
        numbers = np.asarray(numbers)
        if numbers.shape != given.shape:
            continue
        own = np.sqrt((numbers**2).sum(axis=0))
        far = np.sqrt(((numbers - key) ** 2).sum(axis=0)) >= SEPARATION * np.maximum(size, own)
        gap = np.sqrt(((numbers - given) ** 2).sum(axis=0))
        exists = np.isfinite(own) & np.isfinite(size)
        if (
            exists.any()
            and far[exists].mean() >= 0.5
            and (gap <= np.maximum(rtol * own, 1e-9 * size))[exists].all()
        ):
            fits.append((text, numbers))
    texts = list(dict.fromkeys(text for text, _ in fits))
    return None if not texts else texts[0] if len(texts) == 1 else ""


def _key_with(problem, answer, sample, **changes):
    g = problem.base(sample)
    return problem.in_units({answer.key: problem.code.solve(g.but(**changes))[answer.key]})[
        answer.key
    ]


def _numbers(value, sample):
    points = max((np.size(v) for v in sample.values()), default=1)
    return np.stack([np.broadcast_to(np.asarray(x, dtype=float), (points,)) for x in flat(value)])


def _term_mistakes(problem, answer, sample):
    """Mistakes in the named terms of the key: a term left out, a term with the opposite sign, the
    Coriolis term without its factor 2.
    """
    right = _key_with(problem, answer, sample)
    if not isinstance(right, Vector) or not right.terms:
        return
    for name in right.terms:
        term = term_text(name, right.equation)
        yield f"leaves out {term}", _numbers(right.reweighted(**{name: 0}), sample)
        yield f"has {term} with the opposite sign", _numbers(right.reweighted(**{name: -1}), sample)
    # spherical components have three of them
    halved = {name: 0.5 for name in right.terms if name.startswith("coriolis")}
    if halved:
        yield (
            "writes the Coriolis term without the factor 2",
            _numbers(right.reweighted(**halved), sample),
        )


def term_text(name, equation):
    """The name of a term for the student, with its formula if it has one."""
    if name in equation.terms:
        return f"the {name} term {equation.terms[name][0]}"
    turning = equation.kind.startswith("angular") and " x " not in name
    return f"the turning of {name}" if turning else f"the term {name}"


def _unit_mistakes(problem, answer, sample):
    """Mistakes in units: a given used with its number in degrees or revolutions, without conversion
    to radians or seconds.
    """
    g = problem.base(sample)
    for name, quantity in problem.givens.items():
        if any(unit in quantity.unit for unit in ("deg", "rev", "rpm")):
            wrong = _key_with(problem, answer, sample, **{name: g.stated(name)})
            yield (
                f"uses {name} in {quantity.unit} as if it were in radians (and seconds)",
                _numbers(wrong, sample),
            )


def _whole_answer_mistakes(problem, answer, key, sample):
    """Mistakes in the answer as a whole: its sign, a factor of units, components in another frame,
    a transposed rotation matrix.
    """
    yield "has the opposite sign in every component: check the direction", -key
    for name, factor in FACTORS.items():
        yield f"is {factor:.4g} times too large ({name})", factor * key
        yield f"is {factor:.4g} times too small ({name})", key / factor
    right = _key_with(problem, answer, sample)
    if not isinstance(right, Vector):
        return
    seen = [_numbers(right, sample)]
    for frame in right.frame.tree:
        numbers = _numbers(right.components(frame), sample)
        if any(np.abs(numbers - other).max() <= 1e-9 * np.abs(numbers).max() for other in seen):
            continue  # its axes are parallel to those of a frame already tried
        seen.append(numbers)
        yield (
            (
                f"has the right vector, but its components along the axes of the {frame.name}, not "
                "those asked for"
            ),
            numbers,
        )
        turned = Vector(right.c, frame).components(right.frame)
        wrong_way = (
            f"turns the components the wrong way between the {frame.name} and the axes asked "
            "for (a transposed matrix)"
        )
        yield wrong_way, _numbers(turned, sample)
