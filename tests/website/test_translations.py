"""Every sentence is in the catalogue, every changed source is reported."""

import ast
import re
import shutil

import pytest
from click.testing import CliRunner

from exercises.catalogue import problem, sources
from exercises.catalogue import translations as texts
from newton_euler.algebra.language import messages, speaking
from newton_euler.classroom.predicting import predict
from website import command, notebooks, translations
from website.kept import ROOT

FIELD = re.compile(r"\{(\w+)(?:\.\w+)?\}")
SCRIPTS = sorted((ROOT / "website/theme/static").glob("*.js"))


@pytest.fixture(scope="module")
def german():
    return {text: m for text, m in translations.catalogue("de").items() if all(m.values())}


@pytest.fixture(scope="module")
def sentences():
    return translations.sentences()


NEW = 0.05  # of the sentences may be newer than their translation: they are in English


def test_the_catalogue_has_the_sentences_of_the_code_and_no_others(sentences, german):
    assert len(sentences.keys() - german.keys()) < NEW * len(sentences)
    assert len(german.keys() - sentences.keys()) < NEW * len(sentences)


def test_a_translation_has_the_values_of_its_sentence(german):
    for m in german.values():
        forms = [text for key, text in m.items() if key.startswith("msgstr")]
        own = {*FIELD.findall(m["msgid"]), *FIELD.findall(m.get("msgid_plural", ""))}
        assert all(set(FIELD.findall(text)) <= own for text in forms), m
        assert own - {"n"} <= set(FIELD.findall(forms[-1])), m


def test_a_cause_has_its_reason_after_a_colon_in_both_languages(german):
    for m in (
        m for m in german.values() if m["msgid"].startswith(("leaves out", "has ", "takes "))
    ):
        assert (": " in m["msgid"]) == (": " in m["msgstr"]), m


def test_no_name_for_what_is_not_used_hides_the_function_that_translates():
    for folder in translations.SOURCES:
        for path in (ROOT / folder).rglob("*.py"):
            for f in (
                x for x in ast.walk(ast.parse(path.read_text())) if isinstance(x, ast.FunctionDef)
            ):
                uses = {type(x.ctx) for x in ast.walk(f) if isinstance(x, ast.Name) and x.id == "_"}
                assert len(uses) < 2, f"{path}: {f.name}"


@pytest.mark.parametrize("path", SCRIPTS, ids=[p.name for p in SCRIPTS])
def test_no_sentence_of_a_script_escapes_translation(path):
    text = re.sub(r"(?m)(?<![:\"'`])//.*$|/\*.*?\*/", "", path.read_text("utf-8"))
    text = re.sub(r'gettext\("(?:[^"\\]|\\.)*"', "", text)
    bare = re.findall(r'"([A-Z][a-z]+(?: [a-zA-Z]+)*[.?:]?)"|`([A-Z][a-z]+ [^`]*)`', text)
    keys = {"Enter", "Escape", "DOMContentLoaded", "Worker", "Content-Type"}  # names of a browser's
    assert [a or b for a, b in bare if (a or b) not in keys] == []


def test_a_catalogue_that_is_written_again_stays_as_it_is(tmp_path, monkeypatch):
    shutil.copy(translations.FOLDER / "de.po", tmp_path)
    monkeypatch.setattr(translations, "FOLDER", tmp_path)
    before = list(messages((tmp_path / "de.po").read_text("utf-8")))
    monkeypatch.setattr(translations, "notebooks", list)
    assert list(messages(translations.write_catalogues("de")[0].read_text("utf-8"))) == before


# -- problems


def test_a_problem_has_its_texts_in_the_language_that_is_spoken():
    p = problem("9/4")
    with speaking("de"):
        q = texts.translated(p)
    assert q.title == "Schräge Platte an einer Welle"
    assert q.givens["m"].means == "Masse der Platte"
    assert q.givens["m"].value == p.givens["m"].value
    assert q.code is p.code
    assert texts.translated(p) is p


def test_the_german_texts_name_the_same_quantities():
    for n in range(1, 10):
        p = problem(f"9/{n}")
        with speaking("de"):
            q = texts.translated(p)
        assert set(FIELD.findall(q.text)) == set(FIELD.findall(p.text)), p.id
        assert all(a.means != b.means for a, b in zip(p.answers, q.answers, strict=True))
        assert not set(p.mistakes.values()) & set(q.mistakes.values())


def test_a_changed_text_of_a_problem_makes_its_translation_stale(monkeypatch):
    assert sources.is_current("9/4", "de") is True
    assert sources.is_current("4/16", "de") is None
    changed = dict(problem("9/4").mistakes, wrong_sign="another reason")
    monkeypatch.setitem(problem("9/4").mistakes, "wrong_sign", changed["wrong_sign"])
    assert sources.is_current("9/4", "de") is False
    part = next(x for x in translations.report("de") if x.name == "problems of ch09")
    assert (part.missing, part.stale, part.percent) == ([], ["9/4"], 88)


# -- chapters


@pytest.fixture
def rotors():
    chapter = notebooks.chapters(["ch09"])[0]
    return chapter, notebooks.translation(chapter, "de")


def test_a_translated_chapter_has_the_same_code_and_the_same_equations(rotors):
    for cell, own in zip(*(c.cells for c in rotors), strict=True):
        text, translated = ("".join(c["source"]) for c in (cell, own))
        assert own["cell_type"] == cell["cell_type"]
        if cell["cell_type"] == "code":
            assert translated == text
        formulas = r"(?s)\$\$.*?\$\$"
        assert re.findall(formulas, translated) == re.findall(formulas, text)
        for found in (r"\\tag\{.*?\}", r"(?m)^#+ (\d+\.\d+)", r"\b\d+/\d+\b(?!\})"):
            assert re.findall(found, translated) == re.findall(found, text)


def test_its_predictions_are_reported_in_its_language_by_the_same_code(rotors):
    source, own = rotors
    wanted = translations.predictions(source)
    known = translations.catalogue("de", translations.file_of(source, "de"))
    assert len(wanted) > 80
    assert {text for text in wanted if not known[text]["msgstr"]} == set()
    cell = next(c for c in own.cells if "twice the radius" in "".join(c["source"]))
    with speaking("de"):
        asked: list = []
        exec("".join(cell["source"]), {"predict": lambda *a: asked.append(predict(*a))})
    shown = asked[0].html()
    assert "Welche Kräfte ändern sich?" in shown
    assert "keine" in shown
    assert asked[0].question.right == "keine"
    assert "Hebelarme" in asked[0].judge("das nähere").words
    assert "Which" not in shown


def test_a_changed_cell_makes_its_translation_stale(rotors):
    chapter, own = rotors
    cell, translated = chapter.cells[0], own.cells[0]
    assert notebooks.is_cell_current(cell, translated)
    assert not notebooks.is_cell_current({**cell, "source": ["another text"]}, translated)


def test_a_site_in_another_language_is_named_with_its_address():
    done = CliRunner().invoke(command.main, ["--beside", "de"])
    assert "--beside de: expected LANGUAGE=ADDRESS, as en=../" in done.output
