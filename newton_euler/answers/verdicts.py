"""The verdict on an answer: right, wrong and why, unreadable or blank. Pure functions over data;
nothing that a student wrote is run, evaluated as code or simplified here.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, partial
from itertools import chain, islice
from typing import Any, Protocol

from ..algebra.language import Words, _, joined, spoken
from ..algebra.units import unit as unit_of
from .causes import BOOK, EARLIER, Cause, answer_to, follows, sentence
from .diagnosis import Model, OtherPart, OtherParts, diagnose
from .fit import Fit, scaled_points
from .forms import Form
from .kinds import Kind
from .messages import one_line
from .near import LESS, RARER, Slips
from .tolerance import Points, is_apart
from .trees import Budget, TreeError, in_words
from .usual import of_a_number, of_one_term, of_other_bodies, of_other_powers

GROUND = 1  # index among the readings of a vector: in its own frame, in the ground, between
ABOUT = 2  # levels: slips that differ by no more are about as simple
NO_ANSWER = Words("no answer")
OTHER_NUMBERS = {
    BOOK: Words("not right: this is the answer for the book's numbers; yours are others"),
    EARLIER: Words(
        "not right: this is the answer for the numbers of an earlier sheet; yours are others"
    ),
}


class AskedAnswer(Protocol):
    """One answer that is asked for, with its tolerances as for :meth:`~.kinds.Kind.is_right`."""

    @property
    def key(self) -> str: ...
    @property
    def kind(self) -> Kind: ...
    @property
    def atol(self) -> float: ...
    @property
    def rtol(self) -> float: ...
    @property
    def unit(self) -> str: ...


# the names of earlier answers, and the function of {earlier answer: points} that follows from them
Way = tuple[Sequence[str], Callable[[Mapping[str, Points]], Points | None]]


class Numbers(Protocol):
    """The right numbers and the wrong models of one student's problem.

    answers : those that are asked for
    symbols : {name: array of the points at which formulas are compared}
    key : {answer: points} of the right answers; of a word or count, ((word,),)
    book, sheets : the same for the book's numbers, {} where these are asked; and for those of each
        of the student's earlier sheets
    earlier : {later answer: names of the earlier ones from which it follows}
    where : the place in the book to which the problem belongs, as "section 4.10"
    slips, sequel : in computing the answers; in computing one from a student's own earlier ones
    wrong, following : the wrong models of an answer; what follows from {earlier answer: points}
    other_ways : further ways from earlier answers to this one
    """

    @property
    def answers(self) -> Sequence[AskedAnswer]: ...
    @property
    def symbols(self) -> Mapping[str, Any]: ...
    @property
    def key(self) -> Mapping[str, Points]: ...
    @property
    def book(self) -> Mapping[str, Points]: ...
    @property
    def sheets(self) -> Sequence[Mapping[str, Points]]: ...
    @property
    def earlier(self) -> Mapping[str, Sequence[str]]: ...
    @property
    def where(self) -> str: ...
    @property
    def slips(self) -> Slips: ...
    def sequel(self, key: str, earlier: Mapping[str, Points]) -> Slips: ...
    def wrong(self, key: str) -> Sequence[Model]: ...
    def following(self, key: str, earlier: Mapping[str, Points]) -> Points | None: ...
    def other_ways(self, key: str) -> Sequence[Way]: ...


@dataclass(frozen=True)
class JudgedAnswer:
    """An answer judged: its verdict (right, wrong, unreadable or blank), a message, and the points
    that were read, in the unit of the key.
    """

    verdict: str
    message: str
    given: Points | None = None


def judge(
    asked: AskedAnswer,
    form: Form,
    tree: Any,
    fault: str | None,
    numbers: Numbers,
    budget: Budget,
    factor: float = 1.0,
) -> JudgedAnswer:
    """The verdict on the answer ``tree``, read in the ``form`` that the student had; ``fault`` says
    why it could not be read, if so. ``budget``: the operations of formulas that may be read;
    ``factor``: from the unit of the form to that of the key.
    """
    if fault is not None:
        return JudgedAnswer("unreadable", one_line(fault))
    if tree is None:
        return JudgedAnswer("blank", spoken(NO_ANSWER))
    try:
        readings = form.kind.readings(tree, form, numbers.symbols, budget)
    except TreeError as error:
        return JudgedAnswer("unreadable", _("cannot be read: {fault}", fault=one_line(str(error))))
    if factor != 1:
        readings = [scaled_points(factor, r) for r in readings]
    key = numbers.key[asked.key]
    right = counted(readings, key, asked, partial(numbers.wrong, asked.key))
    if right is not None:
        return JudgedAnswer("right", _("right"), right)
    wrong = next((given for given in readings if not is_right(asked, given, key)), None)
    return JudgedAnswer("wrong", _("not right"), wrong)


def is_right(asked: AskedAnswer, given: Points, key: Points) -> bool:
    """True if an answer is near enough to the key for what is asked."""
    return asked.kind.is_right(given, key, asked.atol, asked.rtol)


def counted(
    readings: Sequence[Points],
    key: Points,
    asked: AskedAnswer,
    wrong: Callable[[], Sequence[tuple[Cause, Points]]],
) -> Points | None:
    """The right one of the readings of an answer, or None. A student may make any frames. If any
    right components earned the points, frames turned by half a turn would be four guesses in one
    answer. One vector is one guess: its components in the ground, as its frames convert them, are
    the answer; those in another frame count only where the rest is the same right vector along
    other axes.

    wrong : returns [(cause, points)] of the wrong models, which most right answers do not need: of
        the group "axes", the right vector along the axes of the problem's other frames, of which
        the ground is named "0"
    """
    right = [is_right(asked, r, key) for r in readings]
    if True not in right or len(readings) == 1:
        return readings[0] if right == [True] else None
    if right[GROUND] or _is_one_guess(readings, right, key, asked, wrong()):
        return readings[right.index(True)]
    return None


def _is_one_guess(readings, right, key, asked, wrong):
    """True if each reading that is not the key is the right vector along axes of the problem, or,
    as long as the problem leaves the axes of the ground open, may be along axes that the student
    chose, which a known mistake is not.
    """
    axes = {cause.name: points for cause, points in wrong if cause.group == "axes"}
    free = not axes or "0" in axes  # else the axes are those of the ground

    def is_among(r, models):
        return any(is_right(asked, r, points) for points in models)

    mistakes = [points for cause, points in wrong if cause.group != "axes"]
    return all(
        is_among(r, axes.values())
        or (free and (right[0] or place == GROUND) and not is_among(r, mistakes)
            and not is_among(_sizes(r), [_sizes(key)]))
        for place, r in enumerate(readings)
        if not right[place]
    )  # fmt: skip


def _sizes(points):
    """The components without sign and order, which are the same for two guesses at the axes."""
    return tuple(tuple(sorted(map(abs, point))) for point in points)


@dataclass(frozen=True)
class Diagnosis:
    """Why an answer is wrong: a message for the student, the causes, the earlier answers of the
    student's own from which it follows, and the words about other causes that come after this.
    """

    message: str
    causes: tuple[Cause, ...] = ()
    earlier: tuple[str, ...] = ()
    also: str = ""

    @property
    def diagnosis(self) -> str | None:
        """The causes in words."""
        return sentence(self.causes)


def explain(asked: AskedAnswer, found: Mapping[str, JudgedAnswer], numbers: Numbers) -> Diagnosis:
    """Why an answer is wrong; ``found`` has each answer of the problem, judged."""
    given = found[asked.key].given
    assert given is not None
    earlier = _followed(asked, given, found, numbers)
    most = LESS if asked.kind.is_formula or asked.kind.length > 3 else RARER
    singles = partial(numbers.slips.singles, asked.key, most)  # one may be made beside a mistake
    # where an answer follows from earlier ones, a slip that fits was made there
    slips = () if earlier else (_slips(asked, found, numbers), singles)
    causes = _causes(asked, given, found, numbers, *slips)
    causes = tuple(c if c.where else c.at(numbers.where) for c in causes)
    for cause, words in OTHER_NUMBERS.items():
        if causes == (cause,):
            return Diagnosis(spoken(words), (cause,))
    if earlier:
        message = _("not right; it follows from your {names}", names=joined(earlier))
        why = sentence(causes)
        also = _("; it also fits a solution that {cause}", cause=why) if why else ""
        return Diagnosis(message, (follows(earlier), *causes), earlier, also)
    key = asked.kind.like(numbers.key[asked.key], given)
    if not causes and (seen := asked.kind.observed(given, key)):
        causes = (seen,)
    if causes and causes[0].is_observation:
        return Diagnosis(_("not right; {remark}", remark=causes[0].text), causes)
    why = sentence(causes)
    fits = _("not right; it fits a solution that {cause}", cause=why) if why else _("not right")
    return Diagnosis(fits, causes)


def _causes(asked, given, found, numbers, *slips):
    key, wrong = _like(given, asked, numbers)
    wrong += _exchanged(asked, given, found, numbers)
    if asked.kind.is_formula:
        fit, of = Fit(given, key, asked.kind.rtol), unit_of(asked.unit).dimension
        wrong += of_other_bodies(fit, of, numbers.symbols, asked.kind)
    factors = asked.kind.factors(asked.unit)
    elsewhere = OtherParts(lambda: _elsewhere(asked, found, numbers))
    causes = diagnose(given, key, wrong, asked.kind, factors, elsewhere, *slips)
    if not causes and slips and asked.kind.is_formula:
        of = fit, numbers.symbols, asked.kind
        found = of_other_powers(*of), of_a_number(fit, asked.kind), of_one_term(*of)
        return tuple(islice(chain(*found), 1))
    return causes


def _slips(asked, found, numbers):
    """Finds slips in computing from the givens, or else from the student's earlier answers."""
    wrong, earlier = _earlier(numbers.earlier.get(asked.key, ()), found, numbers)
    given = found[asked.key].given
    sequel = cache(lambda: numbers.sequel(asked.key, earlier))

    right = [n for n in earlier if n in found and n not in wrong]

    def fits_earlier(cause):
        """False of a slip that would show in an earlier answer that is right."""
        return not any(
            is_apart(points, numbers.key[n]) for n in right for points in numbers.slips.of(n, cause)
        )

    def near(fit, kind):
        slips = numbers.slips.near(asked.key, fit, kind)
        goes_on = earlier and None not in earlier.values()
        fitting = [s for s in slips if fits_earlier(s[1])]
        simplest = min((level for level, *_ in slips), default=0)
        is_made = any(level <= simplest + ABOUT for level, *_ in fitting)
        slips = fitting if is_made else slips
        # zero is no evidence, and nothing follows from a single component
        if is_made or not goes_on or not any(map(any, fit.given)) or fit.given is not given:
            return slips
        later = sequel().near(asked.key, fit, kind)
        return [(level, c.after(wrong), points) for level, c, points in later] or slips

    return near


def _like(given, asked, numbers):
    """(key, models) of an answer, each in the form nearest to the one given."""
    key, wrong = numbers.key[asked.key], list(numbers.wrong(asked.key))
    others = [(BOOK, numbers.book), *((EARLIER, sheet) for sheet in numbers.sheets)]
    wrong += [(cause, right[asked.key]) for cause, right in others if asked.key in right]
    like = asked.kind.like
    return like(key, given), [(cause, like(points, given)) for cause, points in wrong]


def _exchanged(asked, given, found, numbers):
    """The right answers to other parts of the kind, which may stand in each other's place."""

    def is_answered_by_it(other):
        there = found[other.key].given
        return there is not None and is_right(asked, there, numbers.key[asked.key])

    return [
        (answer_to(other.key), asked.kind.like(numbers.key[other.key], given))
        for other in numbers.answers
        if other.key != asked.key and other.key in found
        if other.kind == asked.kind and not other.kind.is_word
        if not other.kind.is_zero(numbers.key[other.key], other.atol)
        if other.unit == asked.unit or not other.kind.is_met_by_chance or is_answered_by_it(other)
    ]


def _elsewhere(asked, found, numbers):
    """The other parts that a student answered."""
    for other in numbers.answers:
        judged = found.get(other.key)
        if other.key != asked.key and judged and judged.given is not None:
            key, wrong = _like(judged.given, other, numbers)
            slips = partial(numbers.slips.of, other.key)
            right = judged.verdict == "right"
            yield OtherPart(right, other.kind, judged.given, key, wrong, slips, other.key)


def _followed(asked, given, found, numbers):
    """The student's own wrong answers from which this one follows rightly; () if it does not."""
    written = numbers.earlier.get(asked.key, ()), partial(numbers.following, asked.key)
    for names, follow in (written, *numbers.other_ways(asked.key)):
        wrong, earlier = _earlier(names, found, numbers)
        if not wrong or None in earlier.values():
            continue
        expected = follow(earlier)
        if expected is None or asked.kind.is_zero(expected, asked.atol):
            continue  # zero follows from zero without computing anything
        if is_right(asked, given, expected):
            larger = _doubled(earlier, wrong, follow)
            usual = _doubled({n: numbers.key[n] for n in names}, wrong, follow)
            if usual is None or is_right(asked, usual, numbers.key[asked.key]):
                return wrong
            # a huge number for every answer would follow from itself: the rest must show, too
            if larger and _gap(given, expected) < _gap(given, larger) < math.inf:
                return wrong
    return ()


def _doubled(earlier, wrong, follow):
    """Half of what follows if the ``wrong`` answers are doubled: the same as if nothing else
    counts. None if nothing follows, or words.
    """
    if any(isinstance(earlier[n][0][0], str) for n in wrong):
        return None
    found = follow({n: scaled_points(2.0, x) if n in wrong else x for n, x in earlier.items()})
    return None if found is None or isinstance(found[0][0], str) else scaled_points(0.5, found)


def _gap(given, points):
    """The largest distance of two answers, where they have values."""
    gaps = [math.dist(a, b) for a, b in zip(given, points, strict=True)]
    return max((gap for gap in gaps if not math.isnan(gap)), default=0.0)


def _earlier(names, found, numbers):
    """The earlier answers of these names: the names of the wrong ones, {name: points}."""
    wrong = tuple(n for n in names if n in found and found[n].verdict == "wrong")
    # an earlier part that the sheet does not ask for is not the student's
    return wrong, {n: found[n].given if n in found else numbers.key[n] for n in names}


def value_line(form: Form, tree: Any, verdict: str) -> str:
    """The value that was read, with its unit, as a line for the student; "" if none was."""
    if verdict not in ("right", "wrong"):
        return ""
    if form.kind.is_word:  # any JSON
        return one_line(tree)[:200]
    between = ", " if type(tree) is dict else " "  # components in several frames
    unit = between + form.unit if form.unit != "1" else ""
    text = in_words(form.kind.in_rows(tree))[:200] + unit
    return one_line(text) if type(tree) is dict else text  # the student named the frames
