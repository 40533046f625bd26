"""Whether an answer is possible at all, judged without the key: a size that the givens allow, an
inertia matrix that a body can have, a kinetic energy that is not negative.
"""

import math
import random
from collections.abc import Mapping
from typing import Any

from ..algebra.language import Words, _
from ..algebra.units import UnitError, unit
from .forms import Form
from .tolerance import ROOM, RTOL
from .trees import TreeError, evaluate

KINETIC, MAGNITUDE = QUANTITIES = "kinetic energy", "magnitude"  # which are never negative
POINTS = 8  # places at which formulas are tried
ACROSS = ((1, 3), (2, 6), (5, 7))  # places of the entries of a matrix that mirror each other


def doubts(
    form: Form,
    tree: Any,
    symbols: Mapping[str, str],
    sane: Any,
    beside: Mapping[str, tuple[Form, Any]] | None = None,
) -> list[str]:
    """Sentences on why an answer, the ``tree`` as it was read, is impossible; [] if it is not.

    symbols : {name: unit} of formulas
    sane : None, or a condition that holds for all numbers the problem may give: ``(low, high)``,
        between which its size is, :data:`KINETIC`, :data:`MAGNITUDE`, "magnitude of v", or ``(low,
        high, "magnitude of v")``
    beside : {name: (form, tree)} of the other answers
    """
    if not (points := _points(form, tree, symbols)):
        return []
    known = sane if isinstance(sane, tuple | list) else (sane,)
    word = next((x for x in known if isinstance(x, str)), "")
    bounds = [x for x in known if isinstance(x, int | float)]
    found: list[str] = []
    if bounds and form.kind.has_size:
        found += _size(points[0], form, *bounds)
    if word == KINETIC and any(x < 0 for (x,) in points):
        found.append(_("a kinetic energy is never negative"))
    if word.startswith(MAGNITUDE) and form.kind.length == 1:
        if any(x < 0 for (x,) in points):
            found.append(_("a magnitude is never negative"))
        name = word.removeprefix(MAGNITUDE).removeprefix(" of ")
        found += _magnitude(points, form, name, (beside or {}).get(name), symbols)
    if form.kind.shape == (3, 3) and _is_inertia(form.unit):
        found += _inertia(points, whole=not form.kind.is_formula)
    return found


def _points(form, tree, symbols):
    """The components at some points of the symbols; [] for a word, and without a value."""
    if form.kind.is_word or tree is None:
        return []
    trees = form.kind.parts(next(iter(tree.values())) if isinstance(tree, dict) else tree)
    rng = random.Random(1)
    at = [{n: rng.uniform(0.3, 1.5) for n in symbols} for _ in range(POINTS)]
    try:
        if not form.kind.is_formula:
            return [[float(x) for x in trees]]
        return [[float(evaluate(t, values)) for t in trees] for values in at]
    except (TreeError, ArithmeticError, ValueError, TypeError):
        return []


def _magnitude(points, form, name, other, symbols):
    """Why a magnitude is not that of the vector beside it, if so."""
    vectors = _points(*other, symbols) if other else []
    for (x,), vector in zip(points, vectors, strict=False):
        if abs(x - (size := math.hypot(*vector))) > 2 * RTOL * max(abs(x), size):
            text = Words("it is not the magnitude of {name}, which is {size} {unit}")
            if form.kind.is_formula:
                text = Words("it is not the magnitude of {name}")
            yield _(text, name=name, size=f"{size:.4g}", unit=form.unit)
            return


def _size(parts, form, low, high):
    size = math.hypot(*parts)
    if size and not low * (1 - ROOM) <= size <= high * (1 + ROOM):
        text = Words(
            "it is {size}, but with any numbers it is between {low} and {high}: check the units"
        )
        if len(parts) > 1:
            text = Words(
                "its size is {size}, but with any numbers it is between {low} and {high}: check "
                "the units"
            )
        shown = f"{size:.3g} {form.unit}".removesuffix(" 1")
        yield _(text, size=shown, low=f"{low:g}", high=f"{high:g}")


def _is_inertia(text):
    try:
        return unit(text).dimension == unit("kg*m^2").dimension
    except UnitError:
        return False


def _inertia(points, whole):
    """Why no body can have this matrix; of formulas only the symmetry, valid for all symbols."""
    rooms = [ROOM * max(map(abs, point)) for point in points]
    pairs = [(x[n], x[m], e) for x, e in zip(points, rooms, strict=True) for n, m in ACROSS]
    if any(abs(a - b) > room for a, b, room in pairs):
        yield _("an inertia matrix is symmetric")
        return
    if not whole:
        return
    point, spread = points[0], sum(points[0][::4]) * (1 + ROOM) / (2 + ROOM)
    if not _is_positive(point, rooms[0], 1):
        yield _("the moment of inertia about some axis would be negative: check the signs")
    elif not _is_positive(point, spread, -1):
        yield _(
            "no body has these moments of inertia: the largest principal one is at most"
            " the sum of the others"
        )


def _is_positive(point, d, sign):
    """True if no eigenvalue of d 1 + sign I is negative: none of its principal minors is."""
    xx, _, _, xy, yy, _, xz, yz, zz = (
        sign * x + d * (n % 4 == 0) for n, x in enumerate(point)
    )  # fmt: skip
    pairs = xx * yy - xy * xy, yy * zz - yz * yz, zz * xx - xz * xz
    whole = xx * pairs[1] - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz)
    return min(xx, yy, zz, *pairs, whole) >= 0
