"""Formulas typed in a text, converted to LaTeX."""

import re
from collections.abc import Callable, Mapping

from newton_euler.answers.notation import GREEK, symbol

_NAME = rf"(?:pi|d[a-zA-Z]|(?:{'|'.join(GREEK)}|[A-Za-z])(?:_\w+|\d+)?)(?!\w)"
_OPERAND = re.compile(
    r"(?P<minus>-)?(?:(?P<function>sqrt|sin|cos|tan|d)\(|(?P<bare>sin|cos|tan) (?=\w)|(?P<group>\()"
    rf"|(?P<number>\d+(?:\.\d+)?)(?!\w)|(?P<name>{_NAME})(?P<primes>'*)|(?P<word>\w+))"
)
_OPERATOR = re.compile(r" [-+=x] |[*/^]")
_START = re.compile(r"(?<![\w'/*^.$}{)-])[-\w(]")
_OPENED = {"sqrt": (r"\sqrt{", "}"), "d": ("d", ""), None: ("(", ")")}


def typeset_formulas(
    text: str, symbols: Mapping[str, str], rest: Callable[[str], str] = str
) -> str:
    r"""A text with its formulas in LaTeX between dollar signs; existing LaTeX is kept.

    symbols : {name: LaTeX} of names for which symbol() does not apply
    rest : applied to the text between formulas, and to existing LaTeX

    >>> print(typeset_formulas("a mass, m*r_1^2/2 of a disk: sqrt(r^2 - z'^2), -k x_0", {}))
    a mass, $m\,r_1^2/2$ of a disk: $\sqrt{r^2 - z'^2}$, $-k\,x_0$
    """
    parts = re.split(r"(\$[^$]*\$)", text)
    return "".join(rest(x) if n % 2 else _typeset(x, symbols, rest) for n, x in enumerate(parts))


def _typeset(text, symbols, rest):
    out, done = "", 0
    for match in _START.finditer(text):
        if match.start() >= done and (found := _Span(text, match.start(), symbols).found):
            latex, end = found
            if not text.startswith(" deg", end) and "\\times" not in latex:  # left to ``rest``
                out, done = f"{out}{rest(text[done : match.start()])}${latex}$", end
    return out + rest(text[done:])


class _Span:
    """The longest formula that begins at a position of a text.

    found : its LaTeX and its end; None for mere names, as P in a sentence
    """

    def __init__(self, text, start, symbols):
        self.text, self.symbols = text, symbols
        self.latex, self.closing, self.found = "", [], None
        self.weight = 0  # evidence for a formula; 2 is enough
        end = self._operand(start)
        while end is not None:
            if not self.closing and self.weight >= 2:
                self.found = self.latex, end
            end = self._next(end)

    def _next(self, at):
        """The end of the next operand or parenthesis, or None at the end of the formula."""
        if self.closing and self.text[at : at + 1] == ")":
            self.latex += self.closing.pop()
            return at + 1
        if operator := _OPERATOR.match(self.text, at):
            self.weight += 2
            self.latex += operator[0].replace("*", r"\,").replace("x", r"\times")
            return self._operand(operator.end())
        if self.text[at : at + 1] == " ":
            self.latex += r"\,"
            return self._operand(at + 1, beside=True)
        return None

    def _operand(self, at, beside=False):
        """The end of an operand; ``beside``: a factor of the one before."""
        found = _OPERAND.match(self.text, at)
        if found is None or (found["minus"] and self.latex and self.latex[-1] not in "({ "):
            return None
        if (beside or not self.latex) and (found["word"] or (beside and found["number"])):
            return None
        name = found["name"] or found["word"]
        sure = found["function"] or found["bare"] or found["primes"] or found["minus"]
        self.weight += 2 if sure or (beside and name and len(name) > 1) else beside
        self.latex += found["minus"] or ""
        if name or found["number"]:
            self.latex += (self._symbol(name) if name else found["number"]) + (
                found["primes"] or ""
            )
            return found.end()
        if found["bare"]:
            self.latex += rf"\{found['bare']} "
        else:
            function = found["function"]
            opened, closing = _OPENED.get(function, (rf"\{function}(", ")"))
            self.latex += opened
            self.closing.append(closing)
        return self._operand(found.end())

    def _symbol(self, name):
        if name == "pi":
            return r"\pi"
        return name if re.fullmatch("d[a-zA-Z]", name) else self.symbols.get(name) or symbol(name)
