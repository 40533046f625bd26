"""Inertia matrices of composite bodies, with parts cut out, or by integration."""

from exercises.tools import Step
from newton_euler.bodies import Body, Inertia


def matrix(frame, moments, products=(0, 0, 0)):
    """The answer from (I_xx, I_yy, I_zz) and (I_xy, I_yz, I_zx), right or wrong ones."""
    return {"I_O": Inertia(frame, moments, products, tolerance=None).matrix}


def together(frame, parts, removed=()):
    """The :class:`Inertia` of all parts at the origin of ``frame``."""
    return sum(part.about(frame) for part in (*parts, *(-hole for hole in removed)))


def answer(I):
    """The answer from an :class:`Inertia`."""
    return {"I_O": I.matrix}


def whole(frame, parts, removed=()):
    """The answer from bodies."""
    return answer(together(frame, parts, removed))


def problem_of(frame, parts, mass, length, inertia, holes=False, at_O=(), given=()):
    """``solve`` and ``steps`` for ``parts(g)``; with ``holes``, a pair of parts and holes."""
    bodies = lambda g: parts(g) if holes else (parts(g),)
    units = {"mass": mass, "length": length, "inertia": inertia}
    steps = lambda g: steps_of(frame, *bodies(g), at_O=at_O, given=given, **units)
    return (lambda g: whole(frame, *bodies(g))), steps


def untransferred(frame, part):
    """The part moved to O, for the mistake of a missing parallel axis term."""
    return Body(part.name, part.mass, frame.origin, part.inertia.moments, frame)


def named(products):
    """The three products of inertia as answers."""
    return dict(zip(("I_xy", "I_yz", "I_zx"), products, strict=True))


def wrong_sign(frame, I):
    """The mistake of products of inertia with a plus sign in the matrix."""
    return matrix(frame, I.moments, [-x for x in I.products])


def no_products(frame, I):
    """The mistake of omitted products of inertia."""
    return matrix(frame, I.moments)


def steps_of(frame, parts, removed=(), *, mass, length, inertia, at_O=(), given=()):
    """Mass (unless ``given``), own matrix, place, matrix at O of parts; ``at_O``: those there."""
    for part in (*parts, *removed):
        key, cut_out = part.name.split()[0], ", to be subtracted" if part in removed else ""
        if key not in given:
            yield Step(f"m_{key}", part.mass, mass, f"mass of the {part.name}{cut_out}", "7.10")
        own = part.about(part.centre, frame).matrix
        if part.name in at_O:
            means = f"inertia matrix of the {part.name} at O, its centre of mass"
            yield Step(f"I_{key}", own, inertia, means, "7.10", kind="matrix")
            continue
        means = f"inertia matrix of the {part.name} about its own centre of mass"
        yield Step(f"I_G_{key}", own, inertia, means, "7.10", kind="matrix")
        means, d = f"centre of mass of the {part.name}, from O", part.centre.position(frame)
        yield Step(f"d_{key}", d, length, means, "7.8")
        means, I = f"inertia matrix of the {part.name} at O", part.about(frame).matrix
        yield Step(f"I_{key}", I, inertia, means, "7.8", "7.25", kind="matrix")
