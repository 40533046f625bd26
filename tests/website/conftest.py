"""The site of the real chapters, with a notebook that has everything a chapter may hold."""

import os
import shutil
from pathlib import Path

import pytest

from tests.grader.practice.conftest import practice_file  # noqa: F401
from tests.jupyterlab import LONG, chromium
from tests.once import once
from tests.website import sample
from tests.website.browser import served, wait

# it runs for minutes: its page is built without outputs
NOT_RUN = {"speed_and_accuracy"}
PRACTISED = ["ch04"]  # the problems that are checked on their pages: half a minute for all


@pytest.fixture(scope="session")
def site(tmp_path_factory):
    """The folder of the built pages; SITE=folder uses one that was built before."""
    if built := os.environ.get("SITE"):
        return Path(built)
    pytest.importorskip("myst_nb", reason="the site wants pip install -e '.[site]'")
    from website.build import build
    from website.notebooks import FOLDER

    def make(out):
        folder = tmp_path_factory.mktemp("notebooks")
        for path in FOLDER.glob("*.ipynb"):
            shutil.copy(path, folder)
        sample.write(folder / "sample.ipynb")
        build(
            out / "pages",
            folder=folder,
            run=lambda chapter: chapter.stem not in NOT_RUN,
            practised=PRACTISED,
        )

    return once(tmp_path_factory, "site", make)[0] / "pages"


@pytest.fixture(scope="module")
def address(site):
    """The address of the site on this machine."""
    with served(site) as found:
        yield found


@pytest.fixture(scope="module")
def driver(tmp_path_factory):
    """A headless browser whose ``get`` returns once the new page is there with its scripts: that of
    chromedriver may return while the page before, or a part of the new one, is shown.
    """
    with chromium(tmp_path_factory.mktemp("browser"), "1300,900") as found:
        found.set_script_timeout(LONG)
        get = found.get

        def get_whole(url):
            found.execute_script("window.left = true")
            get(url)
            wait(found, "!window.left && document.readyState === 'complete'", url)

        found.get = get_whole
        yield found
