"""The engine in the page: Python in a worker, which comes back without a network."""

import time

import pytest

from newton_euler import __version__
from tests.website.browser import served, wait

pytestmark = pytest.mark.integration
CALL = """
const [name, args, done] = arguments;
engine.call(name, args).then((value) => done({value}), (error) => done({error: error.message}));
"""


def called(driver, name, **arguments):
    """What a function of newton_euler/browser gives to the page: {"value": …} or {"error": words}."""
    return driver.execute_async_script(CALL, name, arguments)


def test_the_engine_loads_when_asked_answers_in_words_and_comes_back_offline(
    site, driver, tmp_path
):
    if not (site / "engine").exists():
        pytest.skip("npm does not reach Pyodide")
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
    driver.get(page)
    assert called(driver, "about.version")["value"]["engine"] == __version__
