"""Every page of the site in a real browser: on a screen, on a phone and on paper."""

import base64
import json
import time

import pytest

from tests.website.browser import complaints, emulated, js, requests, script, text, wait

pytestmark = pytest.mark.integration

PHONE = {"width": 360, "height": 740, "deviceScaleFactor": 1, "mobile": True}
LOOK = script("faults_of_a_page")
WIDER = script("wider_than_the_page")


def addresses(site, address, part):
    """Those of one page in ``part``; of the 289 of single problems, which are alike, one in thirty
    as often.
    """
    own = sorted(site.glob("problems/*-*.html"))
    others = sorted({*site.rglob("*.html")} - {*own})
    return [f"{address}/{path.relative_to(site)}" for path in others[::part] + own[:: 30 * part]]


@pytest.mark.parametrize("part", [16, pytest.param(1, marks=pytest.mark.slow)])
def test_each_page_is_right_loads_nothing_from_elsewhere_and_fits_a_phone(
    site, address, driver, part
):
    wrong, asked = {}, set()
    for url in addresses(site, address, part):
        driver.get(url)
        found = driver.execute_async_script(LOOK) + complaints(driver)
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", PHONE)
        found += driver.execute_script(WIDER)
        driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
        asked |= set(requests(driver))
        if found:
            wrong[url] = found[:5]
    assert wrong == {}
    # chrome: the browser's own first page
    own = f"{address}/", "data:", "blob:", "chrome:", "chrome-untrusted:"
    away = [u for u in asked if not u.startswith(own)]
    assert away == []


@pytest.mark.parametrize("kind", ["server", "file"])
def test_a_search_finds_a_word(site, address, driver, kind):
    driver.get(f"{address if kind == 'server' else site.as_uri()}/search.html?q=Coriolis")
    results = "[...document.querySelectorAll('#search-results li')]"
    wait(driver, "document.body.textContent.includes('Search finished')", "the end of the search")
    if kind == "server":  # a page opened as a file cannot read others
        shown = "li.matches('.kind-object') || li.querySelector('.context')"
        wait(driver, f"{results}.every((li) => {shown})", "an excerpt of each page")
    assert complaints(driver) == []
    link = f"{results}[0].querySelector('a')"  # what is taught comes before functions
    assert "/chapters/" in js(driver, f"{link}.href")
    driver.execute_script(f"{link}.click()")
    wait(driver, "document.querySelector('article h1')", "the page that was found")
    assert complaints(driver) == []


def test_the_address_of_a_section_leads_to_it(address, driver):
    driver.get(f"{address}/chapters/ch04_relative_motion.html#section-4-10")
    place = "document.getElementById('section-4-10').getBoundingClientRect().top"
    assert wait(driver, f"Math.abs({place}) < innerHeight / 2", "section 4.10")
    assert js(driver, "scrollY > innerHeight")


def sample(driver, address):
    driver.get(f"{address}/chapters/sample.html")
    assert driver.execute_async_script(LOOK) == []


def test_a_film_plays_at_its_button_and_waits_where_no_motion_is_wanted(driver, address):
    emulated(driver, reduced="reduce")
    sample(driver, address)
    film = "document.querySelector('.output [id^=motion-]')"
    button, picture = f"{film}.querySelector('button')", f"{film}.querySelector('img')"
    assert js(driver, f"{button}.textContent") == "Play"
    still = js(driver, f"{picture}.src")
    time.sleep(0.4)
    assert js(driver, f"{picture}.src") == still
    driver.execute_script(f"{button}.click()")
    wait(driver, f"{picture}.src !== {json.dumps(still)}", "another picture")
    assert js(driver, f"{picture}.alt") == "A pendulum swings."
    emulated(driver)
    assert complaints(driver) == []


def test_answers_and_code_are_folded_with_their_formulas_and_a_slider_is_not_shown(driver, address):
    sample(driver, address)
    folded = "document.querySelector('article details')"
    assert js(driver, f"{folded}.open") is False
    assert js(driver, f"{folded}.querySelectorAll('summary mjx-container').length") == 1
    assert js(driver, f"{folded}.querySelectorAll('li').length") == 2
    tags = "[...document.querySelectorAll('article .math')].filter(f => /[(]4[.]1[38][)]/.test(f.querySelector('mjx-assistive-mml').textContent)).length"
    assert js(driver, tags) == 2
    assert "def swinging" in text(driver, "details.hide")
    outputs = "[...document.querySelectorAll('.cell_output')].map(e => e.textContent).join()"
    assert "FloatSlider(" not in js(driver, outputs)
    alts = js(driver, "[...document.images].map(i => i.alt)")
    assert "Figure 1. A straight line from 0 to 1." in alts


def test_on_paper_all_is_unfolded_and_the_navigation_is_gone(driver, address):
    sample(driver, address)
    paper = driver.execute_cdp_cmd("Page.printToPDF", {"printBackground": False})
    assert len(base64.b64decode(paper["data"])) > 10_000
    assert js(driver, "[...document.querySelectorAll('details')].every(d => d.open)")
    emulated(driver, media="print")
    shown = "[...document.querySelectorAll('.sidebar-drawer, .toc-drawer, .mobile-header, .controls, .related-pages')].filter(e => e.offsetParent).length"
    assert js(driver, shown) == 0
    emulated(driver)


def test_a_page_follows_the_readers_system_or_the_switch_and_paper_is_light(driver, address):
    dark, white = "rgb(19, 20, 22)", "rgb(255, 255, 255)"
    colours = """const fill = document.querySelector('.landing svg.sketch > rect');
      return [getComputedStyle(document.body).backgroundColor, getComputedStyle(fill).fill];"""
    driver.get(f"{address}/index.html")
    assert js(driver, "document.documentElement.lang") == "en"
    assert driver.execute_script(colours) == [white, white]
    emulated(driver, "dark")
    assert driver.execute_script(colours) == [dark, dark]
    emulated(driver, "dark", "print")
    assert driver.execute_script(colours) == [white, white]
    emulated(driver, "dark")
    driver.find_element("css selector", ".theme-toggle-content button").click()
    assert driver.execute_script(colours) == [white, white]
    assert js(driver, "localStorage.theme") == "light"
    driver.execute_script("localStorage.removeItem('theme')")
    emulated(driver)


def test_problems_are_chosen_by_what_is_asked_for(driver, address):
    driver.get(f"{address}/problems/index.html")
    wait(driver, "document.querySelector('p.chosen').textContent", "the number of problems")
    ask = """
    const form = document.querySelector("form.choose");
    for (const [name, text] of Object.entries(arguments[0])) form.elements[name].value = text;
    form.dispatchEvent(new Event("input"));
    return [...document.querySelectorAll("table.problems tbody tr")].filter(r => !r.hidden)
      .map(r => r.querySelector("a").textContent);
    """
    found = driver.execute_script(ask, {"words": "elbow arm", "section": "4"})
    assert "4/16" in found
    assert all(number.startswith("4/") for number in found)
    assert "4/16" not in driver.execute_script(ask, {"equation": "4.18", "kind": "number"})
    assert complaints(driver) == []


def test_a_prediction_is_made_opens_its_meaning_and_is_counted_and_asked_again(driver, address):
    sample(driver, address)
    driver.execute_script("localStorage.clear()")
    sample(driver, address)
    assert text(driver, ".prediction-tally") == "0 of 3 predictions made."
    choices = "[...document.querySelector('.prediction').querySelectorAll('.choice')]"
    driver.execute_script(f"{choices}[0].querySelector('summary').click()")
    assert js(driver, f"{choices}.map(c => c.open)") == [True, True]
    form = "document.querySelector('.prediction form')"
    driver.execute_script(f"{form}.firstChild.value = '4 m'; {form}.requestSubmit()")
    assert "Twice too many" in text(driver, ".mistake.chosen")
    sample(driver, address)  # it is kept
    assert text(driver, ".prediction-tally") == "2 of 3 predictions made: 0 right, 2 wrong."
    assert js(driver, f"{choices}[0].matches('.chosen')")
    assert len(driver.find_elements("css selector", ".predictions-again .prediction")) == 2
    assert complaints(driver) == []
