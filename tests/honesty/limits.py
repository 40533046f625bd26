"""A limit of seconds around a piece of work."""

import signal
import sys
import threading
from contextlib import contextmanager


class TimeUp(BaseException):
    """The limit is over; no ``except Exception`` of what is measured takes it for its own."""


@contextmanager
def limited(seconds):
    """Raise :class:`TimeUp` inside after so many seconds; in the main thread only."""
    if threading.current_thread() is not threading.main_thread() or not hasattr(
        signal, "setitimer"
    ):
        yield
        return

    def ring(*_):
        raise TimeUp

    before = signal.signal(signal.SIGALRM, ring)
    # repeatedly: what is raised in the callback of a weak reference, or of the collector, is ignored
    signal.setitimer(signal.ITIMER_REAL, seconds, 0.2)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


@contextmanager
def frequent_switches():
    """Threads take turns every microsecond in what is inside, so that what they share shows."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    try:
        yield
    finally:
        sys.setswitchinterval(before)
