"""A headless browser, a file server, and the browser's log."""

import json
import threading
import time
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

SCRIPTS = Path(__file__).with_name("scripts")
LONG = 180  # seconds: for a busy machine


def script(name):
    """A JavaScript file for the browser's page."""
    return (SCRIPTS / f"{name}.js").read_text(encoding="utf-8")


class Quiet(SimpleHTTPRequestHandler):
    """A silent file server that lets other sites read its files."""

    def log_message(self, *_):
        pass

    def end_headers(self):
        self.send_header("Access-Control-Allow-Origin", "*")
        super().end_headers()


@contextmanager
def served(folder):
    """Serve a folder on this machine while the block runs: "http://127.0.0.1:PORT"."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(folder)))
    thread = threading.Thread(target=server.serve_forever)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


def emulated(driver, theme="", media="", reduced=""):
    """Show pages as to a reader whose system is "dark" or "light", who wants to "reduce" motion, or
    on paper, by media "print".
    """
    wanted = {"prefers-color-scheme": theme, "prefers-reduced-motion": reduced}
    features = [{"name": name, "value": value} for name, value in wanted.items()]
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": media, "features": features})


def complaints(driver):
    """What the console has printed since the last call."""
    return [x["message"] for x in driver.get_log("browser") if x["level"] in ("SEVERE", "WARNING")]


def requests(driver):
    """The addresses requested since the last call."""
    messages = (json.loads(x["message"])["message"] for x in driver.get_log("performance"))
    sent = (m["params"] for m in messages if m["method"] == "Network.requestWillBeSent")
    return [p["request"]["url"] for p in sent]


def wait(driver, script, what):
    """What a script gives as soon as it gives something. Until then it may fail: a page that comes
    has not all of its parts.
    """
    from selenium.common.exceptions import WebDriverException

    end, why = time.monotonic() + LONG, ""
    while time.monotonic() < end:
        try:
            if found := driver.execute_script(f"return {script}"):
                return found
        except WebDriverException as error:
            why = f" ({error.msg})"
        time.sleep(0.05)
    return pytest.fail(f"not seen within {LONG} s: {what}{why}")
