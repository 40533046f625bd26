"""player.html in a real browser, as a file without a kernel or a network: its speed, reduced motion
and print.
"""

import time

import pytest

from tests.jupyterlab import chromium
from tests.newton_euler.drawing.test_player import film

pytestmark = [pytest.mark.slow, pytest.mark.integration]


@pytest.fixture(scope="module")
def driver(tmp_path_factory):
    with chromium(tmp_path_factory.mktemp("profile")) as driver:
        yield driver


@pytest.fixture
def page(tmp_path):
    film(tuple(n / 10 for n in range(101)), speed=2.0).save(tmp_path / "film.html")
    return f"file://{tmp_path}/film.html"


def reads(driver):
    """The time of the motion and the time of the clock, in seconds."""
    return driver.execute_script(
        "return [parseFloat(document.querySelector('output').textContent.slice(4)), "
        "performance.now() / 1000]"
    )


def test_a_film_runs_at_its_speed(driver, page):
    driver.get(page)
    t0, clock0 = reads(driver)
    time.sleep(2)
    t1, clock1 = reads(driver)
    assert (t1 - t0) / (clock1 - clock0) == pytest.approx(2.0, rel=0.2)
    assert driver.get_log("browser") == []


def test_a_film_waits_where_reduced_motion_is_preferred_and_is_printed_without_controls(
    driver, page
):
    feature = {"name": "prefers-reduced-motion", "value": "reduce"}
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [feature]})
    driver.get(page)
    time.sleep(0.5)
    assert reads(driver)[0] == 0
    driver.find_element("css selector", "button").click()
    time.sleep(0.5)
    assert reads(driver)[0] > 0
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})
    driver.get(page)
    time.sleep(0.5)
    assert reads(driver)[0] > 0
    driver.execute_cdp_cmd("Page.printToPDF", {})
    assert reads(driver)[0] == 0
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    assert not driver.find_element("css selector", "button").is_displayed()
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
