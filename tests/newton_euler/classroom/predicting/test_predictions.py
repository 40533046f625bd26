"""Predictions: judged by a computed answer, kept beside the notebook, asked again."""

import json
from itertools import count
from types import SimpleNamespace

import pytest

from newton_euler.algebra.errors import ArgumentError
from newton_euler.answers import givens
from newton_euler.classroom import predict, predict_again, tally
from newton_euler.classroom.predicting import asking, panel, question
from newton_euler.classroom.predicting.page import folded_html, inline
from tests.markup import Page


@pytest.fixture(autouse=True)
def fresh(tmp_path, monkeypatch):
    """A notebook that has just been opened, in an empty folder."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(asking, "_asked", {})
    monkeypatch.setattr(asking, "_unwritten", {})


SIGNS = {"up": "That is the velocity.", "down": "Weight acts all the way."}


def bounce(answer="down"):
    return predict("Where does $a$ point?", SIGNS, answer)


def speed(**options):
    asked = {"answer": 2.5, "unit": "m/s", "within": 0.1, "why": "By (1.2)."} | options
    return predict("How fast?", {5.0: "This is twice the speed."}, **asked)


def test_a_choice_is_judged_by_the_computed_answer_yes_and_no_by_what_is_true():
    assert bounce().judge("a") == bounce().judge("up")
    assert not bounce().judge("a").right
    assert bounce().judge("down").right
    assert bounce("up").judge("a").right
    choices = {"yes": "Only if it rests.", "no": "It turns."}
    for answer in (True, False):
        assert predict("Is it 0?", choices, answer).judge("yes").right is answer


@pytest.mark.parametrize("computed", [-2.0000000001, -2.03, -2])
def test_a_computed_number_finds_the_choice_that_stands_for_it(computed):
    p = predict("Factor?", {2: "no sign", -2: "both", -1: "no length"}, computed)
    assert p.judge("-2").right
    assert not p.judge("2").right


@pytest.mark.parametrize(("choices", "answer", "within", "words"), [
    (SIGNS, "left", None, "one of the choices"), ({2: "a", 3: "b"}, 2.6, None, "one of the choices"),
    ({"up": "", "down": "x"}, "up", None, "one of the choices"), ({}, "up", None, "one of the choices"),
    ({1.0: "x", 1.0000001: "y"}, 1.0, None, "read alike"), ({2.6: "x"}, 2.5, 0.1, "cannot be told"),
])  # fmt: skip
def test_a_question_without_a_right_choice_or_a_meaning_is_refused(choices, answer, within, words):
    with pytest.raises(ArgumentError, match=words):
        predict("?", choices, answer, within=within)


@pytest.mark.parametrize(("typed", "right", "words"), [
    ("2.5", True, ""), ("2.5 m/s", True, ""), ("5/2", True, ""), ("2.58", True, ""),
    ("2.7", False, ""), ("5", False, "This is twice the speed."), ("−2.5", False, ""),
    ("faster than before, I think", None, ""), ("it's", None, ""), ("[1, 2]", None, ""),
    ("1/0", None, ""), ("__import__('os')", None, ""), ("nan", None, ""),
])  # fmt: skip
def test_a_typed_prediction_is_a_number_or_words_and_never_an_error(typed, right, words):
    judged = speed().judge(typed)
    assert (judged.right, judged.words) == (right, words)
    assert typed in Page(speed().choose(typed).html()).text


def test_the_answer_is_seen_after_the_prediction_and_opens_with_what_a_wrong_choice_means():
    for p, answer in ((bounce(), "Weight acts"), (speed(), "By (1.2)")):
        assert answer not in repr(p)
        p.choose("a" if p.question.choices else "5")
        assert answer in repr(p)
    text = repr(bounce().choose("a"))
    assert text.index("You predicted: up") < text.index("That is the velocity")
    assert text.index("That is the velocity") < text.index("The answer: down")


def test_only_the_first_prediction_is_kept_and_opens_again_with_the_notebook(monkeypatch):
    bounce().choose("a").choose("b")
    monkeypatch.setattr(asking, "_asked", {})
    assert bounce().given == "up"
    assert "You predicted: up" in repr(bounce())


def test_questions_of_the_same_words_are_distinguished_by_their_choices():
    first, other = predict("v?", {1: "x", 2: "y"}, 2), predict("v?", {3: "x", 4: "y"}, 4)
    first.choose("b")
    assert (first.given, other.given) == ("2", None)
    assert str(tally()) == "1 of 2 predictions made: 1 right, 0 wrong."


@pytest.fixture
def run(monkeypatch):
    """A function that runs a cell of a notebook, by its id and text; returns what it asks."""
    runs = count()

    def cell(ask, cell_id="c1", code="bounce()"):
        parent = {"header": {"msg_id": f"run {next(runs)}"}, "content": {"code": code},
                  "metadata": {"cellId": cell_id} if cell_id else None}  # fmt: skip
        shell = SimpleNamespace(kernel="any", get_parent=lambda: parent)
        monkeypatch.setattr(givens, "_shell", lambda: shell)
        return ask()

    return cell


@pytest.mark.parametrize("cells", [
    [("c1", ""), ("c2", "")], [(None, "bounce()"), (None, "bounce() # again")],
    [("vscode:a.ipynb#W1", ""), ("vscode:a.ipynb#W2", "")],
])  # fmt: skip
def test_an_equal_question_in_another_cell_is_another_one(run, monkeypatch, cells):
    one, other = cells
    run(bounce, *one).choose("a")
    assert run(bounce, *other).given is None
    run(bounce, *other).choose("b")
    assert [run(bounce, *c).given for c in (other, one)] == ["down", "up"]
    assert str(tally()) == "2 of 2 predictions made: 1 right, 1 wrong."
    monkeypatch.setattr(asking, "_asked", {})  # as when the notebook is opened again
    assert [run(bounce, *c).given for c in cells] == ["up", "down"]


def test_a_cell_that_runs_first_after_opening_has_not_the_prediction_of_an_equal_one(
    run, monkeypatch
):
    run(bounce, "c1").choose("a")
    monkeypatch.setattr(asking, "_asked", {})
    assert run(bounce, "c2").given is None
    assert run(bounce, "c1").given == "up"


def test_equal_questions_of_one_cell_are_as_many(run):
    both = lambda: [bounce(), bounce()]
    first, second = run(both)
    first.choose("a"), second.choose("b")
    assert [p.given for p in run(both)] == ["up", "down"]
    assert [p.given for p in predict_again(first, second).predictions] == [None, None]
    again, other = predict_again(first, second).predictions
    again.choose("b")
    assert (again.given, other.given) == ("down", None)


def test_the_number_of_an_equal_question_is_not_the_end_of_another_one(run):
    """Where cells have no ids, and for a question that is asked again."""
    text = "Where does $a$ point?"
    asked = [
        lambda end=end: predict(f"{text}{end}", SIGNS, "down") for end in ("", " (2)", " (again)")
    ]
    for n, ask in enumerate(asked):
        run(ask, None, f"cell {n}").choose("a")
    assert run(asked[0], None, "cell 9").given is None
    assert [p.given for p in predict_again().predictions] == [None, None, None]


def test_a_button_is_its_choice_and_not_the_one_that_reads_as_its_letter():
    widgets = pytest.importorskip("ipywidgets")
    p = predict("Which is larger?", {"b": "It is not.", "a": "By (1.2)."}, "a")
    shown = SimpleNamespace(update=lambda *_, **__: None)
    panel._Panel(p, widgets, shown).box.children[0].click()
    assert p.given == "b"


def test_choices_that_read_alike_once_translated_are_refused(monkeypatch):
    monkeypatch.setattr(question, "_", lambda text: text.replace("speed", "velocity"))
    with pytest.raises(ArgumentError, match="two choices read alike"):
        predict("What?", {"the speed": "x", "the velocity": "y"}, "the velocity")


def test_a_prediction_that_an_earlier_version_kept_is_read_for_the_first_of_equal_ones(
    run, monkeypatch
):
    bounce().choose("a")  # outside a notebook, under the question alone
    monkeypatch.setattr(asking, "_asked", {})
    assert [run(bounce, c).given for c in ("c1", "c2", "c1")] == ["up", None, "up"]


def test_a_damaged_file_and_a_folder_that_cannot_be_written_lose_no_more_than_they_must(tmp_path):
    (tmp_path / asking.FILE).write_text("{")
    assert bounce().given is None
    (tmp_path / asking.FILE).unlink()
    (tmp_path / asking.FILE).mkdir()
    assert "only while this notebook runs" in repr(bounce().choose("a"))
    assert bounce().given == "up"


def test_what_is_kept_is_a_small_file_of_text(tmp_path):
    bounce().choose("a")
    assert json.loads((tmp_path / asking.FILE).read_text()) == {bounce().question.key: "up"}


def test_a_line_of_markdown_becomes_html():
    assert inline("*a* **b** `x<1` $x<1$ <b>") == (
        "<i>a</i> <b>b</b> <code>x&lt;1</code> "
        r'<span class="math notranslate nohighlight">\(x&lt;1\)</span> &lt;b&gt;'
    )


def test_the_tally_counts_and_what_was_wrong_is_asked_again():
    wrong, right, sentence = bounce(), speed(), predict("Why?", why="So.")
    assert str(tally()) == "0 of 3 predictions made."
    wrong.choose("a"), right.choose("2.5"), sentence.choose("Because it turns.")
    assert str(tally()) == "3 of 3 predictions made: 1 right, 1 wrong."
    (again,) = predict_again().predictions
    assert again.given is None
    assert again.choose("b").right
    assert wrong.given == "up"
    assert [p.question.text for p in predict_again(right).predictions] == ["How fast?"]


@pytest.mark.parametrize("make", [bounce, speed, lambda: predict("What if x < 1 & y > 2?")])
def test_without_a_kernel_all_is_folded_and_well_formed(make):
    text = Page(folded_html(make().question)).text
    assert text.startswith("Predict. ")
    assert "$" not in text
