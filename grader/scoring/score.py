"""Computes the points of a receipt: pure functions over data.

``score_receipt(problem, values, receipt)`` compares numbers with the key that the engine computes
for the same values, and formulas at seeded points of their domain. Nothing that a student wrote is
run, evaluated as code or simplified here.
"""

import json
import random
from dataclasses import asdict, dataclass
from functools import cache

import numpy as np

from exercises.variants import evaluate, symbol_values
from newton_euler.algebra.scalars import ScalarError
from newton_euler.algebra.units import DimensionError
from newton_euler.classroom.forms import SHAPES, Form
from newton_euler.classroom.formula_trees import TreeError
from newton_euler.classroom.formula_trees import evaluate as tree_value

from .diagnosis import diagnose

RTOL = 0.005  # of the size of the key: accepts three significant figures, rounded up or down
FORMULA_RTOL = 1e-4  # formulas are exact; this accepts 3.1416 for pi
POINTS = 8  # number of points at which formulas are compared
NO_ANSWER = "no answer"


@dataclass(frozen=True)
class Part:
    """The score of one answer: ``verdict`` is right, wrong, unreadable or blank; ``message`` is for
    the student and never contains the key.
    """

    key: str
    points: float
    out_of: float
    verdict: str
    message: str
    diagnosis: str | None = None


@dataclass(frozen=True)
class Score:
    """The score of one problem: its parts, and a note on the cell as a whole (an error in it, a
    copy of it, a missing cell).
    """

    problem: str
    parts: tuple
    note: str = ""

    @property
    def points(self):
        """The sum of the points of the parts."""
        return sum(p.points for p in self.parts)

    @property
    def out_of(self):
        """The maximum: one point for each answer."""
        return sum(p.out_of for p in self.parts)

    def json(self):
        """The score as JSON text."""
        return json.dumps({"points": self.points, "out_of": self.out_of, **asdict(self)})


def score_receipt(problem, values, receipt, note=""):
    """The :class:`Score` of a receipt ({"answers", "faults", "error"}, or None) for ``problem``
    with a student's ``values``.

    A receipt comes from a student's process: anything that JSON can hold is accepted, and what
    cannot be read gets no points.
    """
    receipt = receipt if isinstance(receipt, dict) else {}
    answers = receipt.get("answers") if isinstance(receipt.get("answers"), dict) else {}
    faults = receipt.get("faults") if isinstance(receipt.get("faults"), dict) else {}
    error = receipt.get("error")
    notes = [n for n in (note, f"the cell stopped with {_clipped(error)}" if error else "") if n]
    if problem.givens:
        sample = _sample(problem, values)
        right, wrong = _key(problem, sample)
    else:
        sample, (right, wrong) = _symbolic_key(problem)
    parts = []
    for a in problem.answers:
        tree = answers.get(a.key)
        if a.key in faults:
            parts.append(Part(a.key, 0, 1, "unreadable", _clipped(faults[a.key])))
        elif tree is None:
            parts.append(Part(a.key, 0, 1, "blank", NO_ANSWER))
        else:
            parts.append(_score_part(problem, a, tree, sample, right[a.key], wrong))
    return Score(problem.id, tuple(parts), "; ".join(notes))


def _sample(problem, values):
    """Values of all givens and symbols; symbols as arrays of seeded points, the same for all
    students.
    """
    if not problem.symbols:
        return dict(values)
    rng = random.Random(f"points of {problem.id}")
    points = [symbol_values(problem, rng) for _ in range(POINTS)]
    return {**values, **{n: np.array([p[n] for p in points]) for n in problem.symbols}}


@cache
def _symbolic_key(problem):
    """Sample and key of a problem without givens, which are the same for all students; the result
    must not be modified.
    """
    sample = _sample(problem, {})
    return sample, _key(problem, sample)


def _key(problem, sample):
    with np.errstate(all="ignore"):
        return evaluate(problem, sample)


def _score_part(problem, a, tree, sample, key, wrong):
    if a.kind in ("choice", "count"):
        ok = type(tree) is type(key[0]) and tree == key[0]
        return Part(a.key, float(ok), 1, "right" if ok else "wrong", "right" if ok else "not right")
    try:
        given = read(a, tree, sample)
    except (
        TreeError,
        ScalarError,
        DimensionError,
        ArithmeticError,
        ValueError,
        TypeError,
        RecursionError,
        MemoryError,
    ) as error:
        return Part(a.key, 0, 1, "unreadable", f"cannot be read: {_clipped(error)}")
    key = _rows(key, given.shape[1])
    tolerance = FORMULA_RTOL if a.kind.endswith("expression") else RTOL
    if _right(a, given, key, tolerance):
        return Part(a.key, 1, 1, "right", "right")
    diagnosis = diagnose(
        problem,
        a,
        given,
        key,
        sample,
        {m: _rows(w[a.key], given.shape[1]) for m, w in wrong.items() if a.key in w},
        tolerance,
    )
    return Part(
        a.key,
        0,
        1,
        "wrong",
        f"not right; it fits a solution that {diagnosis}" if diagnosis else "not right",
        diagnosis,
    )


def _right(a, given, key, tolerance):
    # each bound separately: relative to a wide interval, an error of its lower bound would be small
    if a.kind == "interval":
        return all(close(given[[n]], key[[n]], tolerance, a.atol) for n in range(2))
    return close(given, key, tolerance, a.atol)


def read(a, tree, sample):
    """A student's answer (a number, a formula tree, or a list of them) as an array of shape
    (components, points); otherwise :class:`TreeError`.
    """
    count = SHAPES[a.kind]
    trees = tree if count > 1 else [tree]
    if not isinstance(trees, list) or len(trees) != count:
        raise TreeError(f"expected {Form(a.kind, a.unit, a.of).words}")
    if a.kind.endswith("expression"):
        symbols = {n: v for n, v in sample.items() if np.ndim(v)}
        with np.errstate(all="ignore"):
            rows = [tree_value(t, symbols) for t in trees]
    else:
        if not all(isinstance(t, (int, float)) and not isinstance(t, bool) for t in trees):
            raise TreeError(f"expected {Form(a.kind, a.unit, a.of).words}")
        rows = [float(t) for t in trees]
    return _rows(rows, max(np.size(v) for v in sample.values()) if sample else 1)


def _rows(numbers, points):
    with np.errstate(all="ignore"):
        return np.stack([np.broadcast_to(_real(x), (points,)) for x in numbers])


def _real(x):
    x = np.asarray(x)
    if x.dtype.kind == "c":  # NumPy would drop the imaginary part with a warning
        if not (np.abs(x.imag) <= 1e-9 * np.abs(x)).all():
            raise TreeError("it gives complex numbers: a root of a negative number")
        x = x.real
    return x.astype(float)


def close(given, key, rtol, atol):
    """True if at every point where the key is finite the answer is within ``rtol`` of the size of
    the key, or ``atol`` where the key is zero.
    """
    with np.errstate(all="ignore"):
        size = np.sqrt((key**2).sum(axis=0))
        gap = np.sqrt(((given - key) ** 2).sum(axis=0))
        within = gap <= np.maximum(rtol * size, atol if (size <= atol).any() else 0)
    exists = np.isfinite(size)
    return bool(exists.any() and within[exists].all())


def _clipped(text):
    """Any value as one printable line: students control the text of error messages, which are
    written to files, tables and pages.
    """
    line = " ".join(str(text).split())[:400]
    return "".join(c if c.isprintable() else "\ufffd" for c in line)
