"""The form of a problem in a real JupyterLab, in a real browser, by keyboard."""

import json
import os
import secrets
import shutil
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).parents[4]
CELLS = (
    'from newton_euler.classroom import practice\np = practice("two.practice")["4/16"]\np',
    "p.form()",
    'practice("two.practice")["3/27"].form()',
    'practice("two.practice")',
)
LONG = 60  # seconds: for a busy machine

pytestmark = [pytest.mark.slow, pytest.mark.integration]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A folder with a practice file and a notebook."""
    from exercises.catalogue import problem
    from grader.practice.build import write_practice

    folder = tmp_path_factory.mktemp("lab")
    write_practice(folder / "two.practice", [problem("4/16"), problem("3/27")], 2, workers=1)
    cells = [
        {"cell_type": "code", "id": f"c{n}", "metadata": {}, "execution_count": None,
         "outputs": [], "source": source}
        for n, source in enumerate(CELLS)
    ]  # fmt: skip
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    notebook = {"cells": cells, "metadata": kernel, "nbformat": 4, "nbformat_minor": 5}
    (folder / "practice.ipynb").write_text(json.dumps(notebook))
    return folder


@pytest.fixture(scope="module")
def lab(folder, tmp_path_factory):
    """The address of a notebook in a JupyterLab, which is ended afterwards."""
    pytest.importorskip("jupyterlab", reason="JupyterLab is not installed")
    pytest.importorskip("ipywidgets", reason="ipywidgets is not installed")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    token, own = secrets.token_hex(16), tmp_path_factory.mktemp("jupyter")
    at = f"http://127.0.0.1:{port}"
    command = [
        sys.executable, "-m", "jupyterlab", "--no-browser", "--ip=127.0.0.1", f"--port={port}",
        "--ServerApp.port_retries=0", f"--IdentityProvider.token={token}", "--allow-root",
        f"--ServerApp.root_dir={folder}", "--LabApp.news_url=None",
        "--LabApp.check_for_updates_class=jupyterlab.handlers.announcements.NeverCheckForUpdate",
        "--LabApp.extension_manager=readonly",
    ]  # fmt: skip
    variables = {
        **os.environ, "PYTHONPATH": str(REPOSITORY), "JUPYTER_CONFIG_DIR": str(own / "config"),
        "JUPYTER_RUNTIME_DIR": str(own / "run"), "IPYTHONDIR": str(own / "ipython"),
        "JUPYTERLAB_SETTINGS_DIR": str(own / "settings"), "JUPYTER_NO_CONFIG": "1",
        "JUPYTERLAB_WORKSPACES_DIR": str(own / "workspaces"),
    }  # fmt: skip
    tracker = (
        own / "settings" / "@jupyterlab" / "notebook-extension" / "tracker.jupyterlab-settings"
    )
    tracker.parent.mkdir(parents=True)
    tracker.write_text('{"windowingMode": "none"}')  # all cells are in the page
    with (own / "log").open("w") as log:
        server = subprocess.Popen(command, cwd=folder, env=variables, stdout=log, stderr=log)
    try:
        _wait_for(f"{at}/api/status?token={token}", server, own / "log")
        yield f"{at}/lab/tree/practice.ipynb?token={token}"
    finally:
        server.terminate()  # its kernels end with it
        try:
            server.wait(60)
        except subprocess.TimeoutExpired:
            server.kill()
            server.wait()


def _wait_for(address, server, log):
    end = time.monotonic() + LONG
    while time.monotonic() < end and server.poll() is None:
        try:
            urllib.request.urlopen(address, timeout=5).close()
            return
        except (urllib.error.URLError, OSError):
            time.sleep(0.3)
    pytest.fail(f"JupyterLab did not start:\n{log.read_text()[-2000:]}")


@pytest.fixture(scope="module")
def driver(tmp_path_factory):
    """A browser with a profile of its own."""
    webdriver = pytest.importorskip("selenium.webdriver", reason="selenium is not installed")
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    if not browser or not shutil.which("chromedriver"):
        pytest.skip("chromium or chromedriver is not installed")
    options = webdriver.ChromeOptions()
    options.binary_location = browser
    for argument in (
        "--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking",
        "--disable-component-update", "--disable-sync", "--no-first-run",
        "--disable-dev-shm-usage", "--window-size=1200,2200", "--lang=en",
        f"--user-data-dir={tmp_path_factory.mktemp('chromium')}",
    ):  # fmt: skip
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    service = webdriver.ChromeService(executable_path=shutil.which("chromedriver"))
    driver = webdriver.Chrome(options=options, service=service)
    yield driver
    driver.quit()


class Page:
    """A notebook as a student sees it, and the keys that they press."""

    def __init__(self, driver):
        self.driver = driver

    def wait(self, condition, what):
        """What a condition gives as soon as it is true."""
        from selenium.common.exceptions import StaleElementReferenceException

        end = time.monotonic() + LONG
        while time.monotonic() < end:
            try:
                if found := condition():
                    return found
            except StaleElementReferenceException:
                pass
            time.sleep(0.02)
        self.shoot("failed")
        return pytest.fail(f"not seen within {LONG} s: {what}")

    def shoot(self, name):
        """A picture of the page, in the folder SCREENSHOTS if that is set."""
        if folder := os.environ.get("SCREENSHOTS"):
            self.driver.save_screenshot(f"{folder}/{name}.png")

    def all(self, css, n=None):
        """The elements of a selector, of the cell ``n`` where one is said."""
        inside = self.driver if n is None else self.cell(n)
        return inside.find_elements("css selector", css)

    def cell(self, n):
        """The cell ``n``."""
        return self.driver.find_elements("css selector", ".jp-Notebook .jp-CodeCell")[n]

    def says(self, n, *words):
        """Wait until all words stand in a cell; returns its text."""

        def said():
            text = self.cell(n).text
            return text if all(w in text for w in words) else None

        return self.wait(said, f"{words} in cell {n}")

    def press(self, *keys, shift=False):
        """Press keys, wherever the focus is."""
        from selenium.webdriver import ActionChains, Keys

        actions = ActionChains(self.driver)
        if shift:
            actions.key_down(Keys.SHIFT).send_keys(*keys).key_up(Keys.SHIFT)
        else:
            actions.send_keys(*keys)
        actions.perform()

    def run(self, n):
        """Run the cell ``n`` by Shift and Enter; again while nothing happens, since JupyterLab
        takes no keys for a moment after it says that the kernel is there.
        """
        from selenium.webdriver import Keys

        def prompt():
            return self.all(".jp-InputPrompt", n)[0].text.strip("[]: \xa0")

        end = time.monotonic() + LONG
        while time.monotonic() < end and not prompt():
            self.all(".cm-content", n)[0].click()
            self.press(Keys.ENTER, shift=True)
            soon = time.monotonic() + 5
            while time.monotonic() < soon and not prompt():
                time.sleep(0.05)
        self.wait(lambda: prompt().isdigit(), f"that cell {n} ran")

    def focused(self):
        """What has the focus: the label of a field, the text of a button."""
        return self.driver.execute_script(
            "const e = document.activeElement, l = e.labels && e.labels[0];"
            "return l ? l.textContent : e.tagName == 'BUTTON' ? e.textContent : e.className"
        )

    def go_to(self, name):
        """Press Tab until ``name`` has the focus."""
        from selenium.webdriver import Keys

        seen = []
        for _ in range(30):
            if self.focused() == name:
                return
            seen.append(self.focused())
            self.press(Keys.TAB)
        pytest.fail(f"Tab does not reach {name!r}: {seen}")

    def into_form(self, n):
        """Go to the first field below the cell ``n``: choose the cell, then Tab."""
        self.driver.execute_script("arguments[0].focus()", self.cell(n))

    def push(self, name):
        """Press the button ``name`` by Tab and Space."""
        self.go_to(name)
        self.press(" ")

    def cut(self, n):
        """The buttons in a cell whose text is cut off."""
        return self.driver.execute_script(
            "return [...arguments[0].querySelectorAll('button')]"
            ".filter(b => b.scrollWidth > b.clientWidth).map(b => b.title)",
            self.cell(n),
        )


@pytest.fixture(scope="module")
def page(lab, driver):
    """The notebook, all cells run."""
    driver.get(lab)
    page = Page(driver)
    shown = ".jp-NotebookPanel:not(.lm-mod-hidden) .jp-CodeCell .cm-content"
    page.wait(lambda: any(e.is_displayed() for e in page.all(shown)), "the notebook")
    page.wait(lambda: page.all(".jp-Notebook-ExecutionIndicator[data-status=idle]"), "a kernel")
    for n in range(len(CELLS)):
        page.run(n)
    page.says(3, "section 3.8: not tried")
    return page


def test_text_formulas_and_figure_are_shown(page):
    page.says(0, "Elbow arm on a turning shaft", "Find", "beta_1 = 120")
    page.wait(lambda: len(page.all("mjx-container", 0)) > 10, "formulas")
    (figure,) = page.wait(lambda: page.all("img", 0), "the figure")
    assert "A vertical shaft with B at its top" in figure.get_attribute("alt")
    assert page.driver.execute_script("return arguments[0].naturalWidth", figure) > 300
    for n in range(3):
        assert "$" not in page.cell(n).text
        assert r"\\" not in page.cell(n).text
        assert not page.all(".jp-OutputArea-output[data-mime-type*=stderr]", n)
    assert len(page.all("mjx-merror")) == 0
    page.shoot("shown")


def test_a_wrong_answer_is_named_by_keyboard(page):
    page.says(1, "Check step")
    assert page.cut(1) == []
    page.into_form(1)
    page.go_to("a_D")
    page.press("[0, -7.38, -2.80592]")
    page.go_to("Check")
    start = time.monotonic()
    page.press(" ")
    page.says(1, "leaves out the Coriolis term")
    print(f"\nfrom pressing Check to the answer: {time.monotonic() - start:.2f} s")
    page.shoot("wrong")
    page.into_form(1)
    page.go_to("v_D")
    page.press("[1, 2")
    page.push("Check")
    page.says(1, "'[1, 2' is no number, and no list")
    page.shoot("unreadable")


def test_steps_hints_solution_and_new_numbers_by_keyboard(page):

    page.into_form(1)
    page.push("Next step")
    page.says(1, "Find omega_CD", "Section 4.9")
    page.press(" ")
    page.says(1, "equation (4.22)")
    page.shoot("hint")
    page.go_to("step")
    page.press("v_r")
    page.go_to("its value")
    page.press("[0, 1, 2]")
    page.push("Check step")
    page.says(1, "v_r [0, 1, 2] mm/s: not right")
    page.says(1, "velocity of D relative to the moving frame")
    page.shoot("step")
    page.into_form(1)
    page.push("Solution")
    page.says(1, "Coriolis term")
    page.wait(lambda: len(page.all("mjx-container", 1)) > 30, "formulas of the solution")
    page.shoot("solution")
    page.push("New numbers")
    page.says(1, "Numbers 2 of 2")
    assert "equation (4.22)" not in page.cell(1).text
    fields = page.all("input[type=text]", 1)
    assert [f.get_attribute("value") for f in fields] == [""] * 5
    page.shoot("new")


def test_a_matrix_by_keyboard(page):
    page.says(2, "Check step")
    page.into_form(2)
    page.go_to("T_theta")
    page.press("[[1, 0, 0], [0, 1, 0], [0, 0, 1]]")
    page.push("Check")
    assert page.says(2, "T_theta [[1, 0, 0], [0, 1, 0], [0, 0, 1]]: not right")
    page.shoot("matrix")
    page.push("Solution")
    assert page.wait(lambda: len(page.all("mjx-mtable", 2)) > 1, "matrices")
    page.shoot("matrices")


def test_the_console_has_no_error_of_ours(page):
    log = page.driver.get_log("browser")
    errors = [x for x in log if x["level"] == "SEVERE" and x["source"] != "network"]
    assert errors == []
