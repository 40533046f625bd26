"""Where an error arose: in the engine, or in a function that the caller passed."""

import linecache
import sys
from collections.abc import Iterator
from traceback import walk_tb
from types import FrameType

from .scalars import LIBRARIES, NewtonEulerError

# top-level modules: a frame of any other one is that of a function that the caller passed; the
# empty name is that of generated code
_NOT_A_CALLERS = {"newton_euler", "scipy", "", *LIBRARIES, *sys.stdlib_module_names}


def package_of(frame: FrameType) -> str:
    """The top-level package of the code of a frame; "" for generated code."""
    return frame.f_globals.get("__name__", "").partition(".")[0]


def callers_places(error: BaseException) -> Iterator[tuple[FrameType, int]]:
    """Pairs (frame, line) of the caller's functions in a traceback, below where it was caught."""
    caught = error.__traceback__
    for frame, line in walk_tb(caught and caught.tb_next):
        if package_of(frame) not in _NOT_A_CALLERS:
            yield frame, line


def callers_line(error: BaseException) -> str:
    """The line of a function of the caller in which an error arose, "" if there is none."""
    places = list(callers_places(error))
    if not places:
        return ""
    frame, number = places[-1]
    return linecache.getline(frame.f_code.co_filename, number).strip()


def raised_by_the_engine(error: BaseException) -> bool:
    """True if the engine itself raised this error, False if a function that it called did."""
    packages = [package_of(frame) for frame, _ in walk_tb(error.__traceback__)]
    return packages[-1:] == ["newton_euler"]


def at_a_place(error: Exception, kind: type[Exception], place: str, advice: str = "") -> None:
    """Add the ``place`` to an error that was raised while a function of the caller was called. It
    is a note, since the error reaches the caller as raised; one of the engine becomes a ``kind`` of
    error, with ``advice``.
    """
    if isinstance(error, NewtonEulerError) or raised_by_the_engine(error):
        raise kind(f"{place}: {error}{advice}") from error
    error.add_note(f"{place}{advice}")
