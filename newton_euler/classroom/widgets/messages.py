"""Error messages as text."""

import textwrap
from collections.abc import Callable

from ...algebra.errors import checked


@checked
def error_message(f: Callable[[], object]) -> str:
    """The error that ``f()`` raises, as text in lines of 100 letters; AssertionError if none.

    >>> print(error_message(lambda: 1/0))
    ZeroDivisionError: division by zero
    """
    try:
        result = f()
    except Exception as error:
        return textwrap.fill(f"{type(error).__name__}: {error}", 100, subsequent_indent="    ")
    raise AssertionError(f"nothing was refused; the result is {result!r}")
