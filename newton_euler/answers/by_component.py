"""Mistakes made in some components alone, where none explains the whole: a listed one in those that
are wrong; in a formula, a slip in each of them, met with all digits at all points.
"""

from collections.abc import Callable, Iterator, Sequence

from .causes import Cause, both
from .fit import CLOSE, Fit, mixed
from .kinds import Kind
from .tolerance import NOISE, Points

PRECISE = 1e-3  # relative error of a component: in fewer digits it meets a mistake by chance
MOST = 3  # components, or entries of a symmetric matrix, that are wrong
Slip = tuple[int, Cause, Points]


def of_each_component(
    fit: Fit,
    kind: Kind,
    wrong: Sequence[tuple[Cause, Points]],
    slips: Callable[[Fit, Kind], Sequence[Slip]],
) -> tuple[Cause, ...]:
    """The mistake of the components that are wrong; or the simplest slips in the first two of them,
    as one cause, if there is one in each.
    """
    if not (groups := _wrong(fit, kind)):
        return ()
    off = [n for places in groups for n in places]
    if fit.rounding > PRECISE * max(abs(fit.first[0][n]) for n in off):
        return ()
    if found := [*_listed(fit, kind, off, wrong)]:
        return (found[0],)
    if not kind.is_formula or not 1 < len(groups) <= MOST:
        return ()
    if all(_is_multiple(fit, places) for places in groups):
        return ()  # each is a number times the right one, which some slip gives by chance
    for places in groups:
        alone = Fit(mixed(fit.given, fit.key, places), fit.key, fit.rtol)
        near = [(-1, cause, alone.given) for cause in _listed(alone, kind, places, wrong)]
        near = near or [slip for slip in slips(alone, kind) if alone(slip[2])]
        if not near:
            return ()
        found.append(min(near, key=lambda slip: slip[0])[1])
    first, *others = {cause.what: cause for cause in found}.values()
    cause = both(first, *others[:1]) if others else first
    return (cause,) if cause else ()


def _listed(
    fit: Fit, kind: Kind, off: Sequence[int], wrong: Sequence[tuple[Cause, Points]]
) -> Iterator[Cause]:
    """The listed mistakes that give the components ``off``, where others are right."""
    for cause, points in wrong:
        is_in_part = cause.group in ("listed", "usual") and len(off) < len(fit.key[0])
        if is_in_part and fit(mixed(points, fit.key, off)) >= CLOSE:
            is_listed = cause.group == "listed"
            yield kind.in_part(cause, off, fit.key[0]) if is_listed else cause


def _wrong(fit, kind):
    """The places of each wrong component; of a matrix, an entry with its mirror image."""
    if (length := len(fit.key[0])) < 3:
        return []
    off = fit.off(NOISE if kind.is_formula else kind.rtol)
    mirrored = [3 * (n % 3) + n // 3 if kind.is_matrix else n for n in range(length)]
    if kind.is_matrix and _is_flat(fit.given) and _is_flat(fit.key):
        off = [n for n in off if n != 8 or len(off) == 1]  # I_zz follows from the two others
    return [tuple({n, mirrored[n]}) for n in off if n <= mirrored[n] or mirrored[n] not in off]


def _is_multiple(fit, places):
    """True of a component that is one number times the right one at all points, as zero is."""
    pairs = [(x[n], k[n]) for x, k in zip(fit.given, fit.key, strict=True) for n in places]
    ratios = [x / k if k else 0.0 for x, k in pairs]
    return max(ratios) - min(ratios) <= NOISE * (1 + abs(ratios[0]))


def _is_flat(points):
    """True of the matrix of a plate, in which the third moment is the sum of the others."""
    return all(abs(x[0] + x[4] - x[8]) <= NOISE * abs(x[8]) for x in points)
