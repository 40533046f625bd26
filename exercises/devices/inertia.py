"""Inertia matrices of composite bodies, with parts cut out, or by integration."""

from collections.abc import Callable, Collection, Iterable, Sequence

from exercises.annotations import Answers, Givens, Scalar, Solve, Steps, StepsOf
from exercises.tools import Step
from newton_euler import Frame
from newton_euler.answers.kinds import KINDS
from newton_euler.bodies import Body, Inertia


def matrix(
    frame: Frame, moments: Sequence[Scalar], products: Sequence[Scalar] = (0, 0, 0)
) -> Answers:
    """The answer from (I_xx, I_yy, I_zz) and (I_xy, I_yz, I_zx), right or wrong ones."""
    return {"I_O": Inertia(frame, moments, products, tolerance=None).matrix}


def together(frame: Frame, parts: Iterable[Body], removed: Iterable[Body] = ()) -> Inertia:
    """The :class:`Inertia` of all parts at the origin of ``frame``."""
    first, *others = (part.about(frame) for part in (*parts, *(-hole for hole in removed)))
    return sum(others, first)


def answer(I: Inertia) -> Answers:
    """The answer from an :class:`Inertia`."""
    return {"I_O": I.matrix}


def whole(frame: Frame, parts: Iterable[Body], removed: Iterable[Body] = ()) -> Answers:
    """The answer from bodies."""
    return answer(together(frame, parts, removed))


def problem_of(
    frame: Frame,
    parts: Callable[[Givens], Sequence[Body] | tuple[Sequence[Body], Sequence[Body]]],
    *units: str,
    holes: bool = False,
    at_O: Collection[str] = (),
    given: Collection[str] = (),
) -> tuple[Solve, StepsOf]:
    """``solve`` and ``steps`` for ``parts(g)``; with ``holes``, a pair of parts and holes."""
    bodies = lambda g: parts(g) if holes else (parts(g), ())
    steps = lambda g: steps_of(frame, *bodies(g), *units, at_O=at_O, given=given)
    return (lambda g: whole(frame, *bodies(g))), steps


def untransferred(frame: Frame, part: Body) -> Body:
    """The part moved to O, for the mistake of a missing parallel axis term."""
    return Body(part.name, part.mass, frame.origin, part.inertia.moments, frame)


def named(products: Iterable[Scalar]) -> Answers:
    """The three products of inertia as answers."""
    return dict(zip(("I_xy", "I_yz", "I_zx"), products, strict=True))


def wrong_sign(frame: Frame, I: Inertia) -> Answers:
    """The mistake of products of inertia with a plus sign in the matrix."""
    return matrix(frame, I.moments, [-x for x in I.products])


def no_products(frame: Frame, I: Inertia) -> Answers:
    """The mistake of omitted products of inertia."""
    return matrix(frame, I.moments)


def steps_of(
    frame: Frame,
    parts: Sequence[Body],
    removed: Sequence[Body],
    *units: str,
    at_O: Collection[str],
    given: Collection[str],
) -> Steps:
    """Mass (unless ``given``), own matrix, place, matrix at O of parts; ``at_O``: those there."""
    mass, length, inertia = units
    for part in (*parts, *removed):
        key, cut_out = part.name.split()[0], ", to be subtracted" if part in removed else ""
        if key not in given:
            yield Step(f"m_{key}", part.mass, mass, f"mass of the {part.name}{cut_out}", "7.10")
        own = part.about(part.centre, frame).matrix
        if part.name in at_O:
            means = f"inertia matrix of the {part.name} at O, its centre of mass"
            yield Step(f"I_{key}", own, inertia, means, "7.10", kind=KINDS["matrix"])
            continue
        means = f"inertia matrix of the {part.name} about its own centre of mass"
        yield Step(f"I_G_{key}", own, inertia, means, "7.10", kind=KINDS["matrix"])
        means, d = f"centre of mass of the {part.name}, from O", part.centre.position(frame)
        yield Step(f"d_{key}", d, length, means, "7.8")
        means, I = f"inertia matrix of the {part.name} at O", part.about(frame).matrix
        yield Step(f"I_{key}", I, inertia, means, "7.8", "7.25", kind=KINDS["matrix"])
