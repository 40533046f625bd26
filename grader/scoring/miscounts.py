"""Wrong counts and words that can be given in any problem: degrees of freedom counted in other
coordinates, of bodies of another kind, with constraints too many or too few; one of two conditions
misjudged, as of static and dynamic balance.

Several mistakes give the same count, which proves none of them: a diagnosis names one, and what all
such counts have in common.
"""

from collections.abc import Iterable, Iterator, Sequence

from newton_euler.algebra.language import Words, joined
from newton_euler.answers.causes import Cause
from newton_euler.dynamics.constraints import KINDS, Freedom

IN_SPACE = {
    "particle in plane": "particle", "particle on line": "particle", "body in plane": "body",
}  # fmt: skip
IN_PLANE = {"particle": "particle in plane", "body": "body in plane"}
OFF_LINE = {"particle on line": "particle in plane"}
PARTICLES = {"body": "particle", "body in plane": "particle in plane"}
BODIES = {
    "particle": "body", "particle in plane": "body in plane", "particle on line": "body in plane",
}  # fmt: skip
OTHERWISE = (
    (IN_SPACE, Words("counts coordinates in space"), Words("not all directions are free")),
    (IN_PLANE, Words("counts coordinates in a plane"), Words("the motion is in space")),
    (OFF_LINE, Words("counts coordinates across a line"), Words("the motion is along it")),
    (PARTICLES, Words("takes bodies for particles"), Words("a body can turn as well")),
    (BODIES, Words("takes particles for bodies"), Words("turning is not counted here")),
)

ONCE = Words("each independent equation counts once")
TAKEN = Words("they are to be taken off")
ONLY = Words("coordinates alone are counted")
TOO_MANY = Words("forgets constraints, or counts coordinates that are not free")
TOO_FEW = Words("takes off too many constraints, or forgets coordinates")


def miscounts(right: Freedom, met: Iterable[int] = ()) -> list[tuple[Cause, int]]:
    """[(cause, count)] of the wrong counts: of those in other coordinates, the next ones and those
    that are ``met`` by a listed mistake, what makes any count wrong; then what else gives it, the
    simplest only.
    """
    own, found = right.count, list[tuple[int, int, str, str]]()
    for rank, n, what, why in _otherwise(right):
        if all(rank == r for r, m, *_ in found if m == n):
            found.append((rank, n, what, why))
    every = {*met, own + 1, own - 1, *(n for _, n, *_ in found)}
    texts = [(0, n, TOO_MANY if n > own else TOO_FEW, ONCE) for n in every]
    return [
        (Cause("count", str(what), Words("{what}: {why}", what=what, why=why)), n)
        for _, n, what, why in (*texts, *found)
        if own != n >= 0
    ]


def misjudged(key: str, options: Sequence[str], right: str) -> list[tuple[Cause, str]]:
    """[(cause, word)] of the wrong words, where the options are neither, one, the other, both."""
    if len(options) != 4 or {options[0], options[-1]} != {"neither", "both"}:
        return []
    met = {w: {*options[1:3]} if w == "both" else {w} - {"neither"} for w in options}
    found = []
    for word in met.keys() - {right}:
        text = Words("takes the condition of {names} {key} as met: look at each by itself")
        if wrong := met[right] - met[word]:
            text = Words("takes the condition of {names} {key} as not met: look at each by itself")
        names = joined(sorted(wrong or met[word] - met[right]))
        text = Words(text.template, names=names, key=key)
        found.append((Cause("count", f"{key} {word}", text), word))
    return found


def _otherwise(right: Freedom) -> Iterator[tuple[int, int, str, str]]:
    """(rank, count, what was done, why it is wrong) of each, simplest first."""
    every, off = right.unknowns, right.rank
    if off:
        yield 1, off, Words("gives the number of constraints"), TAKEN
        yield 1, every, Words("takes no constraint off the coordinates"), TAKEN
    yield 1, 2 * right.count, Words("counts velocities beside coordinates"), ONLY
    others = []
    for kinds, what, why in OTHERWISE:
        changed = sum(KINDS.get(kinds.get(_named(k), k), k) for k in right.bodies.values())
        others += [(changed, what, why)] * (changed != every)
    yield from ((1, n - off, what, why) for n, what, why in others)
    for n, what, why in others if off else ():
        yield 2, n, Words("{what}, and takes no constraint off", what=what), why
        for m in range(1, off):
            yield 2, n - off + m, Words("{what}, and forgets constraints", what=what), why
    if off > 1:
        yield 2, every - 2 * off, Words("takes each constraint off twice"), ONCE


def _named(kind):
    """The name of a kind that is given as a number of coordinates: 1 along a line."""
    return "particle on line" if kind == 1 else kind
