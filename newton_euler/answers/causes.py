"""Why an answer is wrong: causes, each with an identity, and the words in which a student reads
them. The words complete "it fits a solution that …" and never contain a number of the key.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

from .tolerance import NEARLY

OR = "; or one that "  # between causes that give the same numbers
WORDS = 30  # of a diagnosis that is read
BRIEF = 9  # of each of two mistakes that are named together
ORDINALS = ("first", "second", "third")


@dataclass(frozen=True)
class Cause:
    """A cause of wrong answers. Two are the same if ``group`` and ``name`` are, however they are
    worded.

    group : listed (a mistake of the problem's own list), omitted or term, unit, axes or turned (of
        another frame), rate, book, exchanged, factor, slip, computed (a slip in one step), sequel
        (the same in going on from earlier answers), both (two listed ones at once), follows (from
        an earlier answer), seen (a remark, where nothing explains it)
    name : which one of its group: the name of the mistake, of the term, of the given …
    text : its words: what was done and, after a colon, why it is wrong
    where : the place in the book where to read on
    """

    group: str
    name: str
    text: str = field(compare=False)
    where: str = field(default="", compare=False)

    @property
    def what(self) -> str:
        """What was done."""
        return self.text.partition(": ")[0]

    @property
    def why(self) -> str:
        """Why that is wrong; "" where the same sentence says it."""
        return self.text.partition(": ")[2]

    @property
    def is_observation(self) -> bool:
        """True of a remark on an answer that no mistake explains."""
        return self.group == "seen"

    def at(self, where: str) -> "Cause":
        """The same cause with the place where to read on."""
        return replace(self, where=where)

    def after(self, wrong: Sequence[str]) -> "Cause":
        """The same slip in going on from earlier answers, of which these are wrong."""
        goes_on = f"goes on from your {' and '.join(wrong)}, but " if wrong else ""
        return replace(self, group="sequel", text=goes_on + self.text)

    @property
    def shows_everywhere(self) -> bool:
        """True of a mistake that is made once for the whole problem; a term can be left out, and
        axes confused, in one part alone.
        """
        return self.group in ("listed", "unit", "book", "computed")

    @property
    def adds_to_others(self) -> bool:
        """True of a cause that is named after another that gives the same numbers. The rest either
        describe these numbers (a sign, a factor), or are the other in other words (a term left
        out, a unit).
        """
        return self.group in ("listed", "book", "exchanged", "term")


def sentence(causes: Iterable[Cause]) -> str | None:
    """The words of the causes that give the same numbers, as many as can be read at once: what was
    done, why it is wrong, where to read on; None if there are none.
    """
    causes = sorted(causes, key=lambda c: c != CORIOLIS_HALVED)  # the simplest first
    if not causes:
        return None
    see = f" (see {causes[0].where})" if causes[0].where else ""
    words, *others = dict.fromkeys(c.what for c in causes)
    if not others:
        words = _within_words(causes[0].text, see) or words
    for other in others:
        words = _within_words(words + OR + other, see) or words
    return words + see


def _within_words(words, see):
    return words if len((words + see).split()) <= WORDS else None


def slip(name: str, text: str, why: str) -> Cause:
    """A slip that is made in any problem."""
    return Cause("slip", name, f"{text}: {why}")


OPPOSITE = slip(
    "opposite",
    "has the opposite sign in every component",
    "its direction is reversed against the axes of the text",
)
OPPOSITE_NUMBER = slip(
    "opposite", "has the opposite sign", "the text says which direction is positive"
)
TRANSPOSED = slip("transposed", "writes the transposed matrix", "rows stand in place of columns")
OFF_DIAGONAL = slip(
    "off diagonal",
    "has the opposite sign in every entry off the diagonal",
    "only the entries on the diagonal are right",
)
BOUNDS = slip("bounds", "has its bounds in the wrong order", "the lower one comes first")
OTHER_ORDER = slip(
    "order", "has its components in another order", "each belongs to one axis of the text"
)
AS_SCALARS = slip(
    "as scalars",
    "adds the rates of turning as numbers",
    "they are vectors along different axes",
)
ROUNDED = slip(
    "rounded", "rounds the right answer too far", "give three significant figures or more"
)
BOOK = Cause("book", "", "takes the numbers of the book: your sheet has others")
EARLIER = Cause(
    "book", "earlier", "takes the numbers of an earlier sheet of yours: this one has others"
)
DIRECTION = Cause("seen", "direction", "its size is right, its direction is not")
NEAR = Cause(
    "seen",
    "near",
    f"it is within {100 * NEARLY:.0f} % of the right answer: check each number and term in it",
)
NEAR_IN_FEW_DIGITS = Cause(
    "seen",
    "near in few digits",
    f"it is within {100 * NEARLY:.0f} % of the right answer: keep more digits, and round at the "
    "end",
)
FIRST_DIGITS = Cause(
    "seen",
    "first digits",
    "it agrees with the right answer in one or two digits only: three are needed",
)


def reversed_components(places: Sequence[int]) -> Cause:
    """Some components have the opposite sign."""
    text = f"has the opposite sign in its {_ordinals(places)} component{'s' * (len(places) > 1)}"
    why = "check the direction of what adds to it; the rest is right"
    return slip(f"opposite {_ordinals(places)}", text, why)


def left_out_component(place: int) -> Cause:
    """One component is zero."""
    text = f"leaves out its {ORDINALS[place]} component"
    return slip(f"without {ORDINALS[place]}", text, "it is not zero here")


def exchanged_components(places: Sequence[int]) -> Cause:
    """Two components stand in each other's place, or all three in another order."""
    if len(places) > 2:
        return OTHER_ORDER
    named = _ordinals(places)
    why = "each belongs to one axis of the text"
    return slip(f"exchanged {named}", f"exchanges its {named} components", why)


def _ordinals(places: Sequence[int]) -> str:
    return " and ".join(ORDINALS[n] for n in places)


def multiplied(what: str, factor: float, large: bool) -> Cause:
    """The answer is off by the factor between two units, or by 2."""
    how = "large" if large else "small"
    why = (
        "the answer has a unit of its own" if " against " in what else "look for a half or a double"
    )
    text = f"is {factor:.4g} times too {how} ({what}): {why}"
    return Cause("factor", f"{what} {how}", text)


def both(first: Cause, second: Cause) -> Cause:
    """Two listed mistakes made together; of what is too long, the beginning."""
    texts = [first.what, second.what]
    if len(" ".join(texts).split()) > 2 * BRIEF:
        texts = [" ".join(x.partition(", ")[0].split()[:BRIEF]) for x in texts]
    text = f"{', and also '.join(texts)}: both change the answer"
    return Cause("both", f"{first.name} + {second.name}", text)


def in_this_part(cause: Cause) -> Cause:
    """The same cause where other parts are right that it would have made wrong; so named where
    its reason has room, too.
    """
    here = replace(cause, text=f"in this part {cause.text}")
    words = sentence([here if here.where else here.at("section 1.1")]) or ""
    return here if len(words.split()) <= WORDS and here.why in words else cause


def answer_to(key: str) -> Cause:
    """Answers exchanged: this is the right one to another part."""
    return Cause("exchanged", key, f"answers {key} here: the two parts may be exchanged")


def follows(names: Sequence[str]) -> Cause:
    """The answer is right given the student's own wrong earlier ones."""
    return Cause("follows", " ".join(names), f"follows from a wrong {' and '.join(names)}")


def listed(name: str, text: str) -> Cause:
    """A mistake of the problem's own list."""
    return Cause("listed", name, text)


def term_left_out(name: str, words: str) -> Cause:
    """A named term of a sum is missing."""
    return Cause("omitted", name, f"leaves out {words}: this term is not zero here")


def term_reversed(name: str, words: str) -> Cause:
    """A named term of a sum has the opposite sign."""
    text = f"has {words} with the opposite sign: the equation adds it"
    return Cause("term", f"{name} x -1", text)


CORIOLIS_HALVED = Cause(
    "term",
    "coriolis / 2",
    "writes the Coriolis term without the factor 2: two equal effects add up in it",
)


def unconverted(given: str, unit: str) -> Cause:
    """A given is used with its number in another unit than the rest."""
    text = f"uses {given} in {unit} without converting it"
    return Cause("unit", given, f"{text}: the units of an equation must fit together")


def computed(name: str, text: str) -> Cause:
    """A slip in one step of the computation; ``name`` says in which, and which slip."""
    return Cause("computed", name, text)


def other_axes(place: int, frame: str) -> Cause:
    """The components are those along the axes of another frame, at this place among the frames."""
    return Cause(
        "axes",
        str(place),
        f"gives components along the axes of {frame}: the vector is right, but other axes are "
        "asked for",
    )


def turned_the_wrong_way(place: int, frame: str) -> Cause:
    """The components are turned by the transposed matrix between another frame and theirs."""
    return Cause(
        "turned",
        str(place),
        f"turns the components the wrong way between {frame} and the axes asked for: the matrix is "
        "transposed",
    )


def rate(name: str) -> Cause:
    """No mistake by itself: one of the rates of turning whose sum an angular velocity is."""
    return Cause("rate", name, name)
