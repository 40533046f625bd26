"""Sentences in the reader's language."""

import os
import pickle
import subprocess
import sys

import pytest

from newton_euler.algebra import NewtonEulerError, language
from newton_euler.algebra.language import (
    Words,
    _,
    are_words,
    from_stored,
    joined,
    plural,
    speaking,
    spoken,
    stored,
)
from newton_euler.answers.causes import computed, sentence, term_left_out


def test_words_are_english_texts_until_they_are_spoken():
    text = Words("leaves out {term}: this term is not zero here", term=Words("the Coriolis term"))
    assert text == "leaves out the Coriolis term: this term is not zero here"
    with speaking("de"):
        assert spoken(text) == "das Coriolis-Glied weglässt: dieses Glied ist hier nicht null"
        assert str(text).startswith("leaves out")
    assert spoken(text) == text


def test_a_cause_made_before_the_language_was_chosen_is_reported_in_it():
    cause = term_left_out("coriolis", Words("the Coriolis term")).at(
        Words("section {number}", number="4.10")
    )
    slip = computed("x", Words("{cause.what}, in one place: {cause.why}", cause=cause.text))
    with speaking("de"):
        assert sentence([cause]).startswith("das Coriolis-Glied weglässt: dieses Glied")
        assert sentence([cause]).endswith(" (siehe Abschnitt 4.10)")
        assert "das Coriolis-Glied weglässt (nur an einer Stelle): dieses" in sentence([slip])


def test_one_and_several_have_forms_of_their_own():
    days = "yesterday", "{n} days ago"
    assert [plural(*days, n) for n in (1, 3)] == ["yesterday", "3 days ago"]
    with speaking("de"):
        assert [plural(*days, n) for n in (1, 3)] == ["gestern", "vor 3 Tagen"]
        assert spoken(joined(["a", "b", "c"])) == "a, b und c"


def test_values_are_filled_in_once_and_without_their_attributes():
    with speaking("de"):
        assert _("nobody translates {this}", this="x") == "nobody translates x"
    assert (
        from_stored(["{x.__class__} {x.what} {0} {y}", {"x": "a: b"}]) == "{x.__class__} a {0} {y}"
    )
    assert _("{a} and {b}", a="{b}", b="c") == "{b} and c"


@pytest.mark.parametrize(
    "copy", [lambda x: from_stored(stored(x)), lambda x: pickle.loads(pickle.dumps(x))]
)
def test_words_are_kept_with_their_templates(copy):
    text = Words(
        "leaves out {term}: it is not zero here", term=Words("the term {formula}", formula="m*g")
    )
    assert copy(text) == text
    with speaking("de"):
        assert spoken(copy(text)) == spoken(text) != text


@pytest.mark.parametrize(
    "data", [3, [], ["a"], ["a", {"b": 3}], [3, {}], ["a", {"b": ["c", {"d": None}]}], {"a": "b"}]
)
def test_what_a_file_holds_in_place_of_words_is_not_read(data):
    assert not are_words(data)


def test_an_unknown_language_is_refused_with_the_known_ones():
    with pytest.raises(NewtonEulerError, match="'xx' here; there are en, de"), speaking("xx"):
        pass
    assert language.language() == "en"


@pytest.mark.parametrize(
    ("value", "found"), [("de", "de"), ("de_AT.UTF-8", "de"), ("xx", "en"), ("", "en")]
)
def test_the_environment_chooses_the_language(value, found):
    code = "from newton_euler.algebra.language import language; print(language())"
    environment = {**os.environ, language.VARIABLE: value}
    done = subprocess.run(
        [sys.executable, "-c", code], env=environment, capture_output=True, text=True
    )
    assert done.stdout.strip() == found
