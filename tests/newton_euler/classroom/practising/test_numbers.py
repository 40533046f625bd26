"""The numbers of one variant of a practice file, made by hand."""

import itertools

import pytest

from newton_euler.answers import KINDS, Cause
from newton_euler.answers.causes import DOES, FACTOR_2, INSTEAD
from newton_euler.classroom.practising.numbers import KeptNumbers, KeptSlips, Quantity
from newton_euler.classroom.practising.programs import operate

WORDS = dict.fromkeys(("means", "plain", "section", "equation", "latex", "sum"), "")


def quantity(key, kind="number", **more):
    data = {"key": key, "kind": kind, "unit": "1", "atol": 1e-6, "of": [], "step": True}
    return Quantity.read(data | WORDS | more)


def numbers(right, wrong=(), labels=(), earlier=None, book=None):
    program = {"operations": [["value", 3.0], ["*", [0], 2.0]], "earlier": earlier or {}}
    program["quantities"] = {"a": [[0, 1.0]], "b": [[1, 1.0]]}
    variant = {"right": right, "wrong": list(wrong), "program": program}
    page = {"labels": labels, "slips": (), "where": "", "book": book is not None}
    page["variants"] = [variant] if book is None else [book, variant]
    return KeptNumbers([quantity(key) for key in right], page, len(page["variants"]) - 1)


def test_a_quantity_knows_its_kind_by_name():
    word = quantity("sense", "choice", of=["up", "down"])
    assert word.kind is KINDS["choice"]
    assert str(word.form) == "choice: up | down"


def test_right_numbers_are_points_and_wrong_ones_have_their_causes():
    labels = [
        [key, "listed", name, "takes half", "", "", "rescaled", "m"]
        for key, name in (("a", "half"), ("gone", "x"))
    ]
    found = numbers({"a": [3.0], "n": 2}, [[0, [1.5]], [1, [9.0]]], labels)
    assert found.key == {"a": ((3.0,),), "n": ((2,),)}
    ((cause, points),) = found.wrong("a")
    assert (cause, points) == (Cause("listed", "half", ""), ((1.5,),))
    assert (cause.does, cause.of) == ("rescaled", "m")
    assert found.wrong("n") == []


def test_a_slip_knows_the_answers_that_something_else_is_taken_for():
    labels = [["a", 6, "law", "takes m for v and w", "", "", does, "v w"] for does in DOES[-2:]]
    kept = KeptSlips(labels, [[0, [1.5]], [1, [2.5]]])
    found = [(c.does, c.of, c.answers) for _, c in kept.ranked("a").slips]
    assert found == [(FACTOR_2, "v w", ()), (INSTEAD, "", ("v", "w"))]


def test_what_follows_is_computed_by_the_kept_program_along_a_chain():
    found = numbers({"a": [3.0], "b": [6.0]}, earlier={"b": ["a"]})
    assert found.earlier == {"a": [], "b": []}
    found.tried = {"a"}
    assert found.earlier == {"a": [], "b": ["a"]}
    assert found.following("b", {"a": ((5.0,),)}) == ((10.0,),)
    assert found.following("c", {"a": ((5.0,),)}) is None
    names = [f"q{n}" for n in range(3000)]
    chain = {name: [before] for before, name in itertools.pairwise(names)}
    found = numbers({"q2999": [1.0]}, earlier=chain | {"q0": ["q2999"]})
    found.tried = {"q0", "q7"}
    assert found.earlier == {"q2999": ["q7"]}


@pytest.mark.parametrize("name", ["**", "pow"])
def test_no_power_in_a_file_fills_the_memory(name):
    with pytest.raises(OverflowError):
        operate(name, 7, 10**10)


@pytest.mark.parametrize("book", [None, {"right": {"a": [3.0]}}])
def test_the_numbers_of_the_book_are_those_of_its_variant(book):
    assert numbers({"a": [4.0]}, book=book).book == ({"a": ((3.0,),)} if book else {})
