"""LaTeX formulas as MathML, which browsers typeset without script or network."""

import html
import re
from functools import lru_cache


@lru_cache(4096)
def mathml(latex: str, display: str = "inline") -> str:
    """A formula as MathML; one that cannot be converted is left in LaTeX, between dollar signs."""
    from latex2mathml.converter import convert

    raised = _RAISED.sub(lambda m: f"{m[1]}{_EXPONENTS[int(m[2])]}}}", latex)
    try:
        made = convert(raised, display=display)
    except Exception:  # the converter's errors have no base class, and an IndexError is among them
        return f"${html.escape(latex)}$"
    # the converter keeps the backslash of \% in a text; HTML needs no XML namespace
    return _NAMESPACE.sub("", made, count=1).replace(r"\%", "%")


_NAMESPACE = re.compile(r' xmlns="[^"]*"')

# browsers without a mathematical font place an exponent after a word much too high
_RAISED = re.compile(r"(\\text\{[^{}]*)\}\^(\d)")
_EXPONENTS = "⁰¹²³⁴⁵⁶⁷⁸⁹"


def unit_html(text: str, unit: str) -> str:
    """A text that ends with a unit as HTML, the unit with raised exponents."""
    if unit == "1" or not text.endswith(f" {unit}"):
        return html.escape(text)
    raised = re.sub(r"\^(\d+)", r"<sup>\1</sup>", html.escape(unit)).replace("*", "·")
    return html.escape(text.removesuffix(unit)) + raised
