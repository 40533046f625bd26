"""The libraries that student code may use: imported once, and restored before a test runs."""

import gc
import importlib
import sys

PRELOAD = (
    "numpy", "sympy", "mpmath", "scipy.linalg", "scipy.optimize", "scipy.integrate",
    "numpy.testing", "newton_euler", "newton_euler.answers.receipts",
    # from which the first cell of every notebook imports names
    "newton_euler.kinematics", "newton_euler.classroom",
)  # fmt: skip
# packages that an instructor's tests use, and that run them; all of scipy would double the cost
TRUSTED = (
    "cage", "os", "posix", "json", "struct", "signal", "ast", "builtins", "math", "cmath",
    "operator", "fractions", "decimal", "numbers", "unittest", "numpy", "sympy", "mpmath",
    "newton_euler",
)  # fmt: skip
_as_imported: list = []


def load() -> None:
    """Import the libraries and remember the contents of their modules."""
    for name in PRELOAD:
        importlib.import_module(name)
    _warm_up()
    _as_imported[:] = [
        (module, dict(vars(module)))
        for name, module in list(sys.modules.items())
        if name.partition(".")[0] in TRUSTED
    ]


def load_ipython() -> None:
    """Import IPython when the first notebook needs it: that takes as long as a notebook."""
    if "IPython" not in sys.modules:
        importlib.import_module("IPython.core.inputtransformer2")
        importlib.import_module("IPython.display")
        gc.freeze()


def restore() -> None:
    """Restore what student code has replaced in the modules, so that a test that calls
    ``numpy.testing.assert_allclose`` calls numpy's.

    This stops simple tricks only. A test runs in the student's process, and one who knows this code
    can deceive it; answers in receipts are compared elsewhere, by code that no student reaches.
    """
    sys.settrace(None)
    sys.setprofile(None)
    gc.callbacks.clear()
    for module, held in _as_imported:
        now = vars(module)
        for name, value in held.items():
            if now.get(name) is not value:
                now[name] = value


def _warm_up():
    """Do once what every submission would have to repeat: the first sum imports sympy.tensor, which
    takes as long as all cells of a notebook together.
    """
    sympy = sys.modules["sympy"]
    x, y = sympy.symbols("x y", real=True)
    str(
        sympy.sqrt(sympy.sin(x) ** 2 / 3 + y * sympy.tan(x) - sympy.Abs(y))
        + sympy.Matrix([x + y, x, sympy.atan2(y, x)]).dot([y, x, 1]) * sympy.cos(x + y)
    )
