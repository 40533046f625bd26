"""A call from a page: a name and arguments as JSON; its result or error, as JSON, too."""

import json
from importlib import import_module
from types import FunctionType

from newton_euler.algebra.errors import NewtonEulerError

from .late import missing, missing_in_words


def answer(name: str, arguments: str = "{}") -> str:
    """What the function ``name`` of this folder, "module.function", returns for these arguments by
    name: a JSON object {"value": …}, or {"error": words} if it fails, with {"needs": package} if a
    package is missing.

    >>> answer("cells.run", '{"page": "p", "cells": ["6 * 7"], "number": 0}')
    '{"value": {"shown": [["text/plain", "42"]]}}'
    >>> answer("cells.walk")
    '{"error": "the engine has no function cells.walk for pages"}'
    """
    try:
        return json.dumps({"value": _function(name)(**json.loads(arguments))}, allow_nan=False)
    except NewtonEulerError as error:
        return json.dumps({"error": str(error)})
    except Exception as error:
        if package := missing(error):
            return json.dumps({"needs": package, "error": missing_in_words(package)})
        return json.dumps({"error": f"{type(error).__name__}: {error}"})


def _function(name):
    """A public function that a module of this folder defines."""
    module, _, function = name.rpartition(".")
    if module.isidentifier() and not function.startswith("_"):
        full = f"{__package__}.{module}"
        found = getattr(import_module(full), function, None)
        if isinstance(found, FunctionType) and found.__module__ == full:
            return found
    raise NewtonEulerError(f"the engine has no function {name} for pages")
