"""Runs the cells in one namespace, reads the answers, and forks a paused copy at each test."""

import _signal  # signal.signal makes enums at each call, and this one is made for every cell
import contextlib
import importlib
import json
import math
import os
import signal
import struct
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from . import libraries
from .shell import Shell, is_cell

LINE_LIMIT = 2**16  # bytes of the receipt of one problem
ERROR_LIMIT = 500  # characters of an error
TEXT_LIMIT = 2**24  # bytes of the text of a test
TOO_LONG = "the answers are too long to be read"


class TimeLimit(Exception):
    """A cell ran longer than its time limit."""


@contextlib.contextmanager
def time_limit(seconds: float) -> Iterator[None]:
    """Raise :class:`TimeLimit` in a block that runs longer."""

    def too_long(*_):
        raise TimeLimit(
            f"the cell ran longer than {seconds:g} s; look for a loop that does not end, or a "
            "simplify of a long formula"
        )

    _signal.signal(signal.SIGALRM, too_long)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)


class Submission:
    """One submission. ``send`` is called with each line for the grader; ``tests`` are the sockets
    from which the copies receive the texts of the tests, in order.
    """

    def __init__(
        self, seconds: float, send: Callable[[bytes], object], tests: Iterable[int]
    ) -> None:
        self._shell, self._seconds = Shell(), seconds
        self._send, self._tests = send, list(tests)
        self._errors: dict[str, str | None] = {}  # errors by problem, since its givens
        self._answers = importlib.import_module("newton_euler.answers.receipts")

    def run(self, cells: Iterable[dict[str, Any]]) -> None:
        """Run cells as :meth:`grader.sandbox.Harvester.run` takes them, without hidden texts."""
        for cell in cells:
            getattr(self, "_" + cell["role"])(cell)

    def _run(self, cell):
        """A cell that belongs to no problem: its error counts for each problem that is open."""
        if error := self._error_of(cell["text"]):
            self._report({"name": cell["name"], "error": error})
            self._errors = {p: e or error for p, e in self._errors.items()}

    def _givens(self, cell):
        for name in cell["clear"]:
            self._shell.names.pop(name, None)
        self._errors[cell["problem"]] = self._error_of(cell["text"])

    def _answer(self, cell):
        error = self._error_of(cell["text"])
        self._errors[cell["problem"]] = self._errors.get(cell["problem"]) or error

    def _harvest(self, cell):
        forms, number = {}, cell["problem"]
        try:
            with time_limit(self._seconds):
                forms = {k: self._answers.Form.read(text) for k, text in cell["forms"].items()}
                given = {key: self._shell.names.get(key) for key in forms}
                read, faults = self._answers.record(forms, cell["symbols"], given)
        except BaseException as fault:
            why = f"{type(fault).__name__}: {fault}"[:300]
            read, faults = {}, dict.fromkeys(forms or cell["forms"], why)
        error = self._errors.pop(number, None)
        self._report(
            {"id": number, "answers": read, "faults": faults, "error": error},
            {"id": number, "answers": {}, "faults": {}, "error": TOO_LONG},
        )

    def _test(self, cell):
        socket = self._tests.pop(0)
        try:
            pid = os.fork()
        except OSError:
            pid = -1  # the submission has used up its processes; its test is not run
        if pid == 0:
            self._answer_test(socket)
        os.close(socket)
        self._error_of(cell["text"])

    def _error_of(self, text):
        """Run one cell; returns the error as a sentence, or None."""
        return self._outcome(text)["error"]

    def _outcome(self, text):
        """{"error": a sentence or None, "value": of the last expression}."""
        try:
            with time_limit(self._seconds):
                value = self._shell.run(text)
                return {"error": None, "value": _plain(value)}
        except SyntaxError as error:
            line = error.text or _line(text, error.lineno)
            why = f"{type(error).__name__}: {error.msg}, line {error.lineno}: {line.strip()}"
        except BaseException as error:
            why = _in_words(error)
        return {"error": why[:ERROR_LIMIT], "value": None}

    def _answer_test(self, socket):
        """In the copy: wait for the text, run it, send the outcome. Never returns."""
        try:
            libraries.restore()
            (length,) = struct.unpack("<I", _read(socket, 4))
            test = json.loads(_read(socket, min(length, TEXT_LIMIT)))
            outcome = {"token": test["token"], **self._outcome(test["text"])}
            os.write(socket, b"\n" + json.dumps(outcome).encode() + b"\n")
        finally:
            os._exit(0)

    def _report(self, record, if_too_long=None):
        line = json.dumps(record)
        if len(line) > LINE_LIMIT:
            line = json.dumps(if_too_long)
        self._send(line.encode() + b"\n")


def _plain(value):
    """A number as a float, other values as "other"."""
    if value is None:
        return None
    if isinstance(value, bool | str | bytes):
        return "other"
    try:
        number = float(value)
    except Exception:
        return "other"
    return number if math.isfinite(number) else "other"


def _in_words(error):
    try:
        message = "; ".join([str(error), *map(str, getattr(error, "__notes__", ()))])
    except BaseException:
        message = "an error whose message cannot be made"
    return f"{type(error).__name__}{_line_of(error)}: {message}"


def _line(text, number):
    lines = text.splitlines()
    return lines[number - 1] if 0 < (number or 0) <= len(lines) else ""


def _line_of(error):
    at, line = error.__traceback__, ""
    while at:
        if is_cell(at.tb_frame.f_code.co_filename):
            line = f", line {at.tb_lineno}"
        at = at.tb_next
    return line


def _read(fd, length):
    data = b""
    while len(data) < length:
        if not (chunk := os.read(fd, length - len(data))):
            raise EOFError("the grader has closed the socket")
        data += chunk
    return data
