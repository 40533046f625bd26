"""A headless browser, a file server, and the browser's log."""

import json
import threading
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from tests.jupyterlab import Page

SCRIPTS = Path(__file__).with_name("scripts")


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


def js(driver, expression, *given):
    """The value of an expression of JavaScript in the page."""
    return driver.execute_script(f"return {expression}", *given)


def text(driver, selector):
    """The text of the first element of a selector, shown or not."""
    return js(driver, "document.querySelector(arguments[0]).textContent", selector)


def wait(driver, script, what):
    """The value of an expression as soon as it is true, as :meth:`Page.wait`."""
    return Page(driver).wait(lambda: js(driver, script), what)
