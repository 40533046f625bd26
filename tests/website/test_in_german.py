"""The course in German in a real browser: a chapter with its predictions, a problem worked on its
page, and the page of feedback; what axe finds on each.
"""

import nbformat
import pytest

from newton_euler.algebra.language import speaking
from tests.once import once
from tests.website import feedback
from tests.website.browser import complaints, js, served, text, wait
from tests.website.test_practice import faults_found, practise, typed
from website import build, command, notebooks

pytestmark = [pytest.mark.integration, pytest.mark.slow]  # minutes

CHAPTER = "chapters/ch09_rotors.html"
SHOWN = (0, 27, 33)  # of its cells: the opening, a prediction, the tally
WRONG = {"H_O": [1, 2, 3], "F_A": [1], "balance": "both"}
IMPORTS = "from newton_euler.classroom import predict, tally"


def _shortened(folder):
    """The chapter and its German translation, cut to a few cells."""
    for name in ("ch09_rotors.ipynb", "de/ch09_rotors.ipynb"):
        found = nbformat.read(notebooks.FOLDER / name, as_version=4)
        found.cells = [found.cells[n] for n in SHOWN]
        found.cells.insert(1, nbformat.v4.new_code_cell(IMPORTS))
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        nbformat.write(found, folder / name)


@pytest.fixture(scope="module")
def german(tmp_path_factory):
    """The folder of a German site of chapter 9, with a page of feedback in it."""
    pytest.importorskip("myst_nb", reason="the site wants pip install -e '.[site]'")

    def make(out):
        folder = tmp_path_factory.mktemp("chapters")
        _shortened(folder)
        with pytest.MonkeyPatch.context() as patch, command.in_every_process("de"):
            patch.setattr(build.reference, "pages", dict)  # in English, and long
            build.build(out / "pages", ["ch09"], folder=folder, beside={"en": "../"})
        with speaking("de"):
            (out / "pages" / "feedback.html").write_text(feedback.page("9/4", WRONG), "utf-8")

    return once(tmp_path_factory, "german", make)[0] / "pages"


def test_a_chapter_a_problem_and_feedback_are_german_and_axe_finds_nothing(german, driver):
    if not (german / "practice").exists():
        pytest.skip("npm cannot reach Pyodide")

    def assert_right():
        assert js(driver, "document.documentElement.lang") == "de"
        assert faults_found(driver) == []

    with served(german) as address:
        driver.get(f"{address}/{CHAPTER}")
        assert text(driver, ".languages a[hreflang=en]") == "English"
        assert "Welche Kräfte ändern sich?" in text(driver, ".prediction .question")
        driver.execute_script("document.querySelectorAll('.choice summary')[2].click()")
        assert "Hebelarme" in text(driver, ".choice.chosen")
        assert text(driver, ".prediction-tally").startswith("1 von 1 Vorhersagen")
        assert_right()
        practise(driver, f"{address}/problems/9-4.html")
        assert "Trägheitsmoment um die Normale der Platte" in text(driver, ".practice")
        assert "Dezimalpunkt" in typed(driver, "H_O", ["3,5", "0", "0"])  # write 3.5
        m, b, h = 3.0, 0.24, 0.16
        along = m * (b**2 * 0.5 + h**2) / 12 * 62.8318531
        across = m * b**2 * 0.5 / 12 * 62.8318531
        verdict = typed(driver, "H_O", [f"{along:.6g}", f"{across:.6g}", "0"])
        assert "Deviationsmoment das falsche Vorzeichen" in verdict
        buttons = "[...document.querySelectorAll('.help button')]"
        driver.execute_script(f"{buttons}.find(b => b.textContent === 'Hinweis').click()")
        wait(driver, "document.querySelector('.practice .reply').textContent", "a hint")
        assert "Bestimmen Sie" in text(driver, ".practice .reply")
        assert complaints(driver) == []
        assert_right()
        driver.get(f"{address}/feedback.html")
        assert "Jeder Teil einer Aufgabe wird" in text(driver, "header")
        assert_right()
