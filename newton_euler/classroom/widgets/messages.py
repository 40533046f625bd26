"""Error messages as text."""

import textwrap
from collections.abc import Callable

from ...algebra.errors import ArgumentError, checked


@checked
def error_message(f: Callable[[], object], width: int = 100) -> str:
    """The error that ``f()`` raises, as text in lines of ``width``; AssertionError if none.

    >>> print(error_message(lambda: 1/0))
    ZeroDivisionError: division by zero
    """
    if width < 1:
        raise ArgumentError(f"the lines have a width of 1 or more, got {width}")
    try:
        result = f()
    except Exception as error:
        return textwrap.fill(f"{type(error).__name__}: {error}", width, subsequent_indent="    ")
    raise AssertionError(f"nothing was refused; the result is {result!r}")
