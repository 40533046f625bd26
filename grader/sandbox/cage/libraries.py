"""The libraries that student code may use: imported once, and restored before a test runs."""

import gc
import importlib
import sys
from collections.abc import Iterable

PRELOAD = (
    "numpy", "sympy", "mpmath", "numpy.testing", "newton_euler", "newton_euler.answers.receipts",
    # modules from which the first cell of every notebook imports names
    "newton_euler.kinematics", "newton_euler.classroom",
)  # fmt: skip
# needed by few notebooks: forking a process that holds them takes twice as long
LATER = {
    "IPython": ("IPython.core.inputtransformer2", "IPython.display"),
    "scipy": ("scipy.linalg", "scipy.optimize", "scipy.integrate"),
}
# what runs an instructor's tests, and what these use; all of scipy would double the cost
TRUSTED = (
    "cage", "os", "posix", "json", "struct", "signal", "ast", "builtins", "math", "cmath",
    "operator", "fractions", "decimal", "numbers", "unittest", "numpy", "sympy", "mpmath",
    "newton_euler",
)  # fmt: skip
_as_imported: list = []


def load() -> None:
    """Import the libraries."""
    for name in PRELOAD:
        importlib.import_module(name)


def remember() -> None:
    """Remember the contents of the modules, to restore them."""
    _as_imported[:] = [
        (module, dict(vars(module)))
        for name, module in list(sys.modules.items())
        if name.partition(".")[0] in TRUSTED
    ]


def load_more(names: Iterable[str]) -> None:
    """Import libraries once a notebook needs them: importing takes as long as a notebook runs."""
    for name in names:
        if LATER[name][-1] not in sys.modules:
            for module in LATER[name]:
                importlib.import_module(module)
            gc.freeze()


def restore() -> None:
    """Restore what student code has replaced in the modules, so that a test that calls
    ``numpy.testing.assert_allclose`` calls numpy's.

    This stops simple tricks only. A test runs in the student's process, and a student who knows
    this code can deceive it; answers in receipts are compared elsewhere, by code that no student
    reaches.
    """
    sys.settrace(None)
    sys.setprofile(None)
    gc.callbacks.clear()
    for module, original in _as_imported:
        now = vars(module)
        for name, value in original.items():
            if now.get(name) is not value:
                now[name] = value
