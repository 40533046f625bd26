"""How names, units, numbers and formulas are written in LaTeX, which MathJax typesets in a
notebook: ``b_dot`` is an ASCII name, and b with a dot is what a reader sees.
"""

import re
from collections.abc import Iterable, Mapping
from decimal import ROUND_HALF_UP, Context
from functools import lru_cache
from html.entities import name2codepoint

from .trees import Tree

_NAMES = (
    "alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi rho sigma tau phi psi "
    "omega Omega Gamma Delta Theta Lambda Sigma Phi Psi"
)
GREEK = {name: chr(name2codepoint[name]) for name in _NAMES.split()}
_SIX = Context(prec=6, rounding=ROUND_HALF_UP)
_SHORT = {"lam": "lambda", "gam": "gamma", "th": "theta", "eps": "epsilon"}  # "lambda" is a keyword
_LETTER = rf"[A-Za-z]|{'|'.join((*GREEK, *_SHORT))}"
_DOTS = {"dot": r"\dot", "ddot": r"\ddot", "rate": r"\dot"}
# an index without an underscore: digits, a point (xA), an axis (vx), v_t and a_n (atA)
_GLUED = rf"(?P<base>{_LETTER})(?P<index>\d+|(?<![A-Z])[A-Z]|[xyz]|(?<=[av])[tn][A-Z\d]?)"
_FUNCTIONS = ("sin", "cos", "tan")


def symbol(name: str, vector: bool = False) -> str:
    r"""The LaTeX of a name: Greek letters, dots and indices; other words upright, vectors bold.

    >>> symbol("omega_2_dot"), symbol("l_OA"), symbol("rddot"), symbol("lead")
    ('\\dot{\\omega}_2', 'l_{OA}', '\\ddot{r}', '\\text{lead}')
    >>> symbol("alpha_CD", vector=True)
    '\\boldsymbol{\\alpha}_{CD}'
    """
    base, *parts = name.split("_")
    if base in _FUNCTIONS and parts:
        return rf"\{base} {symbol('_'.join(parts))}"
    base, parts = _unglued(base, parts)
    while len(base) > 1 and _is_word(base) and parts and _is_word(parts[0]):
        base += f" {parts.pop(0)}"  # right_handed
    mark = next((_DOTS[p] for p in parts if p in _DOTS), "")
    letter = _letter(base, vector)
    letter = f"{mark}{{{letter}}}" if mark else letter
    indices = [p for p in parts if p not in _DOTS]
    if indices and indices[-1] == "mag":
        return f"|{letter}{_index(indices[:-1])}|"
    return letter + _index(indices)


@lru_cache(maxsize=1000)
def is_word(name: str) -> bool:
    """True if a name is a word, which no formula of a textbook would have: "lead", "speed_rate"."""
    return re.match(r"\|?(\\d?dot\{)?\\text\{", symbol(name)) is not None


def _unglued(base, parts):
    """Letter and parts of what is written together: rdot, x1, vA; and of rates written dx, da1."""
    if found := re.fullmatch(rf"({_LETTER})(d?dot)", base):
        return found[1], [found[2], *parts]
    if found := re.fullmatch(r"(d{1,2})([a-su-z])(\d*)", base):  # not dt
        return found[2], [found[1] + "ot", *filter(None, [found[3]]), *parts]
    if found := re.fullmatch(_GLUED, base):
        index = found["index"]
        return found["base"], [*(index if index[0] in "tn" else [index]), *parts]
    return base, parts


def _is_word(part):
    return part.islower() and len(part) > 2 and part not in (*GREEK, *_SHORT, *_DOTS, "mag")


def _letter(base, vector):
    base = _SHORT.get(base, base)
    if base in GREEK:
        return rf"\boldsymbol{{\{base}}}" if vector else rf"\{base}"
    # AB is the distance from A to B
    if len(base) == 1 or base.isupper():
        return rf"\mathbf{{{base}}}" if vector else base
    return rf"\text{{{base}}}"


def _index(parts):
    if "of" in parts:  # a term named after frames: of_arm_x_rod
        n = parts.index("of")
        named = r" \times ".join(rf"\text{{{p}}}" for p in parts[n + 1 :] if p != "x")
        text = ",".join([*map(_part_of_index, parts[:n]), named])
    else:
        text = ",".join(map(_part_of_index, parts))
    return f"_{text}" if len(text) == 1 else f"_{{{text}}}" if text else ""


def _part_of_index(part):
    if part in GREEK:
        return rf"\{part}"
    short = len(part) == 1 or re.fullmatch(r"[xyz]{2}|[A-Z]+[xyz]?\d*|\d+", part)
    return part if short else rf"\text{{{part}}}"


def unit_symbol(unit: str) -> str:
    r"""The LaTeX of a unit behind a number, with the space before it.

    >>> unit_symbol("kg*m^2/s"), unit_symbol("deg/s"), unit_symbol("1")
    ('\\ \\text{kg}\\,\\text{m}^2\\text{/s}', '^\\circ\\text{/s}', '')
    """
    if unit == "1":
        return ""
    if unit == "deg" or unit.startswith("deg/"):
        return r"^\circ" + bare_unit(unit.removeprefix("deg"))
    return r"\ " + bare_unit(unit)


def bare_unit(unit: str) -> str:
    """The LaTeX of a unit that stands alone."""
    parts = filter(None, re.split(r"(\*|\^\d+)", unit.replace("%", r"\%")))
    return "".join(r"\," if p == "*" else p if p[0] == "^" else rf"\text{{{p}}}" for p in parts)


def six_digits(x: float) -> str:
    """A number with six significant digits, a final 5 rounded up whatever the round-off.

    >>> six_digits(32.99925), six_digits(-32.99925 + 1e-14), six_digits(-0.0)
    ('32.9993', '-32.9993', '0')
    """
    return f"{float(_SIX.create_decimal(f'{x:.13g}')) + 0.0:.6g}"


def number_symbol(x: float) -> str:
    r"""The LaTeX of a number, floats with six significant digits.

    >>> number_symbol(0.6), number_symbol(3), number_symbol(-1.5e-7)
    ('0.6', '3', '-1.5 \\times 10^{-7}')
    """
    text = six_digits(x) if isinstance(x, float) else str(x)
    digits, _, power = text.partition("e")
    return rf"{digits} \times 10^{{{int(power)}}}" if power else digits


_NAME = rf"\b(?:(?:{'|'.join(GREEK)})(?:_\w+)?|[A-Za-z]_\w+|[rIJ][\dxyz])(?!\w)"
_FACTOR = rf"(?:{_NAME}|\b[A-Za-z]\b)"
_CROSSED = rf"(?:{_FACTOR}|\({_FACTOR} x {_FACTOR}\))"
_PRODUCT_OF = rf"(?:{_FACTOR} = )?(?:\d )?{_CROSSED}(?: x {_CROSSED})+"
_AXES = rf"(?:{_FACTOR} = )?{_FACTOR} cross {_FACTOR}"
_TERM = rf"(?:(?:{_FACTOR}|\bpi\b)(?:/\d\b)?|\d+(?:\.\d+)?(?: deg(?:rees?)?)?)(?!\w)"
_RELATION = rf"(?<![-+=<>/*] ){_TERM}(?: (?:[-+<>] |= -?){_TERM})+(?! ?[-+=<>/*^] ?[\w{{$(])"
_EQUAL_TO_GIVEN = r"(?:\b[A-Z]{2} = )?\b(?:[A-Za-z]|[A-Z]{2})(?= = \{)"  # PQ = SR = {a}
_WRITTEN_OUT = re.compile(
    rf"(?<![{{\w\\$`'])(?:{_AXES}|(?P<product>{_PRODUCT_OF})|{_RELATION}|{_EQUAL_TO_GIVEN}"
    rf"|{_NAME}(?:/\d\b)?)"
    r"(?![\w}`])"
)


def typeset_names(text: str, symbols: Mapping[str, str]) -> str:
    r"""A plain text with the names that it writes out as formulas: Greek letters, names with an
    index, sums and equations of names, cross products. What is in braces, dollar signs or
    backquotes stays. ``symbols``: {name: LaTeX} of those that are not written as :func:`symbol`
    says.

    >>> print(typeset_names("the rate of beta, 2 omega x v_r, {omega}; I_xx - I_yy = 0", {}))
    the rate of $\beta$, $2 \boldsymbol{\omega} \times \mathbf{v}_r$, {omega}; $I_{xx} - I_{yy} = 0$
    """
    return _WRITTEN_OUT.sub(lambda m: f"${_named(m, symbols)}$", text)


def _named(match, symbols):
    """A match in LaTeX; the factors of a cross product are vectors."""
    if match["product"]:
        product = match[0].replace(" x ", r" \times ")
        return re.sub(rf"(?<!\\){_FACTOR}", lambda m: symbol(m[0], vector=True), product)
    written = {"pi": r"\pi", " cross ": r" \times ", **symbols}
    text = re.sub(" deg(rees?)?", r"^\\circ", match[0])
    names = rf"(?<!\\)(?:\bpi\b| cross |{_FACTOR})"
    return re.sub(names, lambda m: written.get(m[0]) or symbol(m[0]), text)


_SUM, _PRODUCT, _POWER = 1, 2, 3  # precedence of what is written


def formula(tree: Tree, symbols: Mapping[str, str]) -> str:
    r"""The LaTeX of a formula tree, of a list of them, or of components in several frames;
    ``symbols`` as for :func:`typeset_names`.

    >>> formula(["*", 2, "r", ["^", "omega", 2]], {})
    '2 r \\omega^{2}'
    """
    if isinstance(tree, dict):
        parts = (rf"{formula(x, symbols)}\ \text{{in {_plain(f)}}}" for f, x in tree.items())
        return r",\ ".join(parts)
    return _written(tree, symbols)[0]


def _plain(text):
    return re.sub(r"[^\w' -]", " ", text)


def _written(tree, symbols):
    """(LaTeX, its precedence)."""
    if isinstance(tree, str):
        return symbols.get(tree) or symbol(tree) if tree != "pi" else r"\pi", _POWER
    if not isinstance(tree, list):
        tight = _SUM if tree < 0 else _PRODUCT if "e" in f"{tree:.6g}" else _POWER
        return number_symbol(tree), tight
    head, args = (tree[0], tree[1:]) if tree and isinstance(tree[0], str) else (None, tree)
    if head in _WRITERS:
        return _WRITERS[head](args, symbols)
    if head in _FUNCTIONS and len(args) == 1:
        return _function(head, args[0], symbols), _PRODUCT
    inside = list_symbol(_written(a, symbols)[0] for a in args)
    if head is None or head == "pi" or not args:
        return rf"\left[{inside}\right]", _POWER
    return rf"\operatorname{{{_plain(head)}}}\left({inside}\right)", _PRODUCT


def matrix_symbol(rows: Iterable[Iterable[str]]) -> str:
    r"""The LaTeX of a matrix, of rows of formulas.

    >>> matrix_symbol([["1", "0"], ["0", "2"]])
    '\\begin{bmatrix}1 & 0 \\\\ 0 & 2\\end{bmatrix}'
    """
    inside = r" \\ ".join(" & ".join(row) for row in rows)
    return rf"\begin{{bmatrix}}{inside}\end{{bmatrix}}"


def list_symbol(parts: Iterable[str]) -> str:
    """Formulas with commas between them; the braces make a minus the sign of what follows."""
    return r",\ ".join(f"{{{p}}}" if p.startswith("-") else p for p in parts)


def _function(head, argument, symbols, power=""):
    text, tight = _written(argument, symbols)
    alone = tight == _POWER and not isinstance(argument, list)
    return rf"\{head}{power} {text}" if alone else rf"\{head}{power}\left({text}\right)"


def _at_least(tight, tree, symbols):
    """What is written, in parentheses if its precedence is below ``tight``."""
    text, own = _written(tree, symbols)
    return text if own >= tight else rf"\left({text}\right)"


def _sum(args, symbols):
    text = ""
    for a in args:
        part = _at_least(_SUM, a, symbols)
        text += part if not text else f" - {part[1:]}" if part.startswith("-") else f" + {part}"
    return text, _SUM


def _product(args, symbols):
    """A product; what has a negative power is under the bar of a fraction, and -1 is a sign."""
    minus, over, under = "", [], []
    for n, a in enumerate(args):
        if n == 0 and isinstance(a, (int, float)) and a < 0:
            minus, a = "-", -a
            if a == 1 and len(args) > 1:
                continue
        if isinstance(a, list) and a[:1] == ["^"] and _is_negative(a[2]):
            under.append(a[1] if a[2] == -1 else ["^", a[1], -a[2]])
        else:
            over.append(a)
    top = _factors(over, symbols, alone=not minus or bool(under)) or "1"
    if under:
        top = rf"\frac{{{top}}}{{{_factors(under, symbols)}}}"
    return minus + top, _SUM if minus else _PRODUCT


def _is_negative(x):
    return isinstance(x, (int, float)) and x < 0


def _factors(args, symbols, alone=True):
    """Factors in a row; a single one needs no parentheses where it stands alone."""
    if len(args) == 1 and alone:
        return _written(args[0], symbols)[0]
    text = ""
    for a in args:
        part = _at_least(_PRODUCT, a, symbols)
        # 2 x 10^3 and 2 3 would be read as other numbers
        text += (r" \cdot " if part[0].isdigit() else " ") * bool(text) + part
    return text


def _quotient(args, symbols):
    over, under = (_written(a, symbols)[0] for a in args)
    return rf"\frac{{{over}}}{{{under}}}", _PRODUCT


def _raised(args, symbols):
    base, power = args
    if power in (0.5, ["/", 1, 2]):
        return rf"\sqrt{{{_written(base, symbols)[0]}}}", _POWER
    if _is_negative(power):
        return _product([["^", base, power]], symbols)
    if isinstance(base, list) and base[0] in _FUNCTIONS and isinstance(power, (int, float)):
        return _function(base[0], base[1], symbols, f"^{{{number_symbol(power)}}}"), _PRODUCT
    text, tight = _written(base, symbols)
    # (b with an index)^2 is fine as it is, (x^2)^3 and sin(x)^2 are not
    if tight < _POWER or isinstance(base, list):
        text = rf"\left({text}\right)"
    return f"{text}^{{{_written(power, symbols)[0]}}}", _PRODUCT


def _around(before, after):
    return lambda args, symbols: (before + _written(args[0], symbols)[0] + after, _POWER)


def _comparison(sign):
    return lambda args, symbols: (sign.join(_written(a, symbols)[0] for a in args), 0)


_WRITERS = {
    "+": _sum, "*": _product, "/": _quotient, "^": _raised, "sqrt": _around(r"\sqrt{", "}"),
    "Abs": _around(r"\left|", r"\right|"), "<": _comparison(" < "), "<=": _comparison(r" \le "),
}  # fmt: skip
