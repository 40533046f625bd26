"""A prediction in a real JupyterLab, in a real browser: clicked, typed, kept, and shown again."""

import json

import pytest

from tests.jupyterlab import Page, chromium, jupyterlab, write_notebook

pytestmark = [pytest.mark.slow, pytest.mark.integration]

CELLS = [
    "from newton_euler.classroom import predict, predict_again, tally\n"
    'predict("Which is $x$?", {"one": "That is $y$.", "two": "Right."}, "two")',
    'predict("How many?", {4.0: "Twice too many."}, 2.0, "m", within=0.1, why="Count.")',
    "tally()",
    'predict("Which is $x$?", {"one": "That is $y$.", "two": "Right."}, "two")',
]


def test_a_choice_and_a_sentence_open_the_answer_and_stay(tmp_path):
    write_notebook(tmp_path / "p.ipynb", CELLS)
    with (
        jupyterlab(tmp_path / "p.ipynb", tmp_path / "own") as address,
        chromium(tmp_path / "profile") as driver,
    ):
        page = Page(driver)
        page.open(address, 2)
        page.wait(lambda: page.all("button[title='Predict a']", 0), "the buttons")
        page.all("button[title='Predict a']", 0)[0].click()
        page.says(0, "✗ You predicted: one", "That is", "The answer: two")
        assert page.all("mjx-container", 0)
        field = page.wait(lambda: page.all(".widget-text input", 1), "the field")[0]
        field.send_keys("it's more than I thought\n")
        page.says(1, "You predicted: it's more", "The answer: 2 m", "Count")
        page.run(2)
        page.says(2, "2 of 2 predictions made: 0 right, 1 wrong.")
        page.run(0)
        page.says(0, "✗ You predicted: one")  # as kept
        page.run(3)
        page.wait(lambda: page.all("button[title='Predict b']", 3), "an equal question")[0].click()
        page.says(3, "✓ You predicted: two")
    kept = json.loads((tmp_path / "predictions.json").read_text())
    assert set(kept.values()) == {"one", "two", "it's more than I thought"}
