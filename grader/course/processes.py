"""A pool of processes that Ctrl-C leaves to the one that started it."""

import contextlib
import os
import signal
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from multiprocessing.context import BaseContext


@contextlib.contextmanager
def process_pool(
    workers: int | None = None, context: BaseContext | None = None
) -> Iterator[ProcessPoolExecutor]:
    """A pool of processes, by default one per processor. Where the block raises, as by Ctrl-C,
    what has not begun is never run.
    """
    ignored = signal.SIGINT, signal.SIG_IGN
    with ProcessPoolExecutor(workers or os.cpu_count(), context, signal.signal, ignored) as pool:
        try:
            yield pool
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
