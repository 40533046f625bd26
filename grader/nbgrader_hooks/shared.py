"""What several hooks share."""

import contextlib
import logging
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from typing import Any

from nbformat import NotebookNode
from traitlets import Unicode

Processed = tuple[NotebookNode, dict[str, Any]]  # what a preprocessor returns

# key in the resources of nbconvert: the path of the annotated notebook that grading has written
WRITTEN = "newton_euler_written"


STOPPED = 130  # exit code after Ctrl-C, as of a shell


@contextlib.contextmanager
def ending_at_ctrl_c(log: logging.Logger, how_far: Callable[[], str]) -> Iterator[None]:
    """Ctrl-C in the block ends the process with a sentence on how far it came, no traceback."""
    try:
        with _not_swallowed():
            yield
    except KeyboardInterrupt:
        log.error("Stopped by Ctrl-C: %s", how_far())
        sys.exit(STOPPED)


@contextlib.contextmanager
def _not_swallowed():
    """Ctrl-C comes again where Python ignores it, as in the callback of a weak reference."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def ignored(unraisable):
        if unraisable.exc_type is KeyboardInterrupt:
            signal.setitimer(signal.ITIMER_REAL, 0.01)
        else:
            hook(unraisable)

    hook, sys.unraisablehook = sys.unraisablehook, ignored
    alarm = signal.signal(signal.SIGALRM, signal.default_int_handler)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, alarm)
        sys.unraisablehook = hook


def course_path() -> Any:
    """The trait of a hook that holds the course folder."""
    return Unicode("", help="The course folder; set by grader.nbgrader_config.configure").tag(
        config=True
    )
