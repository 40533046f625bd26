"""One argument of a valid call replaced by a bad value: was it answered, refused in words, or did
it end in an error from inside?
"""

import ast
import contextlib
import inspect
import io
import linecache
import multiprocessing
import resource
import signal
import tempfile
import time
import traceback
import warnings
from collections import Counter
from functools import cache
from zlib import crc32

from newton_euler import NewtonEulerError
from tests.fuzz import bad
from tests.fuzz.bad import bad_values, quantities

SECONDS = 3.0  # for one call
MEMORY = 6 << 30  # bytes for the calls of one name
OUTCOMES = ("answered", "refused", "raw", "slow")


class TimeIsUp(BaseException):
    """A call took too long."""


def variants(positional, named, skip):
    """(label of the argument, positional, named) with a slot: a function of the value to put in."""
    for n in range(skip, len(positional)):
        yield n, lambda x, n=n: ([*positional[:n], x, *positional[n + 1 :]], named)
    for name in named:
        yield name, lambda x, name=name: (positional, {**named, name: x})


def trials(f, call, every=None):
    """[(argument, bad value, its maker, the arguments with a value)] for every argument of the call.

    every : one call in this many, always the same ones
    """
    positional, named = call
    if inspect.isclass(f):
        positional = positional[1:]
    of_first = getattr(type(positional[0]), f.__name__, None) is f if positional else False
    skip = 1 if not inspect.isclass(f) and (of_first or "." in f.__qualname__) else 0  # self
    names = list(inspect.signature(inspect.unwrap(f)).parameters)
    return [
        (label, word, make, with_value)
        for slot, with_value in variants(positional, named, skip)
        for label in [slot if isinstance(slot, str) else names[min(slot, len(names) - 1)]]
        for word, make in bad_values().items()
        if not every or crc32(f"{f.__qualname__}|{label}|{word}".encode()) % every == 0
    ]


def judged(f, call, every=None, seconds=SECONDS):
    """[(argument, bad value, outcome, what came)] for the trials of a call."""
    return [
        (label, word, *outcome(f, *with_value(make()), seconds))
        for label, word, make, with_value in trials(f, call, every)
    ]


def outcome(f, positional, named, seconds=SECONDS):
    """(outcome, what came) of one call."""

    def stop(*_):
        raise TimeIsUp

    signal.signal(signal.SIGALRM, stop)
    try:
        # repeatedly: SciPy and others swallow errors raised while they call back
        signal.setitimer(signal.ITIMER_REAL, seconds, 0.2)
        with warnings.catch_warnings(), contextlib.redirect_stdout(io.StringIO()):
            warnings.simplefilter("ignore")
            result = f(*positional, **named)
            repr(result)
            if inspect.isgenerator(result):
                list(result)
        return "answered", type(result).__name__
    except TimeIsUp:
        return "slow", f"no answer in {seconds:g} s"
    except NewtonEulerError as error:
        return "refused", f"{type(error).__name__}: {error}"[:200]
    except Exception as error:
        message = f"{type(error).__name__}: {error}"[:200]
        # a/0 for the engine's numbers is what it is for Python's
        if is_operator(f) and isinstance(error, ArithmeticError):
            return "refused", message
        return ("refused" if in_words(error) else "raw"), f"{message} {place(error)}"
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)


def is_operator(f):
    """True for ``a + b`` and others."""
    return f.__name__.startswith("__") or f.__qualname__.startswith("_operation")


def trail(error):
    """[(file, line)] from the call to where the error was raised."""
    found = traceback.walk_tb(error.__traceback__)
    return [(frame.f_code.co_filename, line) for frame, line in found]


def place(error):
    """The line of the engine nearest to where the error was raised."""
    own = [(file, line) for file, line in trail(error) if "newton_euler" in file]
    return f"[{'/'.join(own[-1][0].split('/')[-2:])}:{own[-1][1]}]" if own else ""


def in_words(error):
    """True if an error was raised by a ``raise`` of the engine, or by the value itself."""
    file, line = trail(error)[-1]
    return file == bad.__file__ or ("newton_euler" in file and line in raising_lines(file))


@cache
def raising_lines(file):
    """The lines of a module that hold a ``raise``."""
    tree = ast.parse("".join(linecache.getlines(file)))
    return {
        line
        for node in ast.walk(tree)
        if isinstance(node, ast.Raise) and node.exc
        for line in range(node.lineno, node.end_lineno + 1)
    }


def judge_in_child(f, call, every, seconds, pipe):
    """Send what :func:`judged` finds; in a process that may be ended."""
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        found = judged(f, call, every, seconds)
    pipe.send(found)


def table(functions, calls, every=None, report=lambda *_: None, seconds=SECONDS):
    """{name: [(argument, bad value, outcome, what came)]}; each name in a process of its own."""
    context = multiprocessing.get_context("fork")
    bad_values()  # made once, and not in each child
    found = {}
    for name, f in functions.items():
        if name not in calls or not trials(f, calls[name], every):
            continue
        ours, theirs = context.Pipe(duplex=False)
        child = context.Process(
            target=judge_in_child, args=(f, calls[name], every, seconds, theirs)
        )
        child.start()
        theirs.close()
        limit = time.monotonic() + 240
        try:
            rows = ours.recv() if ours.poll(max(0, limit - time.monotonic())) else None
        except EOFError:
            rows = None
        if rows is None:
            child.kill()
            rows = [("?", "?", "slow", "the process had to be ended, or ended itself")]
        child.join()
        found[name] = rows
        report(name, rows)
    return found


def counts(rows):
    """How many rows have each outcome."""
    return Counter(row[2] for row in rows)


def stripped(rows):
    """The rows in which a quantity with a unit was taken."""
    return [row for row in rows if row[1] in quantities() and row[2] == "answered"]
