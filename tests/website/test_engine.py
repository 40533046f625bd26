"""The engine in the page: Python in a worker, figures that move, cells that run, all of it again
without a network.
"""

import json
import time

import pytest

from newton_euler import __version__
from tests.website.browser import LONG, complaints, served, wait

pytestmark = pytest.mark.integration
CALL = """
const [name, args, done] = arguments;
engine.call(name, args).then((value) => done({value}), (error) => done({error: error.message}));
"""
# move the first slider of a figure
DRAG = """
const holder = document.querySelectorAll("[data-moving]")[arguments[0]], input = holder.querySelector("input");
input.value = arguments[1] === "end" ? input.max : +input.value + +input.step * (+input.value < +input.max ? 1 : -1);
for (const kind of ["input", "change"]) input.dispatchEvent(new Event(kind, {bubbles: true}));
return [JSON.parse(holder.dataset.moving).sliders[0].name, +input.value];
"""
# run cells by their buttons: [number, text built before, text now, error] of those that print
RUN = """
const [skipped, done] = arguments, left = new RegExp(skipped), found = [];
const textOf = (cell) => [...cell.querySelectorAll(".cell_output .stream pre")].map((e) => e.textContent).join("");
(async () => {
  for (const input of document.querySelectorAll(".cell_input")) {
    const cell = input.closest(".cell"), code = input.querySelector("pre").textContent;
    if (left.test(code)) continue;
    const before = textOf(cell), button = input.querySelector(".run button");
    button.click();
    while (button.textContent !== "Run") await new Promise((resolve) => setTimeout(resolve, 5));
    const error = cell.querySelector(".output.error");
    found.push([moving.numberOf(input), before, textOf(cell), error ? error.textContent : ""]);
  }
  done(found);
})();
"""
ARRAYS = r"\bnp\.|numpy|sympy|mpmath|plt\.|_film\(|show_chart|compare\("


@pytest.fixture(autouse=True)
def _with_engine(site):
    if not (site / "engine").exists():
        pytest.skip("npm does not reach Pyodide")


def called(driver, name, **arguments):
    """What a function of newton_euler/browser gives to the page: {"value": …} or {"error": words}."""
    return driver.execute_async_script(CALL, name, arguments)


def drag(driver, figure=0, where="a step"):
    """Move the first slider of a figure; whether the engine draws it, without arrays and plots."""
    name, x = driver.execute_script(DRAG, figure, where)
    holder = f"document.querySelectorAll('[data-moving]')[{figure}]"
    wait(driver, f"{holder}.dataset.drawn || {holder}.dataset.failed", "a picture")
    if failed := driver.execute_script(f"return {holder}.dataset.failed"):
        assert "this needs" in failed
        return False
    assert json.loads(driver.execute_script(f"return {holder}.dataset.drawn"))[name] == x
    label = f"{holder}.querySelector('.stage > svg[role=img]').getAttribute('aria-label')"
    assert len(driver.execute_script(f"return {label}").split()) >= 8
    assert " = " in driver.execute_script(f"return {holder}.querySelector('.said').textContent")
    return True


def test_the_engine_answers_in_words_and_comes_back_offline_with_its_figures_and_cells(
    site, driver, tmp_path
):
    (tmp_path / "course").symlink_to(site)  # below the top of the server, as on GitHub
    times = {}
    with served(tmp_path) as address:
        page = f"{address}/course/chapters/ch04_relative_motion.html"
        for visit in ("cold", "warm"):
            driver.get(page)
            assert driver.execute_script("let now; engine.progress(p => now = p); return now") == 0
            times[visit] = -time.perf_counter()
            assert called(driver, "about.version")["value"]["engine"] == __version__
            times[visit] += time.perf_counter()
        print({visit: f"{seconds:.1f} s" for visit, seconds in times.items()})
        assert called(driver, "about.verse") == {
            "error": "the engine has no function about.verse for pages"
        }
        assert "argument" in called(driver, "about.version", of=1)["error"]
        wait(driver, "!!navigator.serviceWorker.controller", "the service worker")
        assert complaints(driver) == []
    driver.get(page)
    assert drag(driver)
    assert "error" not in called(driver, "cells.run", page="a", cells=["1 + 1"], number=0)


def test_a_slider_of_each_chapter_moves_its_figure_and_until_then_an_end_answers(
    site, driver, address
):
    moved, still = [], []
    for path in sorted(site.glob("chapters/*.html")):
        driver.get(f"{address}/chapters/{path.name}")
        count = driver.execute_script("return document.querySelectorAll('[data-moving]').length")
        if count:
            drawn = any(drag(driver, n, "end" if moved else "a step") for n in range(count))
            (moved if drawn else still).append(path.stem)
    assert complaints(driver) == []
    assert (bool(moved), still) == (True, [])


def test_the_cells_of_a_chapter_run_by_their_buttons_and_print_what_was_built(driver, address):
    driver.get(f"{address}/chapters/ch01_basic_concepts.html")
    driver.set_script_timeout(2 * LONG)
    found = driver.execute_async_script(RUN, ARRAYS)
    assert len(found) > 15
    assert [x for x in found if x[1] != x[2] or x[3]] == []


@pytest.mark.slow  # minutes
def test_every_cell_of_every_chapter_prints_what_was_built_or_says_what_it_needs(
    site, driver, address
):
    driver.set_script_timeout(6 * LONG)
    other = {}
    for path in sorted(site.glob("chapters/*.html")):
        driver.get(f"{address}/chapters/{path.name}")
        found = driver.execute_async_script(RUN, ARRAYS)
        ran = [x for x in found if "this needs" not in x[3]]
        if wrong := [x for x in ran if x[1] != x[2] or x[3]]:
            other[path.stem] = wrong
    assert other == {}
