"""animation.py: an animation as a page of its own, in a notebook, and as a GIF."""

import base64
import io
import re

import pytest
from PIL import Image

from newton_euler.drawing.animation import Animation, AnimationError
from tests.markup import Page


def picture(grey):
    out = io.BytesIO()
    Image.new("L", (50, 40), grey).save(out, format="png")
    return out.getvalue()


def film(times=(0.0, 0.5, 1.0), speed=1.0, alt="A disk turns."):
    return Animation(tuple(picture(40 * n) for n in range(len(times))), times, speed, alt, (50, 40))


def test_a_page_has_the_picture_in_words_and_controls_with_names():
    page = Page(film().html())
    (img,), (slider,) = page.all("img"), page.all("input")
    assert img["alt"] == "A disk turns."
    assert base64.b64decode(img["src"].partition(",")[2]) == picture(0)
    assert slider | {"min": "0", "max": "2", "aria-label": "time"} == slider
    assert "hidden" in page.all("div")[1]  # the controls, until the script that they need runs


def test_a_page_of_a_film_waits_for_readers_is_safe_and_shares_no_name():
    assert 'play(!window.matchMedia("(prefers-reduced-motion: reduce)").matches)' in film().html()
    page = film(alt='<script>"&').html()
    assert 'alt="&lt;script&gt;&quot;&amp;"' in page
    assert page.count("<script>") == 1
    first, second = (re.search(r'id="(.*?)"', film().html())[1] for _ in range(2))
    assert first != second


def test_a_page_needs_nothing_from_elsewhere(tmp_path):
    film().save(tmp_path / "film.html")
    page = (tmp_path / "film.html").read_text(encoding="utf-8")
    assert page.startswith("<!DOCTYPE html>")
    assert '<html lang="en">' in page
    assert not re.search(r"https?:|<link|src=\"(?!data:)|\bimport\b", page)
    Page(page.partition("\n")[2])


def test_jupyter_gets_html_and_without_html_the_first_picture():
    bundle, about = film()._repr_mimebundle_()
    assert about["image/png"] == {"alt": "A disk turns.", "width": 50, "height": 40}
    assert bundle["text/html"].startswith("<div id=")
    assert base64.b64decode(bundle["image/png"]) == picture(0)
    words = "Animation of 3 pictures from t = 0.0 s to t = 1.0 s: A disk turns."
    assert bundle["text/plain"] == words


@pytest.mark.parametrize(("speed", "words"), [
    (1.0, "<span></span>"), (0.25, "shown 4 times slower"), (3600.0, "shown 3.6e+03 times faster"),
])  # fmt: skip
def test_the_page_says_how_the_show_differs_from_the_motion(speed, words):
    assert words in film(speed=speed).html()


@pytest.mark.parametrize(("times", "label"), [
    ((0.0, 0.04, 0.08), "t = 0.08 s"), ((0.0, 60.0, 120.0), "t = 120 s"),
    ((0.0, 1e-9, 2e-9), "t = 2e-09 s"), ((0.0, 0.1, 1.0), "t = 1.0 s"),
])  # fmt: skip
def test_times_have_the_decimals_that_distinguish_them(times, label):
    assert f'"{label}"' in film(times).html()


def waits(path):
    with Image.open(path) as gif:
        out = []
        for n in range(gif.n_frames):
            gif.seek(n)
            out.append(gif.info["duration"])
        return out, gif.info["loop"]


def test_a_gif_runs_for_ever_at_its_times_and_other_kinds_of_file_are_refused(tmp_path):
    film((0.0, 0.5, 1.5), speed=2.0).save(tmp_path / "film.gif")
    assert waits(tmp_path / "film.gif") == ([250, 500, 500], 0)
    film((0.0, 0.01, 0.02, 0.03, 0.04)).save(tmp_path / "film.gif")
    assert waits(tmp_path / "film.gif")[0] == [20, 20, 20]
    with pytest.raises(AnimationError, match=r"saved as .html or .gif; got 'film.mp4'"):
        film().save(tmp_path / "film.mp4")
