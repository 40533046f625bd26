"""The order in which workers take files: slow ones first, and the site, which shows what the tests
of the notebooks have run, after those. Each notebook is a separate piece of work.
"""

import gc
from collections import Counter
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

HERE = Path(__file__).parent
FIRST = (
    "chapters/test_chapters.py", "grader/attacks", "grader/scoring", "grader/assignment",
    "website/test_pages.py",  # builds the site: no worker with its other tests has to wait
    "exercises", "website", "grader", "fuzz", "stability",
)  # fmt: skip


# no deadline for property tests: other workers share the processors
settings.register_profile("busy", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("busy")


def leave_out(items):
    """Of the cases of a test marked ``one_in(k)`` mark all but each k-th ``slow``."""
    seen = Counter()
    for item in items:
        if (mark := item.get_closest_marker("one_in")) and not item.get_closest_marker("slow"):
            seen[item.function] += 1
            if seen[item.function] % mark.args[0] != 1:
                item.add_marker(pytest.mark.slow)


def pytest_configure(config):
    config.option.loadscopereorder = False  # xdist's own order: files with most tests first
    gc.disable()  # a fifth of the time in which tests are collected


def pytest_collection_finish():
    gc.freeze()  # what all tests have in common is not searched for garbage
    gc.enable()


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    if config.getoption("dist") != "loadscope":
        return None
    from xdist.scheduler import LoadScopeScheduling

    class ByFileAndNotebook(LoadScopeScheduling):
        def _split_scope(self, nodeid):
            scope = super()._split_scope(nodeid)
            return f"{scope}[{nodeid.partition('[')[2]}" if scope.endswith(FIRST[0]) else scope

    return ByFileAndNotebook(config, log)


@pytest.hookimpl(tryfirst=True)  # before slow tests are left out
def pytest_collection_modifyitems(items):
    leave_out(items)
    folders = [HERE / name for name in FIRST]
    place = lambda path: [n for n, folder in enumerate(folders) if path.is_relative_to(folder)]
    rank = {path: min(place(path), default=len(FIRST)) for path in {item.path for item in items}}
    items.sort(key=lambda item: rank[item.path])
