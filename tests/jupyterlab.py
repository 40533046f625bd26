"""A JupyterLab, a browser, and a notebook in them as a student sees it, for tests that drive it
by keyboard and mouse. Where one of these is not installed, the test is skipped.
"""

import os
import secrets
import shutil
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).parents[1]
LONG = 180  # seconds: for a busy machine


def write_notebook(path, cells):
    """Write a notebook with these cells of code."""
    from nbformat import v4, write

    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    made = v4.new_notebook(metadata={"kernelspec": kernel}, cells=[*map(v4.new_code_cell, cells)])
    write(made, path)


@contextmanager
def jupyterlab(notebook, own):
    """The address of a notebook in a JupyterLab with settings in ``own``, ended afterwards."""
    with served(notebook.parent, own, JUPYTER_NO_CONFIG="1") as (at, token):
        yield f"{at}/lab/tree/{notebook.name}?token={token}"


@contextmanager
def served(folder, own, **variables):
    """(address, token) of a JupyterLab in a folder, with settings in ``own``, ended afterwards."""
    pytest.importorskip("jupyterlab", reason="JupyterLab is not installed")
    pytest.importorskip("ipywidgets", reason="ipywidgets is not installed")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    token, at = secrets.token_hex(16), f"http://127.0.0.1:{port}"
    command = [
        sys.executable, "-m", "jupyterlab", "--no-browser", "--ip=127.0.0.1", f"--port={port}",
        "--ServerApp.port_retries=0", f"--IdentityProvider.token={token}", "--allow-root",
        f"--ServerApp.root_dir={folder}", "--LabApp.news_url=None",
        "--LabApp.check_for_updates_class=jupyterlab.handlers.announcements.NeverCheckForUpdate",
        "--LabApp.extension_manager=readonly",
    ]  # fmt: skip
    environment = {
        **os.environ, "PYTHONPATH": str(REPOSITORY), "JUPYTER_CONFIG_DIR": str(own / "config"),
        "JUPYTER_RUNTIME_DIR": str(own / "run"), "IPYTHONDIR": str(own / "ipython"),
        "JUPYTERLAB_SETTINGS_DIR": str(own / "settings"),
        "JUPYTERLAB_WORKSPACES_DIR": str(own / "workspaces"), **variables,
    }  # fmt: skip
    tracker = own / "settings/@jupyterlab/notebook-extension/tracker.jupyterlab-settings"
    tracker.parent.mkdir(parents=True)
    tracker.write_text('{"windowingMode": "none"}')  # all cells are in the page
    with (own / "log").open("w") as log:
        server = subprocess.Popen(command, cwd=folder, env=environment, stdout=log, stderr=log)
    try:
        _wait_for(f"{at}/api/status?token={token}", server, own / "log")
        yield at, token
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


@contextmanager
def chromium(profile, size="1200,2200"):
    """A browser without a screen, its profile in this folder."""
    webdriver = pytest.importorskip("selenium.webdriver", reason="selenium is not installed")
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    if not browser or not shutil.which("chromedriver"):
        pytest.skip("chromium or chromedriver is not installed")
    options = webdriver.ChromeOptions()
    options.binary_location = browser
    for argument in (
        "--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking",
        "--disable-component-update", "--disable-sync", "--no-first-run",
        "--disable-dev-shm-usage", f"--window-size={size}", "--lang=en", f"--user-data-dir={profile}",
    ):  # fmt: skip
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    service = webdriver.ChromeService(executable_path=shutil.which("chromedriver"))
    driver = webdriver.Chrome(options=options, service=service)
    try:
        yield driver
    finally:
        driver.quit()


class Page:
    """A notebook as a student sees it, and the keys that they press."""

    def __init__(self, driver):
        self.driver = driver

    def wait(self, condition, what):
        """What a condition gives as soon as it is true. Until then it may fail: a page that comes
        has not all of its parts.
        """
        from selenium.common.exceptions import WebDriverException

        end, why = time.monotonic() + LONG, ""
        while time.monotonic() < end:
            try:
                if found := condition():
                    return found
            except WebDriverException as error:
                why = f" ({error.msg})"
            time.sleep(0.02)
        self.shoot("failed")
        return pytest.fail(f"not seen within {LONG} s: {what}{why}")

    def shoot(self, name):
        """A picture of the page, in the folder SCREENSHOTS if that is set."""
        if folder := os.environ.get("SCREENSHOTS"):
            self.driver.save_screenshot(f"{folder}/{name}.png")

    def all(self, css, n=None):
        """The elements of a selector, of the cell ``n`` where one is given."""
        inside = self.driver if n is None else self.cell(n)
        return inside.find_elements("css selector", css)

    def cell(self, n):
        """The cell ``n``."""
        return self.driver.find_elements("css selector", ".jp-Notebook .jp-CodeCell")[n]

    def says(self, n, *words):
        """Wait until a cell shows all the words; returns its text."""

        def answered():
            text = self.cell(n).text
            return text if all(w in text for w in words) else None

        return self.wait(answered, f"{words} in cell {n}")

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
        """Run cell ``n`` by Shift-Enter, again while nothing happens: keys are dropped at first."""
        from selenium.common.exceptions import WebDriverException
        from selenium.webdriver import Keys

        prompt = lambda: self.all(".jp-InputPrompt", n)[0].text.strip("[]: \xa0")
        end = time.monotonic() + LONG
        while time.monotonic() < end and not prompt():
            with suppress(WebDriverException):  # a startup dialog still covers it
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

    def errors(self):
        """What the console says of errors, but for addresses that were not found."""
        log = self.driver.get_log("browser")
        return [x for x in log if x["level"] == "SEVERE" and x["source"] != "network"]

    def open(self, address, cells):
        """Open a notebook and run its cells."""
        self.driver.get(address)
        shown = ".jp-NotebookPanel:not(.lm-mod-hidden) .jp-CodeCell .cm-content"
        self.wait(lambda: any(e.is_displayed() for e in self.all(shown)), "the notebook")
        self.wait(lambda: self.all(".jp-Notebook-ExecutionIndicator[data-status=idle]"), "a kernel")
        for n in range(cells):
            self.run(n)
