"""Problems worked on their pages, in a real browser: by keyboard alone, on a phone."""

import shutil
from contextlib import contextmanager

import pytest

from grader.assignment.notebook import slug
from newton_euler.classroom.practising.collection import Practice
from newton_euler.classroom.practising.files import PracticeFile
from newton_euler.classroom.practising.progress import Progress
from tests.jupyterlab import Page
from tests.website.browser import complaints, emulated, js, requests, script, text, wait
from tests.website.test_on_a_page import rewritten
from website.npm import Package

webdriver = pytest.importorskip("selenium.webdriver", reason="selenium is not installed")
ActionChains, Keys = webdriver.ActionChains, webdriver.Keys
pytestmark = pytest.mark.integration

MORE_WORKED = "4/1", "4/2", "4/7", "4/12", "4/16"
PHONE = {"width": 390, "height": 844, "deviceScaleFactor": 1, "mobile": True}
AXE = Package(
    "axe-core",
    "4.14.1",
    "sha512-FHfa+lmNjQZfJz1q8wKqIDwC6DExcHt/pkjNQb09a3NPjCKg2rhu5qb2S4r76ASyFNNtuFooJpZe37OgudVGtQ==",
)
FAULTS = script("faults_for_axe")
READY = "document.querySelector('.practice').dataset.ready"


@pytest.fixture(scope="module")
def phone(site, driver):
    if not (site / "practice").exists():
        pytest.skip("npm cannot reach Pyodide")
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", PHONE)
    yield driver
    driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def practise(driver, page):
    """Open the form of a problem page, whether or not anybody has practised before."""
    driver.get(page)
    driver.execute_script(
        "if (!localStorage['newton-euler.practises']) document.querySelector('.practice button').click()"
    )
    wait(driver, READY, "the form")


def tab_to(driver, selector):
    """Press Tab, or Shift and Tab where one is behind it, until what the selector says has the
    focus.
    """
    place = "document.querySelector(arguments[0])?.compareDocumentPosition(document.activeElement)"
    back = js(driver, f"!!({place} & Node.DOCUMENT_POSITION_FOLLOWING)", selector)
    for _ in range(300):
        if js(driver, "document.activeElement.matches(arguments[0])", selector):
            return
        Page(driver).press(Keys.TAB, shift=back)
    pytest.fail(f"Tab does not reach {selector}")


def typed(driver, key, texts, check=True):
    """Type into the fields of a quantity and press Enter; returns the verdict."""
    box = f"fieldset[data-key='{key}']"
    tab_to(driver, f"{box} :is(select, input:nth-of-type(1))")
    keys = ActionChains(driver)
    for n, part in enumerate(texts):
        keys.send_keys(Keys.TAB * bool(n)).key_down(Keys.CONTROL).send_keys("a")
        keys.key_up(Keys.CONTROL).send_keys(part)
    keys.send_keys(Keys.ENTER * check).perform()
    if not check:
        return ""
    verdict = f'document.querySelector("{box} .verdict").textContent'
    return wait(driver, verdict, f"a verdict on {key}")


def steps_and_answers(site, number):
    """{quantity: its components as text} for the first numbers of a problem, of steps and of
    answers.
    """
    p = Practice([PracticeFile(site / "practice" / "ch04.practice")], Progress(None))[number]
    found = {k: [x] if isinstance(x, str) else x for k, x in p.solved.items()}
    texts = {
        k: [x if isinstance(x, str) else f"{x:.6g}" for x in parts] for k, parts in found.items()
    }
    return ({k: texts[k] for k in names} for names in (p.steps, p.answers))


@pytest.mark.slow
@pytest.mark.parametrize("numbers", [("4/16",), MORE_WORKED])
def test_problems_are_worked_by_keyboard_and_taken_along(site, address, phone, tmp_path, numbers):
    save = {"behavior": "allow", "downloadPath": str(tmp_path)}
    phone.execute_cdp_cmd("Browser.setDownloadBehavior", save)
    taken = {}
    for number in numbers:
        phone.get(f"{address}/problems/{slug(number)}.html")
        tab_to(phone, ".skip-to-content")
        Page(phone).press(Keys.ENTER)
        if number == numbers[0]:
            tab_to(phone, ".practice button")
            Page(phone).press(Keys.ENTER)
        wait(phone, READY, "the form")
        steps, answers = steps_and_answers(site, number)
        wrong = lambda texts: [f"{1.37 * float(x) + 0.11:.6g}" for x in texts]
        for key, texts in answers.items():
            assert typed(phone, key, wrong(texts)).startswith("✗"), (number, key)
        tab_to(phone, "details.steps > summary")
        Page(phone).press(Keys.ENTER)
        for key, texts in steps.items():
            assert typed(phone, key, wrong(texts)).startswith("✗"), (number, key)
            assert typed(phone, key, texts).startswith("✓"), (number, key)
        for key, texts in answers.items():
            typed(phone, key, texts, check=False)
        Page(phone).press(Keys.ENTER)
        wait(phone, "document.querySelector('.practice .next').textContent", "what to do next")
        verdicts = "[...document.querySelectorAll('.practice > div > form .verdict')].map(v => v.textContent[0])"
        assert set(js(phone, verdicts)) == {"✓"}, number
        assert js(phone, "document.documentElement.scrollWidth") <= PHONE["width"]
        taken[number] = len(steps) + len(answers)
    assert typed(phone, "omega_CD", ["0.45", "0", "0.6"]).startswith("✗")
    status = "document.querySelector('.practice [role=status]').textContent"
    assert "omega_CD: not right" in wait(phone, status, "a sentence in the live region")
    assert typed(phone, "omega_CD", ["-b_dot", "0", "omega"]) == "✓ right"
    tab_to(phone, ".practice > div > details:last-of-type > summary")
    Page(phone).press(Keys.ENTER)
    assert js(phone, "document.activeElement.textContent") == "Your progress"
    tab_to(phone, "button.export")
    Page(phone).press(Keys.ENTER)
    file = tmp_path / "practice.progress.json"
    Page(phone).wait(file.exists, "the file of progress")
    kept = Progress(file)  # as a notebook reads it
    assert all(kept.counts(number)["right"] >= count for number, count in taken.items())
    assert kept.note == ""
    assert complaints(phone) == []


RING = """
const {outlineStyle, outlineWidth} = getComputedStyle(document.activeElement);
return outlineStyle !== "none" && parseFloat(outlineWidth) > 0;
"""


@pytest.mark.parametrize("by_a_chapter", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_from_the_first_page_to_a_solution_by_keyboard_and_where_one_is_can_be_seen(
    address, phone, by_a_chapter
):
    def go(selector, key, seen):
        tab_to(phone, selector)
        assert phone.execute_script(RING), selector
        Page(phone).press(key)
        wait(phone, seen, selector)

    moving, prediction = "[data-moving] input[type=range]", ".prediction .choice > summary"
    phone.get(f"{address}/index.html")
    go(".landing input[type=range]", Keys.ARROW_RIGHT, "true")
    if by_a_chapter:
        go("article a[href*='ch04_']", Keys.ENTER, f"document.querySelector('{moving}')")
        go(moving, Keys.ARROW_RIGHT, "document.querySelector('[data-moving]').dataset.drawn")
        go(prediction, Keys.ENTER, "document.querySelector('.choice.chosen')")
        phone.back()
    go("form.taste a", Keys.ENTER, "document.querySelector('.practice button')")
    if not js(phone, "localStorage['newton-euler.practises']"):
        go(".practice button", Keys.ENTER, "true")
    wait(phone, READY, "the form")
    output = "document.querySelectorAll('.practice .reply')[{}].textContent"
    go(".help button:nth-of-type(1)", Keys.ENTER, output.format(0))
    go(".help button:nth-of-type(2)", Keys.ENTER, output.format(1))
    go("details.steps > summary", Keys.ENTER, "document.querySelector('details.steps').open")
    assert complaints(phone) == []


@pytest.mark.slow
def test_new_numbers_hints_and_solution_are_shown_typeset(address, phone):
    practise(phone, f"{address}/problems/4-16.html")
    before = text(phone, ".statement")
    phone.execute_script("document.querySelector('.sets button').click()")
    wait(phone, "document.querySelector('.sets').textContent.includes('Numbers 2')", "new numbers")
    assert text(phone, ".statement") != before
    figure = "document.querySelector('.statement > svg.sketch')"
    assert "shaft" in js(phone, f"{figure}.getAttribute('aria-label')")
    phone.execute_script("engine.stop()")  # as where a phone has taken its memory back
    for button in phone.find_elements("css selector", ".help button")[:2]:
        phone.execute_script("arguments[0].click()", button)
    solved = "document.querySelectorAll('.practice .reply')[1]"
    wait(phone, f"{solved}.querySelectorAll('mjx-container').length > 20", "the solution")
    assert js(phone, f"{solved}.querySelectorAll('mjx-merror, [data-mml-node=merror]').length") == 0
    assert js(phone, "document.documentElement.scrollWidth") <= PHONE["width"]
    shown = "engine.call('practice.show', {problem: '4/16'}).then(p => arguments[0](p.number))"
    assert phone.execute_async_script(shown) == 2  # the engine that was started again goes on there


# what would run, lead away or load from elsewhere, if texts and formulas were read as more
ACTS = (
    "<img src='https://elsewhere.example/x.png' onerror='hit=1'><script>hit=2</script> "
    "[a](javascript:hit=3) ![b](https://elsewhere.example/y.png) "
    "$\\require{html}\\href{javascript:hit=4}{c}$ $\\mmlToken{mi}[href='javascript:hit=5']{d}$ "
    "$\\bbox[background: url(https://elsewhere.example/z.png)]{e}$ $\\style{color: red}{f}$"
)
SVG = b"""<svg xmlns="http://www.w3.org/2000/svg" onload="hit=6"><script>hit=7</script>
<image href="https://elsewhere.example/w.png"/></svg>"""
ACTIVE = """[...document.querySelectorAll(
  "article :is(.statement, .practice) :is(script, a, img, image, iframe, [onload], [onerror], [style*=url], [style*=color])")]
  .filter((e) => !e.matches("img[src^='data:']")).map((e) => e.outerHTML.slice(0, 200))"""


# what the page refuses to load
ASKED_ELSEWHERE = """const done = arguments[0];
addEventListener("securitypolicyviolation", ({blockedURI}) => done(blockedURI));
new Image().src = "https://elsewhere.example/v.png";"""


def acting(page):
    """The change that puts ``ACTS`` into every text that readers see."""
    page["preamble"] = page["title"] = page["figure"] = ACTS
    for q in page["quantities"]:
        q["means"] = q["latex"] = ACTS
    for v in page["variants"]:
        v |= {"statement": f"# 4/16\n{ACTS}", "solution": ACTS, "figure": "x.svg"}


@pytest.mark.slow
def test_a_readers_own_practice_file_opens_and_others_are_refused(site, address, phone, tmp_path):
    sound = site / "practice" / "ch04.practice"
    phone.get(f"{address}/problems/own.html")
    chosen = phone.find_element("css selector", ".practice input[type=file]")
    words = "document.querySelector('.practice .verdict.wrong')?.textContent"
    (tmp_path / "code").write_text("import os\nos.abort()")
    with open(tmp_path / "huge", "wb") as file:
        file.truncate(65 << 20)
    for name, reason in {"code": "not a practice file", "huge": "has more than 64 MB"}.items():
        chosen.send_keys(str(tmp_path / name))
        output = wait(phone, f"({words} || '').startsWith('{name}') && {words}", name)
        assert reason in output
        assert not js(phone, "document.querySelector('progress, fieldset')")
    chosen.send_keys(str(shutil.copy(sound, tmp_path / "mine.practice")))
    wait(phone, "document.querySelector('.practice select option[value=\"4/1\"]')", "its problems")
    choose = "const s = document.querySelector('.practice select'); s.value = '4/16'; s.dispatchEvent(new Event('change'));"
    phone.execute_script(choose)
    wait(phone, "document.querySelector('fieldset[data-key=a_D]')", "the form of 4/16")
    assert "Elbow arm" in text(phone, ".statement h2")
    assert js(phone, "!!document.querySelector('.statement > svg.sketch')")
    assert typed(phone, "a_D", ["1", "2", "3"]).startswith("✗")
    assert complaints(phone) == []


def test_texts_of_a_practice_file_are_texts_and_never_run_or_load(site, address, phone, tmp_path):
    sound = site / "practice" / "ch04.practice"
    phone.get(f"{address}/problems/own.html")
    requests(phone)
    file = rewritten(sound, tmp_path / "acts", acting, **{"x.svg": SVG})
    phone.find_element("css selector", ".practice input[type=file]").send_keys(str(file))
    wait(phone, "document.querySelector('fieldset[data-key=a_D] legend mjx-container')", "its form")
    phone.execute_script("document.querySelectorAll('.help button')[1].click()")
    wait(phone, "document.querySelectorAll('.reply')[1].querySelector('mjx-container')", "solution")
    assert "<script>hit=2</script>" in phone.find_element("css selector", ".statement").text
    assert js(phone, ACTIVE) == []
    assert js(phone, "typeof hit") == "undefined"
    assert [url for url in requests(phone) if "elsewhere" in url] == []
    assert complaints(phone) == []
    assert phone.execute_async_script(ASKED_ELSEWHERE) == "https://elsewhere.example/v.png"
    complaints(phone)  # that this was refused


REFUSED = """Object.defineProperty(window, "localStorage", {
  get() { throw new DOMException("refused", "SecurityError"); }});"""


@contextmanager
def from_the_start(driver, script):
    """Pages in which a script runs before all others."""
    added = driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": script})
    yield
    driver.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", added)


@pytest.mark.slow
def test_what_a_browser_has_damaged_or_refuses_or_lacks_stops_nobody(address, phone):
    problem, chapter = f"{address}/problems/4-16.html", f"{address}/chapters/sample.html"
    kept = """for (const name of ["newton-euler.progress", "newton-euler predictions"])
      localStorage[name] = arguments[0];"""
    choose = "document.querySelector('.choice summary').click()"
    chosen = "return document.querySelectorAll('.choice.chosen').length"
    for damaged in ("[[", "5", '"key"', '{"format": 9, "problems": {}}'):
        phone.get(chapter)
        phone.execute_script(kept, damaged)
        phone.get(chapter)
        phone.execute_script(choose)
        assert phone.execute_script(chosen) == 1
    phone.execute_script(kept, damaged)
    practise(phone, problem)
    assert "cannot be read: format 9" in text(phone, ".practice .next")
    assert js(phone, "localStorage['newton-euler.progress.damaged']") == damaged
    assert typed(phone, "v_D", ["1", "2", "3"]).startswith("✗")
    assert complaints(phone) == []
    with from_the_start(phone, REFUSED):
        phone.get(chapter)
        phone.execute_script(choose)
        assert phone.execute_script(chosen) == 1
        phone.get(problem)
        phone.execute_script("document.querySelector('.practice button').click()")
        wait(phone, READY, "the form")
        assert typed(phone, "v_D", ["1", "2", "3"]).startswith("✗")
    complaints(phone)  # of the theme's own script
    with from_the_start(phone, "delete window.WebAssembly"):
        phone.get(problem)
        assert not js(phone, "document.querySelector('.practice').offsetParent")
        phone.get(chapter)
        assert js(phone, "document.querySelectorAll('.run').length") == 0
        assert complaints(phone) == []


def test_the_first_page_moves_answers_and_is_light(address, phone):
    phone.get(f"{address}/index.html")
    sizes = "performance.getEntries().filter(e => e.decodedBodySize).reduce((all, e) => all + e.decodedBodySize, 0)"
    assert js(phone, sizes) < 300_000
    shown = "[...document.querySelectorAll('.landing .figure > div')].findIndex(f => !f.hidden)"
    slider = "const s = document.querySelector('#turn'); s.value = arguments[0]; s.dispatchEvent(new Event('input'));"
    for n in (0, 7):
        phone.execute_script(slider, n)
        assert js(phone, shown) == n
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


def faults_found(driver, only=None):
    """What axe finds serious or critical on the page, by one rule or by all."""
    files = AXE.files("axe.min.js")
    if not files:
        pytest.skip("npm does not reach axe-core")
    driver.execute_script(files["axe.min.js"].decode())
    return driver.execute_async_script(FAULTS, only)


# a page of each kind, and in the slow test every chapter
KINDS = (
    "index.html", "problems/4-16.html", "problems/own.html", "problems/index.html",
    "problems/ch04.html", "chapters/ch01_basic_concepts.html", "chapters/sample.html",
    "reference/kinematics.html", "search.html", "genindex.html",
)  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("slow", [False, True])
def test_axe_finds_nothing_serious_in_light_or_dark(site, address, phone, slow):
    chapters = [str(path.relative_to(site)) for path in sorted(site.glob("chapters/*.html"))]
    faults = {}
    for page in (*KINDS, *chapters) if slow else KINDS[::4]:
        phone.get(f"{address}/{page}")
        if page == "problems/4-16.html":
            practise(phone, f"{address}/{page}")
        for theme, only in (("light", None), ("dark", "color-contrast")):
            emulated(phone, theme)
            if wrong := faults_found(phone, only):
                faults[page, theme] = wrong
    emulated(phone)
    assert faults == {}
