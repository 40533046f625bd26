"""Texts that others read: HTML, JavaScript, terminal escapes, markup, spreadsheet formulas."""

from tests.grader.attacks.attack import added, code, edited

EVIL = (
    "<script>alert(1)</script><img src=x onerror=alert(1)><svg onload=alert(1)>"
    "<iframe src='//evil'></iframe><a href='javascript:alert(1)'>x</a>"
    "<style>body{display:none}</style></pre></table><h1>100/100</h1>"
)
TERMINAL = "\x1b[2J\x1b[1;1H\x1b]0;owned\x07\x9b31m\x08\x7f\u202e\u2066\r"
MARKUP = "[red]x[/red] [/] [link=file:///etc/passwd]y[/link] {{ 7 * 7 }} {% raw %} $\\href{javascript:x}{y}$"
FORMULA = '=HYPERLINK("http://evil","x")\n@SUM(1)\n+1\n-1'
ALL = {"HTML": EVIL, "terminal codes": TERMINAL, "markup": MARKUP, "formulas of tables": FORMULA}


def _raised(text):
    return code(f"raise ValueError({text!r})")


def essay(notebook, scene):
    cell = next(c for c in notebook["cells"] if c["id"] == "essay")
    cell["source"] = (
        f"My view.\n\n{EVIL}\n\n[x](javascript:alert(1)) ![y](http://evil/x.png) {MARKUP}"
    )


def long_essay(notebook, scene):
    """Libraries for Markdown and HTML take quadratic time for texts like these."""
    cell = next(c for c in notebook["cells"] if c["id"] == "essay")
    cell["source"] = "\\" * 300_000 + "> " * 300_000 + "\\begin{a}" * 10_000


def names(notebook, scene):
    for c in notebook["cells"]:
        c["metadata"]["name"] = EVIL
    notebook["metadata"]["title"] = notebook["metadata"]["name"] = EVIL
    notebook["cells"][4]["source"] = f"speed = {EVIL!r}  # {EVIL}\nacc_mag = '''{TERMINAL}'''"


def half_characters(notebook, scene):
    notebook["cells"][4]["source"] = "raise ValueError('\ud800' + chr(0xdfff))"
    notebook["cells"].append(
        {"cell_type": "markdown", "id": "m", "metadata": {}, "source": "\udcff \x00 \ufffe"}
    )


ATTACKS = {
    **{f"an error of {what}": _raised(text) for what, text in ALL.items()},
    "an error without end": code("raise ValueError('<b>' * 10**7)"),
    "an error whose class is HTML": code("raise type('<script>alert(1)</script>\\x1b[2J', (Exception,), {})(1)"),
    "a frame whose name is HTML": code(f"""
        from newton_euler import Frame, ground
        A = Frame({EVIL!r} + '\\x1b[2J')
        speed = acc_mag = {EVIL!r}
    """),
    "symbols whose names are HTML": code(f"""
        from sympy import Symbol
        speed = acc_mag = Symbol({EVIL!r} + '\\x1b[2J')
    """),
    "an answer that is HTML": code(f"speed, acc_mag = {EVIL!r}, {TERMINAL!r}"),
    "HTML that is displayed": code(f"from IPython.display import HTML, display\ndisplay(HTML({EVIL!r}))\nprint({TERMINAL!r})"),
    "JavaScript cells": added(f"%%javascript\nalert(1)\n{EVIL}"),
    "a text of HTML": added(f"# Mine\n\n{EVIL}\n\n[x](javascript:alert(1))", "markdown"),
    "an essay of HTML": edited(essay),
    "an essay that takes hours to read": edited(long_essay),
    "names and comments of HTML": edited(names),
    "half characters": edited(half_characters),
}  # fmt: skip
