"""Wrong counts and words that can be given in any problem: degrees of freedom counted in other
coordinates, of bodies of another kind, with a constraint too many or too few; one of two conditions
misjudged, as of static and dynamic balance.
"""

from collections.abc import Iterator, Sequence

from newton_euler.algebra.language import Words, joined
from newton_euler.answers.causes import Cause
from newton_euler.dynamics.constraints import KINDS, Freedom

IN_SPACE = {
    "particle in plane": "particle", "particle on line": "particle", "body in plane": "body",
}  # fmt: skip
IN_PLANE = {"particle": "particle in plane", "body": "body in plane"}
PARTICLES = {"body": "particle", "body in plane": "particle in plane"}
BODIES = {
    "particle": "body", "particle in plane": "body in plane", "particle on line": "body in plane",
}  # fmt: skip
OTHERWISE = (
    (IN_SPACE, Words("counts coordinates in space"), Words("not all directions are free")),
    (IN_PLANE, Words("counts coordinates in a plane"), Words("the motion is in space")),
    (PARTICLES, Words("takes bodies for particles"), Words("a body can turn as well")),
    (BODIES, Words("takes particles for bodies"), Words("turning is not counted here")),
)


def miscounts(right: Freedom) -> list[tuple[Cause, int]]:
    """[(cause, count)] of the wrong counts, each with its simplest causes only."""
    found: dict[int, tuple[int, list[Cause]]] = {}
    for rank, n, what, why in _all(right):
        simplest, causes = found.setdefault(n, (rank, []))
        if rank == simplest and n >= 0 and n != right.count:
            text = Words("{what}: {why}", what=what, why=why)
            causes.append(Cause("count", str(what), text))
    return [(cause, n) for n, (_, causes) in found.items() for cause in causes]


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


def _all(right: Freedom) -> Iterator[tuple[int, int, str, str]]:
    """(rank, count, what is done, why it is wrong) of each wrong count, simplest first."""
    every, off, own = right.unknowns, right.rank, right.count
    once, taken = Words("each independent equation counts once"), Words("they are to be taken off")
    if off:
        yield 1, own + 1, Words("forgets a constraint"), once
        yield 1, off, Words("gives the number of constraints"), taken
        yield 1, every, Words("takes no constraint off the coordinates"), once
    yield 1, own - 1, Words("takes off a constraint too many"), once
    others = []
    for kinds, what, why in OTHERWISE:
        changed = sum(KINDS.get(kinds.get(_named(k), k), k) for k in right.bodies.values())
        others += [(changed, what, why)] * (changed != every)
    yield from ((1, n - off, what, why) for n, what, why in others)
    for n in range(2, off):
        yield 2, own + n, Words("forgets several constraints"), once
    for n, what, why in others if off else ():
        yield 2, n, Words("{what}, and takes no constraint off", what=what), why
        yield 2, n - off + 1, Words("{what}, and forgets a constraint", what=what), why
        for m in range(2, off):
            yield 2, n - off + m, Words("{what}, and forgets several constraints", what=what), why
    if off > 1:
        yield 2, every - 2 * off, Words("takes each constraint off twice"), once


def _named(kind):
    """The name of a kind that is given as a number of coordinates: 1 along a line."""
    return "particle on line" if kind == 1 else kind
