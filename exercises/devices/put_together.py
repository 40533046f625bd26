"""Centres of composite bodies, with parts cut out; proofs by slices and wires."""

from collections.abc import Callable, Iterable, Sequence
from typing import Any

from exercises.annotations import Answers, Givens, Number, Path, Scalar, Solve, Steps, StepsOf
from exercises.tools import Step, mp, proofs
from newton_euler import Body, Frame, Point, centre_of_mass

SYMBOLS = {"length": "l", "area": "A", "volume": "V", "mass": "m"}
POWERS = {"length": 1, "area": 2, "volume": 3}


def centre(frame: Frame, parts: Iterable[Body], removed: Iterable[Body] = ()) -> Answers:
    """The answer: the centre of mass of bodies."""
    return {"d": centre_of_mass([*parts, *(-hole for hole in removed)], frame).position(frame)}


def problem_of(
    frame: Frame,
    parts: Callable[[Givens], Sequence[Body] | tuple[Sequence[Body], Sequence[Body]]],
    holes: bool = False,
    **units: Any,
) -> tuple[Solve, StepsOf]:
    """``solve`` and ``steps`` for ``parts(g)``; with ``holes``, a pair of parts and holes."""
    bodies = lambda g: parts(g) if holes else (parts(g),)
    return (lambda g: centre(frame, *bodies(g)), lambda g: steps_of(frame, *bodies(g), **units))


def on_axis(
    frame: Frame, axis: str, content: str, moments: Callable[[Givens], tuple[Scalar, Scalar]]
) -> tuple[Callable[[Scalar, Scalar], Answers], Solve, Solve]:
    """The answer, ``solve`` and ``steps`` for a centre on this axis; ``moments(g)``: the content,
    an integral, and its first moment.
    """

    def answer(whole, first):
        return {"d": frame.vector(*(first / whole if e == axis else 0 for e in "xyz"))}

    steps = lambda g: dict(zip((content, f"Q_{axis}"), moments(g), strict=True))
    return answer, lambda g: answer(*moments(g)), steps


def unweighed(frame: Frame, one: Scalar, points: Iterable[Point]) -> Answers:
    """The mistake of an unweighted mean of points; ``one`` is g.one."""
    return {"d": centre_of_mass([(one, P) for P in points], frame).position(frame)}


def steps_of(
    frame: Frame,
    parts: Sequence[Body],
    removed: Sequence[Body] = (),
    *,
    content: str,
    length: str,
    mass: str = "",
    given: Sequence[str] = (),
) -> Steps:
    """The content (one of SYMBOLS, unless ``given``) and centre of each part, with the first word
    of its name as index, then the sums. ``length`` and ``mass`` are units.
    """
    symbol, (unit, _) = SYMBOLS[content], units(content, length, mass)
    for part in (*parts, *removed):
        key, cut_out = part.name.split()[0], ", to be subtracted" if part in removed else ""
        if key not in given:
            yield Step(f"{symbol}_{key}", part.mass, unit, f"{content} of the {part.name}{cut_out}",
                       "5.4")  # fmt: skip
        yield Step(f"d_{key}", part.centre.position(frame), length,
                   f"centre of mass of the {part.name}", "5.4", "5.13")  # fmt: skip
    yield from sums(frame, parts, removed, content=content, length=length, mass=mass)


def units(content: str, length: str, mass: str) -> tuple[str, str]:
    """The units of the content and of its first moment."""
    if content == "mass":
        return mass, f"{mass}*{length}"
    n = POWERS[content]
    return f"{length}^{n}".removesuffix("^1"), f"{length}^{n + 1}"


def sums(
    frame: Frame,
    parts: Iterable[Body],
    removed: Iterable[Body] = (),
    *,
    content: str,
    length: str,
    mass: str = "",
    equal_parts: bool = False,
) -> Steps:
    """The content of the whole and its first moment, as steps."""
    unit, unit_of_moment = units(content, length, mass)
    first, *others = (*parts, *(-hole for hole in removed))
    whole = first.mass + sum(part.mass for part in others)
    yield Step(SYMBOLS[content], whole, unit, f"{content} of the whole", "5.4")
    Q = first.mass * first.centre.position(frame)
    for part in others:
        Q = Q + part.mass * part.centre.position(frame)
    means = f"sum of {content} times place of the centre"
    means += f": the {content} of one times the sum of all places" * equal_parts
    yield Step("Q", Q, unit_of_moment, means, "5.4", "5.11", of_givens=equal_parts)


def proved(content: str, whole: Number, first: Iterable[Number]) -> Answers:
    """The result of a proof, from the total content and its first moment."""
    return {"d": [m / whole for m in first], SYMBOLS[content]: whole, "Q": list(first)}


def sliced(
    content: str,
    slice_at: Callable[[Number], Sequence[Number]],
    start: Number,
    end: Number,
    breaks: Sequence[Number],
) -> Answers:
    """Proof by slices at x: ``slice_at(x)`` is the content per dx and its first moments in y, z."""

    def moments(x):
        per_dx, first_y, first_z = slice_at(x)
        return [per_dx, x * per_dx, first_y, first_z]

    whole, *first = proofs.integral(moments, start, end, breaks)
    return proved(content, whole, first)


def chord(distance: Number, radius: Number) -> Number:
    """Proof: length of the chord of a circle at this distance from its centre; 0 outside."""
    return 2 * mp.sqrt(max(radius**2 - distance**2, 0))


def walked(path: Path, length: Number, breaks: Sequence[Number]) -> Answers:
    """Proof for a wire: the mean of ``path(s)`` over arc length s, with corners at ``breaks``."""
    return proved("length", length, proofs.integral(path, 0, length, breaks))
