"""atlas.py: the page of all charts, and its command."""

import re

import pytest

from newton_euler.accuracy import atlas
from newton_euler.accuracy.atlas import ANSWERS, write_atlas
from newton_euler.accuracy.catalogue import Chart, charts
from newton_euler.accuracy.command import main
from newton_euler.algebra.errors import ArgumentError

NAMES = ["models of top", "steady precession", "map of steady precession"]


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    return write_atlas(tmp_path_factory.mktemp("atlas"), NAMES, quick=True)


def test_pictures_captions_and_numbers_are_on_the_page_by_question(page):
    text = page.read_text(encoding="utf-8")
    pictures = re.findall(r'<img src="(.+?)" alt="(.+?)"', text, re.S)
    names = "models-of-top", "map-of-steady-precession", "steady-precession"
    assert [name for name, _ in pictures] == [f"{name}.png" for name in names]
    for name, alt in pictures:
        assert (page.parent / name).stat().st_size > 10_000
        assert len(alt.split()) > 15
    text = page.read_text(encoding="utf-8")
    questions = re.findall(r"<section><h2>(.+?)</h2>", text)
    assert questions == ["Which model?", "Where does it change?", "When does it fail?"]
    links, places = re.findall(r'href="#(.+?)"', text), re.findall(r'id="(.+?)"', text)
    assert sorted(links) == sorted(places)
    assert len(places) == len(NAMES)
    text = page.read_text(encoding="utf-8")
    assert not re.search(r"https?://|<script|@import", text)
    assert text.count("<figcaption>") == text.count("<summary>Numbers</summary>") == len(NAMES)
    assert "the smallest model is" in text
    assert {chart.question for chart in charts().values()} == set(ANSWERS)


def test_a_chart_that_cannot_be_made_is_reported_and_the_others_are_drawn(tmp_path, monkeypatch):
    def broken(quick, progress):
        raise ArgumentError("heyoka is missing")

    lost = Chart("lost", "a title", "a kind", "Which method?", broken)
    known = {"lost": lost, "steady precession": charts()["steady precession"]}
    monkeypatch.setattr(atlas, "charts", lambda: known)
    text = write_atlas(tmp_path, quick=True).read_text(encoding="utf-8")
    assert "Not drawn: heyoka is missing" in text
    assert "steady-precession.png" in text


def test_the_command_writes_the_page_of_all_charts(tmp_path, monkeypatch, capsys):
    one = {"steady precession": charts()["steady precession"]}
    monkeypatch.setattr(atlas, "charts", lambda: one)
    with pytest.raises(SystemExit) as end:
        main(["atlas", "--quick", "--out", str(tmp_path)], prog_name="accuracy")
    assert end.value.code == 0
    assert capsys.readouterr().out == f"written: {tmp_path / 'index.html'}\n"
    assert (tmp_path / "index.html").exists()
