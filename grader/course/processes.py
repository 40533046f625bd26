"""Ctrl-C: pools of processes that ignore it, and code in which it is never lost."""

import contextlib
import os
import signal
import sys
import threading
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from multiprocessing.context import BaseContext


@contextlib.contextmanager
def process_pool(
    workers: int | None = None, context: BaseContext | None = None
) -> Iterator[ProcessPoolExecutor]:
    """A pool of processes, by default one per processor. If the block raises, as by Ctrl-C, pending
    jobs are cancelled.
    """
    ignored = signal.SIGINT, signal.SIG_IGN
    with ProcessPoolExecutor(workers or os.cpu_count(), context, signal.signal, ignored) as pool:
        try:
            yield pool
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise


@contextlib.contextmanager
def ctrl_c_not_ignored() -> Iterator[None]:
    """Within the block, repeat a Ctrl-C that Python ignored, as in the callback of a weak
    reference.
    """
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
