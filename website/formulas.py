"""The formulas of the pages, typeset by MathJax in node when the site is built. If either is
missing, pages keep the script that does it in the reader's browser.
"""

import json
import re
import subprocess
import tempfile
from html import unescape
from pathlib import Path

from .execution import WebsiteError
from .npm import Package

MATHJAX = Package(
    "mathjax",
    "3.2.2",
    "sha512-Bt+SSVU8eBG27zChVewOicYs7Xsdt40qm4+UpHyX7k0/O9NliPc+x77k1/FEsPsjKPZGJvtRZM1vO+geW0OhGw==",
)
FILES = tuple(
    f"es5/{name}.js"
    for name in (
        "node-main", "core", "startup", "loader", "input/tex-full", "output/svg",
        "output/svg/fonts/tex", "adaptors/liteDOM", "a11y/assistive-mml",
    )
)  # fmt: skip
SCRIPT = Path(__file__).with_name("formulas.js")
FORMULA = re.compile(
    r'(<(span|div)\b[^>]* class="[^"]*\bmath\b[^"]*"[^>]*>)\s*\\([(\[])([^<]*)\\[)\]]\s*</\2>'
)
GLYPH = re.compile(r'<path id="([^"]+)" d="[^"]*"></path>')
LOADED = re.compile(r"<script>window\.MathJax = .*?</script>|<script [^>]*tex-svg[^>]*></script>")
# attributes of formulas that pages do not use, or set in their style sheet
UNUSED = re.compile(
    r" (?:data-c|data-mjx-texclass|data-mml-node|data-id[\w-]+|xmlns(?::xlink)?|focusable|id"
    r'|unselectable|class|role)="[^"]*"| (?:stroke|fill)="currentColor"| stroke-width="0"'
    r'| style="font-size: 93%; position: relative;"|<text></text>'
)
PLACE = re.compile(r"translate\((-?[\d.]+),(-?[\d.]+)\)")
ALONE = re.compile(r'<g( transform="[^"]*")><use( href="[^"]*")></use></g>')
MOVED = re.compile(r'(<use\b[^>]*?) transform="translate\((-?\d+),(-?\d+)\)"')
# parts of MathML without effect: a row of one sign, a style around a space
ONE = re.compile(
    r"<mrow>(<(m\w+)[^>]*>[^<]*</\2>)</mrow>"
    r'|<mstyle scriptlevel="0">(<mspace[^>]*></mspace>)</mstyle>'
)
USED = re.compile(r'(?<= href="#)MJX[^"]+')
OUTLINES = '<svg class="outlines" aria-hidden="true"><defs>{}</defs></svg>'


def typeset(pages: Path) -> bool:
    """Typeset the formulas of all pages in the folder; return whether that was possible."""
    texts = {path: path.read_text("utf-8") for path in sorted(pages.rglob("*.html"))}
    asked = {path: [*map(_formula, FORMULA.finditer(text))] for path, text in texts.items()}
    every = list(dict.fromkeys(formula for found in asked.values() for formula in found))
    made = _made(every)
    if made is None:
        return False
    drawn = dict(zip(every, made["formulas"], strict=True))
    glyphs = {m[1]: m[0] for m in GLYPH.finditer(made["glyphs"])}
    for path, text in texts.items():
        if wrong := [formula for formula in asked[path] if "merror" in drawn[formula]]:
            raise WebsiteError(f"{path.relative_to(pages)}: not a formula: {wrong[0][0]}")
        path.write_text(_page(text, drawn, glyphs), encoding="utf-8")
    return True


def _formula(match):
    """(LaTeX, whether it is displayed)."""
    return unescape(match[4]).strip(), match[3] == "["


def _made(asked):
    """The output of formulas.js; None without node or MathJax."""
    files = MATHJAX.files(*FILES)
    if files is None:
        return None
    with tempfile.TemporaryDirectory() as folder:
        for name, contents in files.items():
            path = Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(contents)
        command, given = ["node", SCRIPT, folder], json.dumps(asked).encode()
        try:
            done = subprocess.run(command, input=given, capture_output=True, check=True)
        except (OSError, subprocess.CalledProcessError):
            return None
    return json.loads(done.stdout)


def _page(text, drawn, glyphs):
    """A page with typeset formulas and the outlines they use, without the script."""
    made = FORMULA.sub(lambda m: f"{m[1]}{_light(drawn[_formula(m)])}</{m[2]}>", text)
    short = {name: f"_{n}" for n, name in enumerate(dict.fromkeys(USED.findall(made)))}
    made = USED.sub(lambda m: short[m[0]], made)
    used = "".join(glyphs[name].replace(name, short[name], 1) for name in short)
    return LOADED.sub("", made).replace("</body>", f"{OUTLINES.format(used) * bool(used)}</body>")


def _light(html):
    """A formula without unused attributes, with coordinates rounded to a thousandth of the letters'
    height.
    """
    found = ONE.sub(r"\1\3", UNUSED.sub("", html)).replace("xlink:href", "href")
    found = found.replace('<g transform="scale(1,-1)">', "<g>", 1)  # the outermost
    found = PLACE.sub(lambda m: f"translate({float(m[1]):.0f},{float(m[2]):.0f})", found)
    found = ALONE.sub(r"<use\1\2></use>", _without_groups(found))
    return MOVED.sub(r'\1 x="\2" y="\3"', found).replace(' y="0"', "").replace("></use>", "/>")


def _without_groups(html):
    """A formula without groups that have no attributes, except the outermost, which flips y."""
    found, dropped = [], []
    for part in re.split(r"(</?g\b[^>]*>)", html):
        if part.startswith("<g"):
            dropped.append(bool(dropped) and part == "<g>")
            is_left = not dropped[-1]
        else:
            is_left = part != "</g>" or not dropped.pop()
        found.append(part if is_left else "")
    return "".join(found)
