"""Formulas of LaTeX as MathML, which browsers typeset without a script and without a network: on
the feedback page, and on the pages of the formgrader.
"""

import html
import re
from functools import lru_cache


@lru_cache(4096)
def mathml(latex, display="inline"):
    """A formula as MathML; what cannot be converted stays as it is, between dollar signs."""
    from latex2mathml.converter import convert

    try:
        made = convert(_RAISED.sub(_with_exponent, latex), display=display)
    except Exception:  # its errors have no base class, and an IndexError is among them
        return f"${html.escape(latex)}$"
    # it leaves the escape of a % in a text as it is; HTML needs no name of a space
    return _NAMESPACE.sub("", made, count=1).replace(r"\%", "%")


_NAMESPACE = re.compile(r' xmlns="[^"]*"')

# browsers without a mathematical font raise an exponent behind a word much too high
_RAISED = re.compile(r"\\text\{([^{}]*)\}\^(\d)")


def _with_exponent(match):
    return rf"\text{{{match[1]}{'⁰¹²³⁴⁵⁶⁷⁸⁹'[int(match[2])]}}}"


def unit_html(text, unit):
    """A text that ends with a unit as HTML, the unit with raised exponents."""
    if unit == "1" or not text.endswith(f" {unit}"):
        return html.escape(text)
    raised = re.sub(r"\^(\d+)", r"<sup>\1</sup>", html.escape(unit)).replace("*", "·")
    return html.escape(text.removesuffix(unit)) + raised
