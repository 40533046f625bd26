"""Which wrong model gives this wrong answer? Told only if one model alone fits, and it lies far from the key."""

import numpy as np

from exercises.variants import SEPARATION, flat
from newton_euler.vectors import EQUATIONS, Vector

FACTORS = {
    "rad/s against rev/min": 60 / (2 * np.pi), "rad against degrees": 180 / np.pi, "m against mm": 1000.0,
    "ft against in": 12.0, "a factor of 2": 2.0,
    "weight against mass (g = 9.81)": 9.81, "weight against mass (g = 32.2)": 32.2,
}  # fmt: skip


def diagnose(problem, answer, given, key, sample, mistakes, rtol):
    """A sentence for the student, or None. Arrays have the shape (components, points); ``mistakes`` maps names to wrong answers."""
    listed = [(problem.mistakes[name], numbers) for name, numbers in mistakes.items()]
    for candidates in (
        lambda: listed,
        lambda: _ledger(problem, answer, sample),
        lambda: _conversions(problem, answer, sample),
        lambda: _shapes(problem, answer, key, sample),
    ):
        with np.errstate(all="ignore"):
            told = _unique(candidates(), given, key, rtol)
        if told is not None:
            return told or None
    return None


def _unique(candidates, given, key, rtol):
    """The one text whose numbers fit; "" if several different ones do, None if none does."""
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
        if exists.any() and far[exists].mean() >= 0.5 and (gap <= np.maximum(rtol * own, 1e-9 * size))[exists].all():
            fits.append((text, numbers))
    texts = list(dict.fromkeys(text for text, _ in fits))
    return None if not texts else texts[0] if len(texts) == 1 else ""


def _right(problem, answer, sample, **changes):
    g = problem.base(sample)
    return problem.in_units({answer.key: problem.code.solve(g.but(**changes))[answer.key]})[answer.key]


def _numbers(value, sample):
    points = max((np.size(v) for v in sample.values()), default=1)
    return np.stack([np.broadcast_to(np.asarray(x, dtype=float), (points,)) for x in flat(value)])


def _ledger(problem, answer, sample):
    """What the named terms of the key say: each left out, or with its sign turned, or the Coriolis term once instead of twice."""
    right = _right(problem, answer, sample)
    if not isinstance(right, Vector) or not right.terms:
        return
    for name in right.terms:
        term = _in_words(name, right._ledger.kind)
        yield f"leaves out {term}", _numbers(right.reweighted(**{name: 0}), sample)
        yield f"has {term} with the opposite sign", _numbers(right.reweighted(**{name: -1}), sample)
    halved = {name: 0.5 for name in right.terms if name.startswith("coriolis")}  # spherical components have three of them
    if halved:
        yield "writes the Coriolis term without the factor 2", _numbers(right.reweighted(**halved), sample)


def _in_words(name, kind):
    """A term for the student: with its formula where it has one; the turns of frames by their frames."""
    written = EQUATIONS[kind][2]
    if name in written:
        return f"the {name} term {written[name][0]}"
    turning = kind.startswith("angular") and " x " not in name
    return f"the turning of {name}" if turning else f"the term {name}"


def _conversions(problem, answer, sample):
    """A given used as it stands in the text, without conversion to radians or seconds."""
    g = problem.base(sample)
    for name, quantity in problem.givens.items():
        if any(unit in quantity.unit for unit in ("deg", "rev", "rpm")):
            wrong = _right(problem, answer, sample, **{name: g.stated(name)})
            yield f"uses {name} in {quantity.unit} as if it were in radians (and seconds)", _numbers(wrong, sample)


def _shapes(problem, answer, key, sample):
    """The right vector with its components in another frame, or turned the wrong way; opposite; or off by a factor of units."""
    yield "has every sign turned: look at the sense", -key
    for name, factor in FACTORS.items():
        yield f"is {factor:.4g} times too large ({name})", factor * key
        yield f"is {factor:.4g} times too small ({name})", key / factor
    right = _right(problem, answer, sample)
    if not isinstance(right, Vector):
        return
    seen = [_numbers(right, sample)]
    for frame in right.frame.tree:
        numbers = _numbers(right.components(frame), sample)
        if any(np.abs(numbers - other).max() <= 1e-9 * np.abs(numbers).max() for other in seen):
            continue  # its axes lie along those of a frame that was tried
        seen.append(numbers)
        yield f"has the right vector, but its components along the axes of the {frame.name}, not those asked for", numbers
        turned = Vector(right.c, frame).components(right.frame)
        wrong_way = f"turns the components the wrong way between the {frame.name} and the axes asked for (a transposed matrix)"
        yield wrong_way, _numbers(turned, sample)
