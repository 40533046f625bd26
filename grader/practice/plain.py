"""Texts for a terminal: names as typed, LaTeX formulas as plain text."""

import re
from collections.abc import Callable, Collection

_SPOKEN = {
    ",": " ", ";": " ", " ": " ", "!": "", "times": " x ", "cdot": " ",
    "nabla": "grad ", "dots": "...", "left": "", "right": "", "text": "",
    "varepsilon": "epsilon", "ge": " >= ", "le": " <= ", "neq": " != ", "quad": " ", "bar": "mean ",
}  # fmt: skip
_FUNCTIONS = r"\b(sin|cos|tan|cot|sqrt|ln|exp|log)"


def plain(text: str, names: Collection[str], quantity: Callable[[str], str] | None = None) -> str:
    """``text`` for a terminal: each ``{name}`` in ``names`` becomes the name, or at its first place
    outside formulas ``quantity(name)``.

    >>> plain(r"A drum turns with $\\dot\\theta = {omega}$, where {omega}.", {"omega"}, "{} = 2 1/s".format)
    'A drum turns with theta_dot = omega, where omega = 2 1/s.'
    """  # noqa: E501
    mentioned = set()

    def named(match):
        name = match[1]
        if name not in names:
            return match[0]
        if quantity is None or name in mentioned:
            return name
        mentioned.add(name)
        return quantity(name)

    parts = re.split(r"(\$[^$]*\$)", text)
    for n, part in enumerate(parts):
        parts[n] = formula(part[1:-1], names) if n % 2 else _NAMED.sub(named, part)
    joined = " ".join("".join(parts).split())
    return re.sub(r"\b(\w+) = \1 = ", r"\1 = ", joined)


_NAMED = re.compile(r"\{(\w+)\}")


def formula(latex: str, names: Collection[str] = ()) -> str:
    """A LaTeX formula as typed.

    >>> formula(r"\\mathbf A = {c} t^2\\,\\mathbf i - \\cos 2\\theta\\,\\mathbf j", {"c"})
    'A = c t^2 i - cos 2 theta j'
    >>> formula(r"\\mathbf R\\times\\ddot{\\mathbf R} + e^{-{k} x}", {"k"})
    'R x R_ddot + e^(-k x)'
    """
    # braces around a name of the problem are not a group: e^{-{k} x}
    text = _NAMED.sub(lambda m: f" {m[1]}" if m[1] in names else m[0], latex)
    text = re.sub(r"\\math(?:bf|rm)\b\s*", " ", text)
    text = re.sub(r"\\frac\{([^{}]*)\}\{([^{}]*)\}", r"(\1)/(\2)", text)
    text = re.sub(r"/(\d)\\pi", r"/(\1 pi)", text)
    text = re.sub(r"\\partial\s*", "d", text)
    text = re.sub(
        r"\\(d?dot)\b\s*(?:\{\s*\\?(\w+)\s*\}|\\?([A-Za-z]+))((?:_\w+)?)",
        lambda m: f" {m[2] or m[3]}{m[4]}_{m[1]} ",
        text,
    )
    text = re.sub(r"\^\{([^{}]*)\}", lambda m: f"^{_group(m[1])}", text)
    text = re.sub(r"_\{([^{}]*)\}", r"_\1", text)
    text = re.sub(r"\\([A-Za-z]+|.)", lambda m: _SPOKEN.get(m[1], f" {m[1]} "), text)
    text = re.sub(rf"{_FUNCTIONS}\s+\(", r"\1(", text.replace("{", "(").replace("}", ")"))
    text = re.sub(r" ([)\],^/_])", r"\1", re.sub(r"([(\[/]) ", r"\1", " ".join(text.split())))
    return re.sub(r"(^|[=(,] ?)([-+]) (?=\w)", r"\1\2", text).strip()


def _group(inside):
    inside = inside.strip()
    return inside if re.fullmatch(r"\w+", inside) else f"({inside})"
