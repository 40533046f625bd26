"""Errors in the code of a problem, worded for its author: file, line, and the likely name."""

import builtins
import math
import re
import traceback
from collections.abc import Iterable
from pathlib import Path

from newton_euler.algebra.names import nearest

from .model import Givens
from .places import EXERCISES, folder_and_file, home, homes


def meant(name: object, known: Iterable[str], form: str = "{}") -> str:
    """ "; did you mean omega?", or "" if no known name is similar."""
    found = nearest(name, known, 0.6)  # low enough for a_C to suggest a_G
    return f"; did you mean {form.format(found)}?" if found else ""


def error_sentence(problem_id: str, error: Exception) -> str:
    """The error as a sentence, with the line of the problem's own code in which it was raised."""
    folder = home(folder_and_file(problem_id)[0])
    frames = list(traceback.walk_tb(error.__traceback__))
    own = [f for f in frames if Path(f[0].f_code.co_filename).parent == folder]
    if isinstance(error, SyntaxError) and len(error.args) > 1:
        # the attributes of an error are lost on the way from a process of Dask
        message, (file, line, *_) = error.args
        return f"{_tail(file)}, line {line}: {message}"
    if not own:
        return _words(error)
    (first, _), (last, line) = own[0], own[-1]
    name = "" if first.f_code.co_name == "<module>" else f"{first.f_code.co_name}: "
    return f"{name}{_tail(last.f_code.co_filename)}, line {line}: {_reason(error, last, line)}"


def of_own_problem(error: Exception) -> str:
    """The error as a sentence if a course's own problem raised it, in any process; or ""."""
    text = "".join(traceback.format_exception(error))
    for file, line in reversed(re.findall(r'File "([^"\n]+)", line (\d+)', text)):
        folder = Path(file).parent
        if folder.parent != EXERCISES and homes().get(folder.name) == folder:
            words = error_sentence(f"{folder.name}/1", error)  # any problem of its chapter
            return words if _tail(file) in words else f"{_tail(file)}, line {line}: {words}"
    return ""


def _tail(file):
    return "/".join(Path(file).parts[-2:])


def _reason(error, frame, line):
    if isinstance(error, NotImplementedError):
        return "not written yet"
    if isinstance(error, TypeError) and (used := _of_math(frame, line)):
        return f"take {used} from newton_euler: math takes numbers only"
    if isinstance(error, AttributeError) and isinstance(error.obj, Givens):
        known = error.obj.names
        there = f"there are {', '.join(known) or 'none'}"
        return f"no given {error.name!r}{meant(error.name, known) or '; ' + there}"
    known = ()
    if isinstance(error, AttributeError):
        known = dir(error.obj)
    elif isinstance(error, NameError):
        known = {**frame.f_locals, **frame.f_globals, **vars(builtins)}
    return _words(error) + meant(getattr(error, "name", None), known)


def _words(error):
    """The message of an error: alone if it is the engine's, else after the name of its type."""
    if type(error).__module__.startswith("newton_euler"):
        return str(error)
    return f"{type(error).__name__}: {error}"


def _of_math(frame, line):
    """The function of the module math that this line uses, or ""."""
    text = Path(frame.f_code.co_filename).read_text(encoding="utf-8").splitlines()[line - 1]
    for name in re.findall(r"[A-Za-z_][\w.]*", text):
        owner, _, function = name.rpartition(".")
        found = frame.f_globals.get(owner or name)
        if found is math or getattr(found, "__module__", "") == "math":
            return function
    return ""
