"""The sliders of a figure in a real JupyterLab, in a real browser: by keyboard and by mouse, with
the time from the event to the changed picture, as a reader sees it. ``-s`` prints the times.
"""

import statistics
import time
from pathlib import Path

import pytest

from tests.chapters.moving_figures import FIGURES
from tests.jupyterlab import Page, chromium, jupyterlab, write_notebook

pytestmark = [pytest.mark.slow, pytest.mark.integration]

CELLS = [
    "from tests.chapters.moving_figures import FIGURES\n"
    f"figure, given = FIGURES[{name!r}]\n"
    "figure(**given)"
    for name in FIGURES
]
# measured on two busy cores: 40 to 120 ms
SOON_MS = 1000

WATCH = Path(__file__).with_name("watch_a_slider.js").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    """The notebook, all cells run."""
    folder = tmp_path_factory.mktemp("lab")
    write_notebook(folder / "figures.ipynb", CELLS)
    own, profile = tmp_path_factory.mktemp("jupyter"), tmp_path_factory.mktemp("chromium")
    with jupyterlab(folder / "figures.ipynb", own) as address, chromium(profile) as driver:
        page = Page(driver)
        page.open(address, len(CELLS))
        page.wait(lambda: page.all(".noUi-handle", len(CELLS) - 1), "the last slider")
        yield page


def handle(page, n):
    """The handle of the first slider of a cell, in view, and watched."""
    (first, *_) = page.all(".noUi-handle", n)
    page.driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", page.cell(n))
    page.driver.execute_script(WATCH, page.cell(n))
    return first


def seen(page):
    return page.driver.execute_script("return window.seen")


def quiet(page):
    """What was seen when nothing has changed for half a second."""
    before, found = None, seen(page)
    while before is None or len(before["changes"]) < len(found["changes"]):
        time.sleep(0.5)
        before, found = found, seen(page)
    return found


def test_a_screen_reader_hears_the_name_and_the_value_of_every_slider(page):
    from selenium.webdriver import Keys

    labels = """return [...document.querySelectorAll('[role=slider]')].map(h => [
        h.getAttribute('aria-label'), h.getAttribute('aria-valuetext'),
        h.closest('.newton-euler-slider').querySelector('.newton-euler-value').textContent])"""

    def announced():
        found = page.driver.execute_script(labels)
        return all(f"{name} = {value}" == shown for name, value, shown in found) and found

    before = page.wait(announced, "names and values")
    page.all(".noUi-handle", 0)[0].send_keys(Keys.ARROW_RIGHT)
    after = page.wait(lambda: announced() != before and announced(), "the next one")
    assert after[0] != before[0]
    assert after[1:] == before[1:]


each_figure = pytest.mark.parametrize("n", range(len(FIGURES)), ids=list(FIGURES))


@pytest.mark.benchmark
@each_figure
def test_every_key_moves_the_picture_soon_and_without_flicker(page, n):
    from selenium.webdriver import Keys

    first = handle(page, n)
    page.driver.execute_script("arguments[0].focus()", first)
    for count in range(1, 9):
        page.press(Keys.ARROW_RIGHT)
        page.wait(lambda count=count: len(seen(page)["changes"]) >= count, "the next picture")
    found = quiet(page)
    times = [b - a for a, b in zip(found["events"], found["changes"], strict=True)]
    printed = f"median {statistics.median(times):.0f} ms, longest {max(times):.0f} ms"
    print(f"\n{list(FIGURES)[n]}: from a key to the changed picture {printed}")
    assert found["blank"] == 0
    assert statistics.median(times) < SOON_MS


@pytest.mark.benchmark
@each_figure
def test_a_fast_drag_moves_the_picture_and_leaves_no_queue(page, n):
    from selenium.webdriver import ActionChains

    first = handle(page, n)
    drag = ActionChains(page.driver, duration=0).click_and_hold(first)
    for _ in range(60):
        drag = drag.move_by_offset(2, 0)
    for _ in range(60):
        drag = drag.move_by_offset(-2, 0)
    drag.release().perform()
    found = quiet(page)
    rest = found["changes"][-1] - found["events"][-1]
    seconds = (found["events"][-1] - found["events"][0]) / 1000
    print(
        f"\n{list(FIGURES)[n]}: {len(found['events'])} moves of the mouse in {seconds:.2f} s, "
        f"{len(found['changes'])} pictures, the last {rest:.0f} ms after the last move"
    )
    assert len(found["changes"]) > 3  # while it is dragged
    assert rest < SOON_MS
    assert found["blank"] == 0


def test_labels_have_greek_letters_and_units_and_pictures_their_words(page):
    page.says(1, "θ = ", "°")
    for n, (figure, _) in enumerate(FIGURES.values()):
        (image,) = page.all(".jp-OutputArea-output img", n)
        words = figure.options["alt"]
        assert callable(words) or image.get_attribute("alt").startswith(f"{words} (")


def test_the_console_has_no_error_of_ours(page):
    assert page.errors() == []
