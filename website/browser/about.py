"""About the engine that a page has loaded."""

import sys

from newton_euler import __version__


def version() -> dict[str, str]:
    """The version of the engine and of Python.

    >>> sorted(version())
    ['engine', 'python']
    """
    return {"engine": __version__, "python": sys.version.partition(" ")[0]}
