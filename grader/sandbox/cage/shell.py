"""What a notebook offers besides Python, so that a cell runs as it did for the student: magics,
``?`` and ``!``, ``display``, ``get_ipython()``, ``_``, top-level ``await``.

IPython's own transformer reads what is not Python. A magic that runs Python (``%time``,
``%%capture``) runs it; all others do nothing.
"""

import ast
import builtins
import inspect
import linecache
import re
import sys
import types
from typing import Any

FILE = "<cell {}>"  # the file name of a cell, by its number
_FLAGS = ast.PyCF_ALLOW_TOP_LEVEL_AWAIT
_ASSIGNED = re.compile(r"\w+(?:, *\w+)* *=(?!=)[^;]*")  # a whole line that assigns
# options of %time and %timeit, which stand before the expression
_OPTIONS = re.compile(r"^(?:\s*(?:-[nrpv]\s*\d+|-[tcqo]+|--no-raise-error|--)(?=\s|$))*\s*")
_RUN = ("time", "prun", "memit", "mprun", "capture")
_PYLAB = (
    "import numpy\nimport matplotlib\nfrom matplotlib import pylab, mlab, pyplot\n"
    "np, plt = numpy, pyplot\nfrom matplotlib.pylab import *\nfrom numpy import *\n"
)


class Shell:
    """Runs cells in one namespace, ``names``, the module ``__main__`` of the student."""

    def __init__(self) -> None:
        sys.path.insert(0, "")  # where a cell may have written modules
        module = types.ModuleType("__main__")
        sys.modules["__main__"] = module  # where dataclasses and pickle look names up
        self.names = module.__dict__
        self._count = 0  # texts that were run
        self._displayed = {"_": "", "__": "", "___": ""}
        self._loop = None
        ipython = _IPython(self)
        self.names.update(
            __builtins__=builtins, display=_display, get_ipython=lambda: ipython, **self._displayed
        )

    def run(self, text: str) -> Any:
        """Run a cell; returns the value of its last expression that a notebook would show."""
        value, shown = self._run_text(text, self.names)
        if not shown or value is None:
            return None
        self._keep(value)
        return value

    def _run_text(self, text, names):
        """(the value of the last expression, whether a notebook shows it)."""
        self._count += 1
        file = FILE.format(self._count)
        codes = _in_two(text, file)
        if not codes:
            tree, text = _parse(text, file)
            codes = _in_order(tree, file)
        # as in IPython, so that inspect.getsource finds the functions of a cell
        linecache.cache[file] = len(text), None, text.splitlines(True), file
        value = None
        for code in codes:
            value = self._execute(code, names)
        return value, not _is_quiet(text)

    def _execute(self, code, names):
        value = eval(code, names)
        if code.co_flags & inspect.CO_COROUTINE:
            return self._wait(value)
        return value

    def _wait(self, coroutine):
        if self._loop is None:
            import asyncio

            self._loop = asyncio.new_event_loop()
            asyncio.set_event_loop(self._loop)
        return self._loop.run_until_complete(coroutine)

    def _keep(self, value):
        """Put a value that was shown into ``_``, unless the student has assigned to ``_``."""
        if any(self.names.get(name) is not old for name, old in self._displayed.items()):
            return
        self._displayed = {"_": value, "__": self._displayed["_"], "___": self._displayed["__"]}
        self.names.update(self._displayed)

    def run_python(self, text: str, names: dict[str, Any] | None = None) -> Any:
        """Run the Python in a magic; returns the value of its last expression."""
        return self._run_text(text, self.names if names is None else names)[0]


def is_cell(file: str) -> bool:
    """True for the file name of a cell."""
    return file.startswith("<cell ")


def _in_two(text, file):
    """The code of all lines but the last, and of the last if it is an assignment or an expression
    by itself, as in nearly all cells; else None. Parsing would take as long as compiling.
    """
    above, _, last = text.rstrip().rpartition("\n")
    mode = "exec" if _ASSIGNED.fullmatch(last) else "eval"
    try:
        # the lines above are complete if they compile: what follows is not part of them
        first = compile(above, file, "exec", _FLAGS)
        # it keeps its line, so that an error names that line
        code = compile("\n" * text.rstrip().count("\n") + last, file, mode, _FLAGS)
    except (SyntaxError, ValueError):  # _parse reports what is wrong, if anything is
        return None
    return (first, code) if "\r" not in text else None  # "\r" ends a line, too


def _in_order(tree, file):
    """The code of the statements, and that of the last expression, compiled once they have run."""
    last = None
    if tree.body and isinstance(tree.body[-1], ast.Expr):
        last = ast.Expression(tree.body.pop().value)
    yield compile(tree, file, "exec", _FLAGS)
    if last:
        yield compile(last, file, "eval", _FLAGS)


def _parse(text, file):
    """(the tree of a cell, its text as Python)."""
    try:
        return ast.parse(text, file), text
    except SyntaxError:
        # valid Python means the same to IPython; all else goes through its slow transformer
        from IPython.core.inputtransformer2 import TransformerManager

        text = TransformerManager().transform_cell(text)
        return ast.parse(text, file), text


def _is_quiet(text):
    """True if the last line ends in a semicolon, which keeps a notebook from showing the value."""
    last = text.rstrip().rpartition("\n")[2]
    return last.partition("#")[0].rstrip().endswith(";") or last.endswith(";")


def _display(*values, **_):
    """Replaces IPython's ``display``: there is nowhere to show anything."""


class _IPython:
    """Replaces the shell that ``get_ipython()`` returns."""

    def __init__(self, shell):
        self._shell = shell
        self.user_ns = shell.names

    def run_line_magic(self, name, line, *_, **__):
        """Run the Python in a line magic."""
        if name == "pylab":
            self._shell.run_python(_PYLAB)
        if name == "timeit":
            return self._time_it(_OPTIONS.sub("", line))
        if name in _RUN and name != "capture":
            return self._shell.run_python(_OPTIONS.sub("", line))
        return None

    def run_cell_magic(self, name, line, cell):
        """Run the Python under a cell magic."""
        if name == "timeit":
            return self._time_it(f"{_OPTIONS.sub('', line)}\n{cell}")
        if name == "time":
            return self._shell.run_python(f"{_OPTIONS.sub('', line)}\n{cell}")
        if name == "writefile":
            *options, file = line.split()
            with open(file, "a" if "-a" in options else "w") as f:
                f.write(cell)
        if name in _RUN:
            value = self._shell.run_python(cell)
            return None if name == "capture" else value
        return None

    magic = run_line_magic

    def _time_it(self, text):
        """Run it once; its names do not stay, as in IPython, which times it in a function."""
        self._shell.run_python(text, dict(self._shell.names))

    def run_cell(self, text, *_, **__):
        """Run a cell within a cell."""
        self._shell.run_python(text)

    ex = run_cell

    def ev(self, text):
        """The value of an expression."""
        return eval(text, self.user_ns)

    def getoutput(self, *_, **__):
        """The output of a shell command, which does not run."""
        return []

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return _Nothing()


class _Nothing:
    """Any other attribute of the shell: can be called, has every attribute, does nothing."""

    def __call__(self, *_, **__):
        return None

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return self
