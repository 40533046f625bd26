"""Why an answer is wrong: causes, each with an identity, and the words in which a student reads
them. The words complete "it fits a solution that …" and never contain a number of the key.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import cache

from ..algebra.language import Words, _, joined, spoken
from .tolerance import NEARLY, NOISE

WORDS = 30  # the most words in a diagnosis
BRIEF = 22  # the most words in two mistakes that are both named
ENTRIES = 3  # the most entries of a matrix that are listed as wrong
UNNAMED = Words("one term of a sum")
ORDINALS = Words("first"), Words("second"), Words("third")
# what a mistake does, where more than its words depends on it: leaves out a term or a quantity,
# takes a given for zero, leaves out a component, reverses a term, takes its double or half, has
# a factor of 2 beside a quantity, or takes something else for an answer
DOES = LEFT_OUT, ZERO, NO_COMPONENT, REVERSED, RESCALED, FACTOR_2, INSTEAD = (
    "left out", "zero", "no component", "reversed", "rescaled", "two", "instead",
)  # fmt: skip


@dataclass(frozen=True)
class Cause:
    """A cause of wrong answers. Two are the same if ``group`` and ``name`` are, however they are
    worded.

    group : listed (a mistake of the problem's own list), omitted or term, unit, axes or turned (of
        another frame), rate, book, exchanged, factor, usual (the number of another body), powers,
        slip, computed (a slip in one step), sequel (the same in going on from earlier answers),
        both (two listed ones at once), follows (from an earlier answer), seen (a remark, where
        nothing explains it)
    name : which one of its group: the name of the mistake, of the term, of the given …
    text : its words: what was done and, after a colon, why it is wrong; :class:`Words` appear in
        the reader's language
    where : where to read on in the book
    subject : shared by slips that are one and the same in other words: the last of them is named;
        the name of a listed mistake that a general one repeats
    does : what it does, one of :data:`DOES`, or ""
    of : to what, in words; "" of a term without a name
    answers : in place of which it takes something else
    """

    group: str
    name: str
    text: str = field(compare=False)
    where: str = field(default="", compare=False)
    subject: str = field(default="", compare=False)
    does: str = field(default="", compare=False)
    of: str = field(default="", compare=False)
    answers: tuple[str, ...] = field(default=(), compare=False)

    @property
    def what(self) -> str:
        """What was done."""
        return spoken(self.text).partition(": ")[0]

    @property
    def why(self) -> str:
        """Why that is wrong; "" where the same sentence says it."""
        return spoken(self.text).partition(": ")[2]

    @property
    def is_observation(self) -> bool:
        """True of a remark on an answer that no mistake explains."""
        return self.group == "seen"

    def at(self, where: str) -> "Cause":
        """The same cause, with where to read on."""
        return replace(self, where=where)

    def after(self, wrong: Sequence[str]) -> "Cause":
        """The same slip in going on from earlier answers, of which these are wrong."""
        text = self.text
        if wrong:
            text = Words("goes on from your {names}, but {cause}", names=joined(wrong), cause=text)
        return replace(self, group="sequel", text=text)

    @property
    def shows_everywhere(self) -> bool:
        """True of a mistake that is made once for the whole problem; a term can be left out, and
        axes confused, in one part alone.
        """
        return self.group in ("listed", "unit", "book", "computed")

    @property
    def adds_to_others(self) -> bool:
        """True of a cause that is named beside another that gives the same numbers. The other
        groups only describe these numbers (a sign, a factor), or repeat the first in other words (a
        term left out, a unit).
        """
        return self.group in ("listed", "book", "exchanged", "term")


def sentence(causes: Iterable[Cause]) -> str | None:
    """The sentence on causes that give the same numbers, as many as fit into :data:`WORDS`: what
    was done, why it is wrong if there is room, where to read on; None if no cause fits.
    """
    causes = sorted(causes, key=lambda c: c != CORIOLIS_HALVED)  # the simplest first
    if not causes:
        return None
    see = _(" (see {where})", where=causes[0].where) if causes[0].where else ""
    texts = map(spoken, _together(dict.fromkeys(c.text for c in causes)))
    in_full = {x.partition(": ")[0]: x for x in texts if _has_room(x.partition(": ")[0], see)}
    if not in_full:
        return None
    first, *others = in_full
    words = first
    for other in others:
        two = _("{first}; or one that {other}", first=words, other=other)
        words = two if _has_room(two, see) else words
    return (in_full[first] if words == first and _has_room(in_full[first], see) else words) + see


def _has_room(words, see):
    return len((words + see).split()) <= WORDS


def _together(texts):
    """The texts; of two that differ in one value only, one that has both."""
    found: list[str] = []
    for text in texts:
        for n, other in enumerate(found):
            mine, others = (getattr(x, "values", {}) for x in (text, other))
            alike = mine and getattr(other, "template", "") == text.template
            differ = [k for k in mine if alike and mine[k] != others[k]]
            if len(differ) == 1 and differ[0] in ("term", "quantity", "name", "factor"):
                (k,) = differ
                both = Words("{first} or {second}", first=others[k], second=mine[k])
                found[n] = Words(text.template, **{**mine, k: both})
                break
        else:
            found.append(text)
    return found


def slip(text: str, name: str, **values: object) -> Cause:
    """A slip that can be made in any problem."""
    return Cause("slip", name, Words(text, **values))


OPPOSITE = slip(
    "has the opposite sign in every component: its direction is reversed against the axes of the "
    "text",
    "opposite",
)
OPPOSITE_NUMBER = slip(
    "has the opposite sign: the text says which direction is positive", "opposite"
)
TRANSPOSED = slip("writes the transposed matrix: rows stand in place of columns", "transposed")
SQUARED = slip("is the square of the answer: its root is asked for", "squared")
ROOT = slip("is the square root of the answer: it was taken once too often", "root")
UNIT_VECTOR = slip("gives the unit vector: its magnitude is asked for as well", "unit")
INVERTED = slip("is upside down: numerator and denominator are exchanged", "inverted")
OFF_DIAGONAL = slip(
    "has the opposite sign in every entry off the diagonal: only the entries on the diagonal are "
    "right",
    "off diagonal",
)
DIAGONAL_ONLY = slip(
    "leaves out every product of inertia: only the entries on the diagonal are right",
    "diagonal only",
)
POLAR = slip(
    "takes the distance to the point for each moment of inertia: the distance to the axis counts",
    "polar",
)
PLANAR = slip(
    "takes the integral of x^2 for I_xx: it is that of y^2 + z^2, and likewise for each axis",
    "planar",
)
GIVES_ZERO = slip("gives zero: what was taken as zero is not, or two terms do not cancel", "zero")
BOUNDS = slip("has its bounds in the wrong order: the lower one comes first", "bounds")
OTHER_ORDER = slip(
    "has its components in another order: each belongs to one axis of the text", "order"
)
AS_SCALARS = slip(
    "adds angular velocities as numbers: they are vectors along different axes", "as scalars"
)
ROUNDED = slip("rounds the right answer too far: give three significant figures or more", "rounded")
BOOK = Cause("book", "", Words("takes the numbers of the book: your sheet has others"))
EARLIER = Cause(
    "book", "earlier", Words("takes the numbers of an earlier sheet of yours: this one has others")
)


def remark(text: str, name: str, **values: object) -> Cause:
    """A remark on an answer that no mistake explains."""
    return Cause("seen", name, Words(text, **values))


PERCENT = f"{100 * NEARLY:.0f}"
DIRECTION = remark("its magnitude is right, its direction is not", "direction")
NEAR = remark(
    "it is within {percent} % of the right answer: check each number and term in it",
    "near",
    percent=PERCENT,
)
NEAR_IN_FEW_DIGITS = remark(
    "it is within {percent} % of the right answer: keep more digits, and round at the end",
    "near in few digits",
    percent=PERCENT,
)
NUMBERS = remark("its symbols are right, a number in front of them is not", "numbers")
FIRST_DIGITS = remark(
    "it agrees with the right answer in one or two digits only: three are needed", "first digits"
)


def right_but(places: Sequence[int], key: Sequence[float], is_matrix: bool = False) -> Cause | None:
    """A remark: some components, or entries of a matrix, are not right; the others are. None of
    more entries than a student reads.
    """
    if is_matrix:
        names = _entries(places, key)
        if len(names) > ENTRIES:
            return None
        text = Words("all but {entries} is right", entries=joined(names))
    else:
        one = Words("all but its {which} component is right")
        several = Words("its {which} components are not right; the rest is")
        text = _of_places(places, one, several)
    return Cause("seen", f"right but {places}", text)


def _entries(places, key):
    """The names of entries of a matrix, of a symmetric one each once, as I_xy."""
    if all(abs(key[3 * n + m] - key[3 * m + n]) <= NOISE for n, m in ((0, 1), (0, 2), (1, 2))):
        return [*dict.fromkeys(_entry(*sorted(divmod(n, 3))) for n in places)]
    places = [(row + 1, column + 1) for row, column in (divmod(n, 3) for n in places)]
    return [Words("row {n}, column {m}", n=n, m=m) for n, m in places]


def reversed_components(places: Sequence[int]) -> Cause:
    """Some components have the opposite sign."""
    one = Words(
        "has the opposite sign in its {which} component: check the direction of its terms; "
        "the rest is right"
    )
    several = Words(
        "has the opposite sign in its {which} components: check the direction of their terms; "
        "the rest is right"
    )
    return Cause("slip", f"opposite {_ordinals(places)}", _of_places(places, one, several))


def left_out_components(places: Sequence[int]) -> Cause:
    """Some components are zero."""
    one = Words("leaves out its {which} component: it is not zero here")
    several = Words("leaves out its {which} components: they are not zero here")
    which, text = _ordinals(places), _of_places(places, one, several)
    return Cause("slip", f"without {which}", text, does=NO_COMPONENT, of=which)


def added_components(places: Sequence[int]) -> Cause:
    """Components where there are none."""
    one = Words("has a {which} component, where there is none: check what points along it")
    several = Words("has {which} components, where there are none: check what points along them")
    return Cause("slip", f"more {_ordinals(places)}", _of_places(places, one, several))


def exchanged_components(places: Sequence[int]) -> Cause:
    """Two components stand in each other's place, or all three in another order."""
    if len(places) > 2:
        return OTHER_ORDER
    which = _ordinals(places)
    text = Words(
        "exchanges its {which} components: each belongs to one axis of the text", which=which
    )
    return Cause("slip", f"exchanged {which}", text)


def moved_component(of: int, to: int) -> Cause:
    """One component is added to another."""
    text = Words(
        "puts its {one} component along the {other} axis: each belongs to its own axis",
        one=ORDINALS[of], other=ORDINALS[to],
    )  # fmt: skip
    return Cause("slip", f"moved {of} to {to}", text)


def _entry(n, m):
    return "I_" + "xyz"[n] + "xyz"[m]


def entry_left_out(n: int, m: int) -> Cause:
    """A moment or a product of inertia is zero."""
    name = _entry(n, m)
    return slip("leaves out {entry}: it is not zero here", f"no {name}", entry=name)


def entry_reversed(n: int, m: int) -> Cause:
    """A product of inertia has the opposite sign."""
    name = _entry(n, m)
    text = Words("has {entry} with the opposite sign: the rest is right", entry=name)
    return Cause("slip", f"opposite {name}", text)


def exchanged_entries(one: Sequence[int], other: Sequence[int]) -> Cause:
    """Two moments, or two products of inertia, stand in each other's place."""
    a, b = _entry(*sorted(one)), _entry(*sorted(other))
    text = Words("exchanges {a} and {b}: each has its own place", a=a, b=b)
    return Cause("slip", f"exchanged {a} {b}", text)


def _ordinals(places: Sequence[int]) -> str:
    return joined(ORDINALS[n] for n in places)


def _of_places(places: Sequence[int], one: Words, several: Words, **values: object) -> Words:
    """The sentence on one component, or on several, "the first and second"."""
    return Words(several if len(places) > 1 else one, which=_ordinals(places), **values)


HOW = Words("small"), Words("large")  # by whether it is larger
LOST = {
    2.0: Words("look for something halved or doubled"),
    **dict.fromkeys((10.0, 100.0), Words("look for a misplaced decimal point")),
}  # any other factor lies between two units


def multiplied(what: str, factor: float, large: bool) -> Cause:
    """The answer is off by the factor between two units, or by 2."""
    how, why = HOW[large], LOST.get(factor, Words("check the unit that is asked for"))
    text = Words("is {factor} times too {how} ({what}): {why}")
    text = Words(text, factor=f"{factor:.4g}", how=how, what=what, why=why)
    return Cause("factor", f"{what} {how}", text)


def bare(factor: str, large: bool) -> Cause:
    """The answer is off by a simple number, which has many causes."""
    how = HOW[large]
    text = Words("is {factor} times too {how}: look where it comes in", factor=factor, how=how)
    return Cause("factor", f"{factor} {how}", text)


def usual(number: str, body: str, is_place: bool) -> Cause:
    """The number in front is one by which another body is known."""
    one = Words("has the number {number} of {body}: the body, or the axis, is a different one")
    of_place = Words("has the number {number} of the centre of {body}: check which body it is")
    text = Words(of_place if is_place else one, number=number, body=body)
    return Cause("usual", number, text)


def powers(names: Sequence[str]) -> Cause:
    """The answer has other powers of some symbols."""
    text = Words(
        "has another power of {names} than asked for: look where it comes in, and compare the "
        "units",
        names=joined(names),
    )
    return Cause("powers", " ".join(names), text)


def of_number(factor: str) -> Cause:
    """The answer has the right symbols, times another number."""
    text = Words("has {factor} times the right number: its symbols are right", factor=factor)
    return Cause("factor", f"{factor} times", text)


def of_term(names: Sequence[str]) -> Cause:
    """The answer has one term too many, or too few, or with another number."""
    text = Words("is off by one term, in {names}: the other terms are right", names=joined(names))
    return Cause("powers", f"term in {' '.join(names)}", text)


def component_multiplied(places: Sequence[int], what: str, factor: float, large: bool) -> Cause:
    """Some components are off by one factor."""
    how = HOW[large]
    one = Words("has its {which} component {factor} times too {how} ({what}): the rest is right")
    more = Words("has its {which} components {factor} times too {how} ({what}): the rest is right")
    text = _of_places(places, one, more, factor=f"{factor:.4g}", how=how, what=what)
    return Cause("factor", f"{places} {what} {how}", text)


def both(first: Cause, second: Cause) -> Cause | None:
    """Two mistakes made together; None where naming both is too long: one of them, which alone does
    not explain the answer, would say nothing.
    """
    name = f"{first.name} + {second.name}"
    if second == OPPOSITE_NUMBER and first.does == REVERSED:
        text = Words("has all but {term} with the opposite sign", term=first.of)
        return Cause("both", name, text)
    text = Words("{first}, and also {second}: both count", first=first.what, second=second.what)
    has_room = len(f"{first.what} {second.what}".split()) <= BRIEF
    return Cause("both", name, text) if has_room else None


def in_this_part(cause: Cause) -> Cause:
    """The same cause, marked "in this part" where it would have made other parts wrong that are
    right, if the mark leaves room for its reason.
    """
    here = replace(cause, text=Words("in this part {cause}", cause=cause.text))
    words = sentence([here if here.where else here.at("section 1.1")]) or ""
    return here if len(words.split()) <= WORDS and here.why in words else cause


def in_components(
    cause: Cause, places: Sequence[int], key: Sequence[float], is_matrix: bool = False
) -> Cause:
    """The same cause in some components alone, where the others are right."""
    if is_matrix:
        names = joined(_entries(places, key))
        text = Words("in {entries} {cause}", entries=names, cause=cause.text)
    else:
        one = Words("in its {which} component {cause}")
        several = Words("in its {which} components {cause}")
        text = _of_places(places, one, several, cause=cause.text)
    return replace(cause, name=f"{cause.name} in {places}", text=text)


@cache  # asked for every pair of answers
def answer_to(key: str) -> Cause:
    """Answers exchanged: this is the right one to another part."""
    text = Words("answers {key} here: the two parts may be exchanged", key=key)
    return Cause("exchanged", key, text)


def follows(names: Sequence[str]) -> Cause:
    """The answer is right given the student's own wrong earlier ones."""
    text = Words("follows from a wrong {names}", names=joined(names))
    return Cause("follows", " ".join(names), text)


def listed(name: str, text: str) -> Cause:
    """A mistake of the problem's own list."""
    return Cause("listed", name, text)


def term_left_out(name: str, words: str) -> Cause:
    """A named term of a sum is missing."""
    text = Words("leaves out {term}: this term is not zero here", term=words)
    return Cause("omitted", name, text, does=LEFT_OUT, of=words)


def term_reversed(name: str, words: str) -> Cause:
    """A named term of a sum has the opposite sign."""
    text = Words("has {term} with the opposite sign: the equation adds it", term=words)
    return Cause("term", f"{name} x -1", text, does=REVERSED, of=words)


def multiple_of(term: str, factor: str = "") -> Cause:
    """A term has another factor: a remark, unless this is a simple number."""
    if factor:
        text = Words("has {factor} times {term}: the rest is right", factor=factor, term=term)
        return Cause("factor", f"{factor} times {term}", text)
    return remark("all but the factor of {term} is right", f"multiple of {term}", term=term)


CORIOLIS_HALVED = Cause(
    "term",
    "coriolis / 2",
    Words("writes the Coriolis term without the factor 2: two equal effects add up in it"),
    does=RESCALED,
    of=Words("the Coriolis term"),
)


def unconverted(given: str, unit: str) -> Cause:
    """A given is used with its number in another unit than the rest."""
    text = Words(
        "uses {given} in {unit} without converting it: the units of an equation must fit together",
        given=given, unit=unit,
    )  # fmt: skip
    return Cause("unit", str(given), text)


def computed(name: str, text: str, subject: str = "", does: str = "", of: str = "") -> Cause:
    """A slip in one step of the computation; ``name`` identifies the step and the slip."""
    return Cause("computed", name, text, "", subject, does, of)


def other_axes(place: int, frame: str) -> Cause:
    """The components are those along the axes of another frame, at this place among the frames."""
    text = Words(
        "gives components along the axes of {frame}: the vector is right, but other axes are asked "
        "for",
        frame=frame,
    )
    return Cause("axes", str(place), text)


def turned_the_wrong_way(place: int, frame: str) -> Cause:
    """The components are turned by the transposed matrix between another frame and theirs."""
    text = Words(
        "turns the components the wrong way between {frame} and the axes asked for: the matrix is "
        "transposed",
        frame=frame,
    )
    return Cause("turned", str(place), text)


def rate(name: str) -> Cause:
    """No mistake by itself: one of the terms whose sum is an angular velocity."""
    return Cause("rate", name, name)
