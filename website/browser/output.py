"""What a cell shows: what it prints, displays and returns, in order, as a page can show it."""

import base64
import sys
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout
from importlib import import_module
from types import ModuleType
from typing import Any

# the first kind that an object has is shown
KINDS = {
    "text/html": "_repr_html_", "image/svg+xml": "_repr_svg_", "text/latex": "_repr_latex_",
    "text/markdown": "_repr_markdown_", "image/png": "_repr_png_", "text/plain": "__repr__",
}  # fmt: skip
WRAPPERS = {
    "HTML": "text/html", "SVG": "image/svg+xml", "Latex": "text/latex", "Math": "text/latex",
    "Markdown": "text/markdown",
}  # fmt: skip
DISPLAY = "IPython.display"


class CellOutput:
    """Collects (kind, content); a file that can be printed to."""

    def __init__(self) -> None:
        self.items: list[list[str]] = []

    def write(self, text: str) -> None:
        """What is printed, joined to what was printed before."""
        if self.items and self.items[-1][0] == "text/plain":
            self.items[-1][1] += text
        else:
            self.items.append(["text/plain", text])

    def flush(self) -> None:
        """Nothing is buffered."""

    def display(self, *objects: Any, raw: bool = False, **_: Any) -> None:
        """Show objects, or where they are ``raw`` their {kind: content}."""
        for x in objects:
            if hasattr(x, "_ipython_display_"):
                x._ipython_display_()
            else:
                data = x if raw else _bundle(x)
                kind = next(kind for kind in KINDS if data.get(kind))
                self.items.append([kind, data[kind]])


def _bundle(x):
    """{kind: content} of an object."""
    if hasattr(x, "_repr_mimebundle_"):
        found = x._repr_mimebundle_()
        return found[0] if isinstance(found, tuple) else found
    data = {kind: getattr(x, name)() for kind, name in KINDS.items() if hasattr(x, name)}
    if isinstance(data.get("image/png"), bytes):
        data["image/png"] = base64.b64encode(data["image/png"]).decode()
    return data


@contextmanager
def showing(output: CellOutput) -> Iterator[None]:
    """What is printed and displayed in this block is collected, whether or not IPython is here."""
    display_module: Any = ModuleType(DISPLAY)
    for name, kind in WRAPPERS.items():
        setattr(display_module, name, _wrapper(kind))
    display_module.display = output.display
    display_module.clear_output = lambda wait=False: output.items.clear()
    before = _display_module()
    sys.modules[DISPLAY] = display_module
    try:
        with redirect_stdout(output):  # type: ignore[type-var]
            yield
    finally:
        sys.modules[DISPLAY] = before


def _display_module():
    """IPython's module, or an empty one."""
    try:
        return import_module(DISPLAY)
    except ModuleNotFoundError:
        top: Any = ModuleType("IPython")
        top.get_ipython = lambda: None  # as outside a notebook
        sys.modules["IPython"] = top
        return sys.modules.setdefault(DISPLAY, ModuleType(DISPLAY))


def _wrapper(kind):
    class Wrapper:
        def __init__(self, text):
            self.text = text

        def _repr_mimebundle_(self):
            return {kind: self.text}

    return Wrapper
