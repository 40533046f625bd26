"""Every diagnosis of every problem says what was done, why it is wrong and where to read on, in at
most thirty words.
"""

import re
from itertools import combinations

import pytest

from exercises.catalogue import chapters, problems
from exercises.catalogue.steps import steps
from exercises.catalogue.variants import draw
from grader.scoring.numbers import Numbers
from newton_euler.algebra.language import spoken
from newton_euler.answers import causes
from newton_euler.answers.causes import sentence

MOST = 30
# a listed mistake may hold its reason within its sentence
REASON = (
    r"instead of|as if|rather than|in place of|although|, but |, though |, as | because |, since "
)


def general(p, n):
    """The causes of a problem that are not slips in its computation."""
    found = {c for a in p.answers for c, _ in n.wrong(a.key) if c.group != "rate"}
    listed = sorted((c for c in found if c.group == "listed"), key=lambda c: c.name)
    pairs = [causes.both(a, b) for a, b in combinations(listed, 2)]
    return [*found, *map(causes.in_this_part, found), *filter(None, pairs)]


def slips(p, n):
    ranked = [n.slips.ranked(a.key) for a in p.answers]
    return {cause for r in ranked if r for _, cause in r.slips}


def faults(p, causes_of):
    """The sentences that are too long, or leave out where, or why although there is room."""
    n = Numbers(p, draw(p, b"words") if p.givens else {})
    own = steps(p, {**n.sample, **p.sympy_symbols()})
    sections = {p.section, *(s.section for s in own)}
    for cause in causes_of(p, n):
        cause = cause if cause.where else cause.at(n.where)
        words = sentence([cause])
        if words is None:  # too long to be named
            continue
        has_room = len(f"{spoken(cause.text)} (see {cause.where})".split()) <= MOST
        has_reason = re.search(REASON, cause.text)
        if cause.why:
            has_reason = cause.why in words or not has_room
        see = re.search(r"\(see (?:section|appendix) ([\w.]+)(?:, \(([\w.]+)\))?\)$", words)
        is_place = see and see[1] in sections
        if see and see[2]:
            is_place = is_place and see[2].partition(".")[0] == p.section.partition(".")[0]
        if not (has_reason and is_place and len(words.split()) <= MOST):
            yield f"{p.id} {cause.group}: {words}"


@pytest.mark.one_in(3)
@pytest.mark.parametrize("chapter", chapters())
def test_a_diagnosis_says_what_why_and_where_in_thirty_words(chapter):
    assert not [x for p in problems(chapter) for x in faults(p, general)][:20]
    assert not [*faults(problems(chapter)[0], slips)][:20]


@pytest.mark.slow
@pytest.mark.parametrize("chapter", chapters())
def test_each_slip_in_a_computation_says_what_why_and_where(chapter):
    assert not [x for p in problems(chapter) for x in faults(p, slips)][:20]


GENERAL = [
    causes.OPPOSITE, causes.OPPOSITE_NUMBER, causes.TRANSPOSED, causes.OFF_DIAGONAL, causes.BOUNDS,
    causes.OTHER_ORDER, causes.AS_SCALARS, causes.ROUNDED, causes.BOOK, causes.EARLIER,
    causes.reversed_components([0, 2]), causes.left_out_components([1]),
    causes.exchanged_components([0, 1]), causes.answer_to("v_B"), causes.unconverted("v", "km/h"),
    causes.multiplied("ft against in", 144.0, True), causes.multiplied("a factor of 2", 2.0, False),
]  # fmt: skip


@pytest.mark.parametrize("cause", GENERAL, ids=lambda c: f"{c.group} {c.name}")
def test_a_general_cause_says_why(cause):
    words = sentence([causes.in_this_part(cause).at("section 4.10, (4.18)")])
    assert cause.why
    assert cause.why in words
    assert len(words.split()) <= MOST


def test_two_mistakes_that_give_the_same_are_both_named_the_simplest_first():
    first = causes.listed("a", "leaves out the weight: gravity acts here, too").at("section 6.1")
    other = causes.listed("b", "takes the speed as constant: it falls").at("section 6.1")
    assert sentence([first, other]) == (
        "leaves out the weight; or one that takes the speed as constant (see section 6.1)"
    )
