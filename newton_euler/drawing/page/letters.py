r"""Labels as letters: the runs of Unicode, which a page's own fonts show, of a text with formulas
between dollars; the room that they take; and their texts as SVG.
"""

import re
import unicodedata
from functools import cache
from html import escape
from itertools import pairwise
from typing import NamedTuple

from .primitives import BLACK

# the letters of DejaVu Sans by their advance widths in hundredths of its size; others as an x.
# A test compares them with the font that Matplotlib brings.
_WIDTHS = {
    20: "\u2009", 23: "′", 27: "'", 28: "ijlıȷ", 29: "IJ", 32: " ,.·⋅\xa0", 34: "/:;\\|ι", 35: "f",
    36: "-", 39: "()[]t", 40: "!²³", 41: "rℓ", 46: '"', 50: "*_`°∥–", 52: "sz∂∫", 53: "?",
    54: "εζ", 55: "c", 56: "LΓνξ", 58: "Fkυχ", 59: "vxyγκλ", 60: "Pπτ", 61: "TYaoδθο", 62: "eϑ",
    63: "ESbdghnpquΞΣηρσ", 64: "$0123456789{}βμ√", 66: "Kαφψϕ", 67: "∇∑", 68: "AVΔΛ", 69: "BRXZ",
    70: "C", 71: "∝", 73: "U", 75: "HNΠ", 76: "Ω", 77: "DG", 78: "&", 79: "OQΘΦΨ", 82: "w",
    83: "∞", 84: "#+<=>^~×−ω≈≠≤≥→←±", 86: "M", 87: "⊥", 90: "∠", 95: "%", 97: "m½¼", 99: "W",
    100: "@…",
}  # fmt: skip
WIDTH = {letter: width / 100 for width, letters in _WIDTHS.items() for letter in letters}
BOLD = 1.12  # width of bold letters, relative to the usual
SMALL, LOWER, HIGHER = 0.7, 0.2, 0.38  # relative size of index and power, and their shifts
# heights above the base line, of l and of accented letters; depth of p
ABOVE, ACCENTED, BELOW = 0.76, 0.95, 0.21
_DEEP = set("gjpqyQ,;()/|βγζημξρφχψ")

_SYMBOLS = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "varepsilon": "ε",
    "zeta": "ζ", "eta": "η", "theta": "θ", "vartheta": "ϑ", "iota": "ι", "kappa": "κ",
    "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "pi": "π", "rho": "ρ", "sigma": "σ",
    "tau": "τ", "upsilon": "υ", "phi": "φ", "varphi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω",
    "Gamma": "Γ", "Delta": "Δ", "Theta": "Θ", "Lambda": "Λ", "Xi": "Ξ", "Pi": "Π", "Sigma": "Σ",
    "Phi": "Φ", "Psi": "Ψ", "Omega": "Ω", "imath": "ı", "jmath": "ȷ", "ell": "ℓ", "nabla": "∇",
    "partial": "∂", "infty": "∞", "circ": "°", "degree": "°", "prime": "′", "int": "∫", "sum": "∑",
    "parallel": "∥", "perp": "⊥", "angle": "∠", "dots": "…", "ldots": "…", "cdots": "…",
    "quad": "\xa0\xa0", "qquad": "\xa0" * 4, ",": "\u2009", ";": "\xa0", ":": "\xa0", " ": "\xa0",
    "!": "", "left": "", "right": "", "displaystyle": "", "{": "{", "}": "}", "%": "%", "$": "$",
    "|": "∥", "lbrace": "{", "rbrace": "}", "sqrt": "√",
}  # fmt: skip
_SIGNS = {
    "+": "+", "-": "−", "=": "=", "<": "<", ">": ">", "pm": "±", "times": "×", "cdot": "·",
    "approx": "≈", "sim": "~", "neq": "≠", "ne": "≠", "le": "≤", "leq": "≤", "ge": "≥", "geq": "≥",
    "to": "→", "rightarrow": "→", "leftarrow": "←", "propto": "∝", "equiv": "≡",
}  # fmt: skip
_ACCENTS = {
    "hat": "\u0302", "widehat": "\u0302", "tilde": "\u0303", "bar": "\u0304", "overline": "\u0304",
    "dot": "\u0307", "ddot": "\u0308", "vec": "\u20d7", "overrightarrow": "\u20d7",
}  # fmt: skip
_FONTS = {
    "mathbf": (False, True), "mathrm": (False, False), "text": (False, False),
    "mathit": (True, False), "boldsymbol": (True, True), "operatorname": (False, False),
}  # fmt: skip
_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|.", re.DOTALL)


class LetterRun(NamedTuple):
    """Letters of one look; ``level`` 1 for a power, -1 for an index, ``over`` the other one where a
    letter has both.
    """

    text: str
    italic: bool = False
    bold: bool = False
    level: int = 0
    over: bool = False

    def width(self) -> float:
        """Its width at size 1."""
        letters = unicodedata.normalize("NFD", self.text)
        width = sum(WIDTH.get(c, WIDTH["x"]) for c in letters if not unicodedata.combining(c))
        return width * (BOLD if self.bold else 1) * (SMALL if self.level else 1)


class Letters(NamedTuple):
    """The runs of a text; its width, and its height above and below the base line, by its size."""

    runs: tuple[LetterRun, ...]
    width: float
    above: float
    below: float


@cache
def letters(text: str, bold: bool = False) -> Letters:
    r"""The :class:`Letters` of a text with formulas between dollars.

    >>> [run.text for run in letters(r"$\hat{e}_t$ = 2").runs]
    ['ê', 't', ' = 2']
    """
    found: list[LetterRun] = []
    parts = re.split(r"(?<!\\)\$", text)
    if len(parts) == 2:  # a dollar that opens no formula
        parts = [text]
    for n, part in enumerate(parts):
        if n % 2:
            found += _Formula(part).all()
        elif part:
            found.append(LetterRun(part.replace(r"\$", "$"), bold=bold))
    runs = tuple(_joined(found))
    width = sum(run.width() for run in runs)
    width -= sum(min(a.width(), b.width()) for a, b in pairwise(runs) if b.over)
    above = max((_above(run) for run in runs), default=ABOVE)
    below = any(run.level < 0 and _DEEP.intersection(run.text) for run in runs)
    return Letters(runs, width, above, LOWER + SMALL * BELOW if below else BELOW)


def _above(run):
    """The height of a run above the base line."""
    if run.level > 0:
        return HIGHER + SMALL * ABOVE
    marked = any(map(unicodedata.combining, unicodedata.normalize("NFD", run.text)))
    return ACCENTED if marked and not run.level else ABOVE


def _joined(runs):
    """The runs, with those of one look written as one."""
    out: list[LetterRun] = []
    for run in runs:
        if out and not run.over and out[-1][1:4] == run[1:4] and not (run.level and out[-1].over):
            out[-1] = out[-1]._replace(text=out[-1].text + run.text)
        elif run.text:
            out.append(run)
    return [run._replace(text=unicodedata.normalize("NFC", run.text)) for run in out]


class _Formula:
    """Reads a formula from left to right."""

    def __init__(self, source):
        self.left = _TOKEN.findall(source)[::-1]

    def all(self):
        """The runs of the whole formula."""
        found = []
        while self.left:
            found += self.group(True, False, first=not found)
        return found

    def group(self, italic, bold, first=True):
        """The runs of the next letter, sign, command, or what stands between braces."""
        if not self.left:
            return []
        token = self.left.pop()
        name = token.removeprefix("\\")
        if token == "{":
            found = []
            while self.left and self.left[-1] != "}":
                found += self.group(italic, bold, first=not found)
            self.left[-1:] = []
            return found
        if token in ("_", "^"):
            return self.index(-1 if token == "_" else 1, italic, bold)
        if token == "'":
            return [LetterRun("′")]
        if name in _SIGNS and (token == name) == (len(name) == 1):
            sign = _SIGNS[name]
            return [LetterRun(sign if first else f"\u2009{sign}\u2009")]
        if token[0] != "\\":
            return self.letter(token, italic, bold)
        if name in _ACCENTS:
            return [_accented(run, _ACCENTS[name]) for run in self.argument(italic, bold)]
        if name in _FONTS:
            if name in ("text", "mathrm") and self.left and self.left[-1] == "{":
                self.left = ["\xa0" if c == " " else c for c in self.left]
            return self.argument(*_FONTS[name])
        if name in ("frac", "dfrac", "tfrac"):
            return [*self.whole(italic, bold), LetterRun("/"), *self.whole(italic, bold)]
        if name == "sqrt":
            return [LetterRun("√"), *self.whole(italic, bold)]
        if name in _SYMBOLS:
            return self.letter(_SYMBOLS[name], italic, bold)
        return [LetterRun(f"{name}\u2009", bold=bold)]  # a function, as sin

    def letter(self, text, italic, bold):
        """Letters slant, but no capital of the Greek; a formula has no spaces."""
        if text == " ":
            return []
        slants = italic and text.isalpha() and text != "ℓ" and not "Α" <= text <= "Ω"
        return [LetterRun(text, slants, bold)]

    def argument(self, italic, bold):
        """The next group, over the space before it."""
        while self.left and self.left[-1] == " ":
            self.left.pop()
        return self.group(italic, bold)

    def whole(self, italic, bold):
        """An argument, in parentheses if it is long."""
        found = self.argument(italic, bold)
        return found if len(found) < 2 else [LetterRun("("), *found, LetterRun(")")]

    def index(self, level, italic, bold):
        """An index or a power, and the other one over it."""
        found = [run._replace(level=level) for run in self.argument(italic, bold)]
        if [run.text for run in found] == ["°"]:
            return [LetterRun("°")]
        other = "^" if level < 0 else "_"
        if self.left and self.left[-1] == other and len(_joined(found)) == 1:
            self.left.pop()
            above = _joined(r._replace(level=-level) for r in self.argument(italic, bold))
            if above:
                above[0] = above[0]._replace(over=True)
            found = [*_joined(found), *above]
        return found


def _accented(run, mark):
    """A run with a mark over its letter, over each letter where it is a line or an arrow."""
    if mark in ("\u20d7", "\u0304"):
        return run._replace(text="".join(c + mark for c in run.text))
    dotted = {"ı": "i", "ȷ": "j"} if mark == "\u0302" else {}  # fonts have î and ĵ
    return run._replace(text=dotted.get(run.text, run.text) + mark)


def text_at(
    text: str,
    x: float,
    y: float,
    size: float,
    colour: str = BLACK,
    bold: bool = False,
    more: str = "",
) -> str:
    """A text with its middle at (x, y) in points, and ``more`` attributes."""
    found = letters(text, bold)
    base = y + size * (found.above - found.below) / 2
    return (
        f'<text x="{x:.1f}" y="{base:.1f}" font-size="{size:g}" fill="{colour}"{more}>'
        f"{''.join(_spans(found.runs, size))}</text>"
    )


def _spans(runs, size):
    """The runs of a text, each with its look where that is not the usual."""
    height, last = 0.0, None
    for run in runs:
        level = (0, HIGHER, -LOWER)[run.level]
        look = f' dy="{size * (height - level):.1f}"' if level != height else ""
        if run.over:
            look += f' dx="{-size * min(last.width(), run.width()):.1f}"'
        if run.level:
            look += f' font-size="{SMALL * size:.1f}"'
        look += ' font-style="italic"' * run.italic + ' font-weight="bold"' * run.bold
        words = escape(run.text, quote=False)
        yield f"<tspan{look}>{words}</tspan>" if look else words
        height, last = level, run
