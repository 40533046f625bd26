"""Runs of the tests with a mutated module: each in a fork of this process, which has imported what
is slow to import but nothing under test.
"""

import ast
import contextlib
import importlib
import os
import pickle
import signal
import sys
import tempfile
import threading
import time
from importlib.machinery import SourceFileLoader
from importlib.util import spec_from_file_location
from pathlib import Path

import pytest

SLOW_IMPORTS = "numpy", "scipy.integrate", "mpmath", "sympy", "hypothesis", "heyoka", "symengine"
# plain: otherwise pytest would try to rewrite modules that are already imported
OPTIONS = "-x", "-q", "-p", "no:cacheprovider", "--assert=plain", "--tb=no"

LATE = -100


class TestsFailError(Exception):
    """Without any change the tests fail, or there are none."""


def warm_up():
    """Import what the tests will need, as far as it is installed."""
    for name in SLOW_IMPORTS:
        with contextlib.suppress(ImportError):
            importlib.import_module(name)


def module_name(path: Path) -> str:
    """The name by which the module of a file, relative to this folder, is imported."""
    parts = path.with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


class _Loader(SourceFileLoader):
    """Finds the module, and loads it from a syntax tree."""

    def __init__(self, name, path, tree):
        super().__init__(name, path)
        self.tree = tree

    def find_spec(self, name, path=None, target=None):
        return spec_from_file_location(name, self.path, loader=self) if name == self.name else None

    def get_code(self, fullname):
        return compile(self.tree, self.path, "exec")


class Watch:
    """A plugin of pytest that notes which lines of a file each test runs, and how long it takes."""

    def __init__(self, path):
        self.path, self.reached, self.now, self.seconds = path, {}, set(), {}

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_protocol(self, item):
        """Around each test."""
        self.now, begun = set(), time.perf_counter()
        sys.settrace(self._call)
        threading.settrace(self._call)
        yield
        sys.settrace(None)
        threading.settrace(None)
        self.reached[item.nodeid] = self.now
        self.seconds[item.nodeid] = time.perf_counter() - begun

    def _call(self, frame, event, argument):
        return self._line if frame.f_code.co_filename == self.path else None

    def _line(self, frame, event, argument):
        self.now.add(frame.f_lineno)
        return self._line


class Target:
    """One module and the tests that are to find its mutants: ``tree`` of its source, ``reached`` by
    each test as a set of lines, ``seconds`` that each takes, and those to ``start`` them.

    Raises :class:`TestsFailError` if they fail without any change.
    """

    def __init__(self, path: Path, tests: list[str]):
        self.path, self.name = str(path.resolve()), module_name(path)
        self.tests, self.tree = tests, ast.parse(path.read_text())
        watch = Watch(self.path)
        with tempfile.TemporaryFile() as file:
            code = _forked(lambda: self._watched(watch, file), 600.0)
            if code:
                raise TestsFailError(
                    f"the tests {' '.join(tests)} do not pass as they are: pytest returns {code}"
                )
            file.seek(0)
            self.reached, self.seconds, self.start = pickle.load(file)

    def _watched(self, watch, file):
        begun = time.perf_counter()
        code = pytest.main([*self.tests, *OPTIONS], plugins=[watch])
        start = time.perf_counter() - begun - sum(watch.seconds.values())
        pickle.dump((watch.reached, watch.seconds, start), file)
        file.flush()
        return code

    def relevant(self, mutant) -> list[str]:
        """The tests that run the mutant's lines, the shortest first."""
        chosen = [
            test
            for test, lines in self.reached.items()
            if mutant.always or not lines.isdisjoint(mutant.lines)
        ]
        return sorted(chosen, key=self.seconds.get)

    def killed(self, mutant, tests: list[str], limit: float) -> bool | None:
        """Whether a test fails or takes ten times as long; None beyond the limit, perhaps as usual."""
        loader = _Loader(self.name, self.path, mutant.applied(self.tree))

        def run():
            sys.meta_path.insert(0, loader)
            return pytest.main([*tests, *OPTIONS])

        # on a busy machine the imports alone take longer than many tests
        usual = self.start + sum(self.seconds[test] for test in tests)
        code = _forked(run, min(limit, 5.0 + 10 * usual))
        return None if code == LATE and limit < 5.0 + 10 * usual else code != 0


def _forked(run, limit):
    """What ``run`` returns in a fork; :data:`LATE` after this many seconds, negative if it dies."""
    child = os.fork()
    if not child:
        code = 3
        try:
            silence = os.open(os.devnull, os.O_WRONLY)
            os.dup2(silence, 1)
            os.dup2(silence, 2)
            sys.dont_write_bytecode = True
            code = int(run())
        finally:
            os._exit(code)
    until = time.monotonic() + limit
    while time.monotonic() < until:
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            return os.waitstatus_to_exitcode(status)
        time.sleep(0.01)
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    return LATE
