"""Problems worked on their pages, in a real browser: by keyboard alone, on a phone."""

import time

import pytest

from exercises.catalogue import problem
from exercises.catalogue.variants import flat
from grader.practice.twins import twin
from newton_euler.classroom.practising.progress import Progress
from tests.website.browser import complaints, emulated, wait
from website.build import CACHE
from website.npm import Package

pytestmark = pytest.mark.integration

FIVE = "4/1", "4/2", "4/7", "4/12", "4/16"
PHONE = {"width": 390, "height": 844, "deviceScaleFactor": 1, "mobile": True}
AXE = Package(
    "axe-core",
    "4.14.1",
    "sha512-FHfa+lmNjQZfJz1q8wKqIDwC6DExcHt/pkjNQb09a3NPjCKg2rhu5qb2S4r76ASyFNNtuFooJpZe37OgudVGtQ==",
)
FAULTS = """
const done = arguments[0];
axe.run(document, {resultTypes: ["violations"]}).then(({violations}) => done(violations
  .filter((v) => ["serious", "critical"].includes(v.impact))
  .map((v) => `${v.id}: ${v.nodes.slice(0, 3).map((n) => n.target).join(" ")}`)));
"""
LEFT, TOUCHED = "document.activeElement", "document.querySelector('.practice').dataset.ready"


@pytest.fixture(scope="module")
def phone(site, driver):
    if not (site / "practice").exists():
        pytest.skip("npm does not reach Pyodide")
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", PHONE)
    yield driver
    driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def press(driver, *keys):
    from selenium.webdriver import ActionChains

    ActionChains(driver).send_keys(*keys).perform()


def tab_to(driver, selector):
    """Press Tab until what the selector says has the focus."""
    from selenium.webdriver import Keys

    for _ in range(300):
        press(driver, Keys.TAB)
        if driver.execute_script("return document.activeElement.matches(arguments[0])", selector):
            return
    pytest.fail(f"Tab does not reach {selector}")


def typed(driver, key, texts, check=True):
    """Type into the fields of a quantity and press Enter; returns the verdict."""
    from selenium.webdriver import ActionChains, Keys

    box = f"fieldset[data-key='{key}']"
    driver.execute_script(f'document.querySelector("{box}").scrollIntoView()')
    for n, text in enumerate(texts):
        if driver.execute_script(f'return document.querySelector("{box} select") !== null'):
            tab_to(driver, f"{box} select")
            press(driver, text)
            continue
        tab_to(driver, f"{box} input:nth-of-type({n + 1})")
        ActionChains(driver).key_down(Keys.CONTROL).send_keys("a").key_up(Keys.CONTROL).perform()
        press(driver, text)
    if not check:
        return ""
    press(driver, Keys.ENTER)
    verdict = f'document.querySelector("{box} .verdict").textContent'
    return wait(driver, verdict, f"a verdict on {key}")


def right(number):
    """{answer: its components as text} for the first numbers."""
    p = twin(problem(number))
    found = p.solve(p.book_values)
    return {k: [x] if isinstance(x, str) else [f"{float(part):.6g}" for part in flat(x)]
            for k, x in found.items()}  # fmt: skip


def test_five_problems_are_worked_by_keyboard_alone_and_their_progress_is_taken_along(
    address, phone, tmp_path
):
    from selenium.webdriver import Keys

    save = {"behavior": "allow", "downloadPath": str(tmp_path)}
    phone.execute_cdp_cmd("Browser.setDownloadBehavior", save)
    for number in FIVE:
        phone.get(f"{address}/problems/{number.replace('/', '-')}.html")
        if number == FIVE[0]:
            tab_to(phone, ".practice button")
            press(phone, Keys.ENTER)
        wait(phone, TOUCHED, "the form")
        answers = right(number)
        for key, texts in answers.items():
            wrong = [f"{1.37 * float(x) + 0.11:.6g}" for x in texts]
            assert typed(phone, key, wrong).startswith("✗"), (number, key)
        for key, texts in answers.items():
            typed(phone, key, texts, check=False)
        press(phone, Keys.ENTER)
        wait(phone, "document.querySelector('.practice .next').textContent", "what to do next")
        verdicts = "[...document.querySelectorAll('.practice > div > form .verdict')].map(v => v.textContent[0])"
        assert set(phone.execute_script(f"return {verdicts}")) == {"✓"}, number
        assert phone.execute_script("return document.documentElement.scrollWidth") <= PHONE["width"]
    tab_to(phone, "details.steps > summary")
    press(phone, Keys.ENTER)
    assert typed(phone, "omega_CD", ["0.45", "0", "0.6"]).startswith("✗")
    status = "document.querySelector('.practice [role=status]').textContent"
    assert "omega_CD: not right" in wait(phone, status, "a sentence in the live region")
    assert typed(phone, "omega_CD", ["-b_dot", "0", "omega"]) == "✓ right"
    for summary in ("Your progress",):
        tab_to(phone, ".practice > div > details:last-of-type > summary")
        press(phone, Keys.ENTER)
        assert phone.execute_script("return document.activeElement.textContent") == summary
    tab_to(phone, "button.export")
    press(phone, Keys.ENTER)
    file = tmp_path / "practice.progress.json"
    end = time.monotonic() + 30
    while not file.exists() and time.monotonic() < end:
        time.sleep(0.1)
    kept = Progress(file)  # as a notebook reads it
    for number in FIVE:
        assert kept.counts(number)["right"] >= len(right(number)), number
    assert kept.note == ""
    assert complaints(phone) == []


def test_new_numbers_hints_and_solution_are_shown_typeset(address, phone):
    phone.get(f"{address}/problems/4-16.html")
    phone.execute_script(
        "if (!localStorage['newton-euler.practises']) document.querySelector('.practice button').click()"
    )
    wait(phone, TOUCHED, "the form")
    before = phone.execute_script("return document.querySelector('.statement').textContent")
    phone.execute_script("document.querySelector('.sets button').click()")
    wait(phone, "document.querySelector('.sets').textContent.includes('Numbers 2')", "new numbers")
    assert phone.execute_script("return document.querySelector('.statement').textContent") != before
    image = "document.querySelector('.statement img')"
    assert wait(phone, f"{image}.naturalWidth > 0 && {image}.alt", "the figure").startswith(
        "Figure: "
    )
    for button in phone.find_elements("css selector", ".help button")[:2]:
        phone.execute_script("arguments[0].click()", button)
    solved = "document.querySelectorAll('.practice .said')[1]"
    wait(phone, f"{solved}.querySelectorAll('mjx-container').length > 20", "the solution")
    assert (
        phone.execute_script(
            f"return {solved}.querySelectorAll('mjx-merror, [data-mml-node=merror]').length"
        )
        == 0
    )
    assert phone.execute_script("return document.documentElement.scrollWidth") <= PHONE["width"]


def test_without_javascript_a_problem_page_is_complete(site):
    text = (site / "problems" / "4-16.html").read_text("utf-8")
    assert "Elbow arm on a turning shaft" in text
    assert "4-16.png" in text
    assert '<div class="practice" data-problem="4/16" data-file="ch04" data-engine hidden>' in text


def test_the_first_page_moves_answers_and_is_light(address, phone):
    phone.get(f"{address}/index.html")
    sizes = "performance.getEntries().filter(e => e.decodedBodySize).reduce((all, e) => all + e.decodedBodySize, 0)"
    assert phone.execute_script(f"return {sizes}") < 300_000
    shown = "[...document.querySelectorAll('.landing .figure > div')].findIndex(f => !f.hidden)"
    slider = "const s = document.querySelector('#turn'); s.value = arguments[0]; s.dispatchEvent(new Event('input'));"
    for n in (0, 7):
        phone.execute_script(slider, n)
        assert phone.execute_script(f"return {shown}") == n
    ask = """
    const form = document.querySelector("form.taste");
    form.querySelector("input").value = arguments[0];
    form.requestSubmit();
    return form.querySelector("[role=status]").textContent;
    """
    assert phone.execute_script(ask, "-7.638") == "✓ right"
    assert "Coriolis term 2 omega x v_r with the opposite sign" in phone.execute_script(ask, "7.64")
    assert "leaves out the Coriolis term" in phone.execute_script(ask, "0")
    assert phone.execute_script(ask, "<b>x</b>") == "Write a number, as -2.5."
    assert complaints(phone) == []


def test_axe_finds_nothing_serious_in_light_or_dark(site, address, phone):
    found = AXE.files(CACHE / "npm", "axe.min.js")
    if not found:
        pytest.skip("npm does not reach axe-core")
    faults = {}
    for page in (
        "index.html",
        "problems/4-16.html",
        "problems/ch04.html",
        "chapters/ch04_relative_motion.html",
    ):
        phone.get(f"{address}/{page}")
        if page == "problems/4-16.html":
            wait(phone, TOUCHED, "the form")
        phone.execute_script(found["axe.min.js"].decode())
        for theme in ("light", "dark"):
            emulated(phone, theme)
            if wrong := phone.execute_async_script(FAULTS):
                faults[page, theme] = wrong
    emulated(phone)
    assert faults == {}
