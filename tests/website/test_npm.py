"""Packages of npm: cached ones are checked, and a build goes on if npm cannot be reached."""

import base64
import hashlib
import io
import tarfile
import zipfile
from dataclasses import replace

from website import npm
from website.engine import ON_PAGES
from website.engine import zipped as for_pages
from website.kept import ROOT
from website.npm import Package


def packed(folder):
    """A package whose archive is kept in the folder."""
    folder.mkdir()
    path = folder / "small-1.0.tgz"
    with tarfile.open(path, "w:gz") as archive:
        found = tarfile.TarInfo("package/a.txt")
        found.size = 2
        archive.addfile(found, io.BytesIO(b"hi"))
    digest = base64.b64encode(hashlib.sha512(path.read_bytes()).digest()).decode()
    return Package("small", "1.0", f"sha512-{digest}")


def test_what_is_kept_needs_no_npm_and_is_not_used_once_it_was_changed(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", "")
    monkeypatch.setattr(npm, "CACHE", tmp_path)
    package = packed(tmp_path / "npm")
    assert package.files("a.txt") == {"a.txt": b"hi"}
    assert replace(package, integrity="sha512-other").files("a.txt") is None
    assert replace(package, version="2.0").files("a.txt") is None


def test_the_engine_for_pages_is_the_package_without_notebooks_the_same_each_time():
    contents = for_pages(ROOT / "newton_euler", *ON_PAGES)
    names = zipfile.ZipFile(io.BytesIO(contents)).namelist()
    assert {"website/browser/calls.py", "newton_euler/chapters/figures/ch04.py"} <= {*names}
    outside = [name for name in names if not name.startswith(("newton_euler/", "website/browser/"))]
    assert outside == ["website/__init__.py"]
    assert not [name for name in names if name.endswith((".ipynb", ".pyc"))]
    assert for_pages(ROOT / "newton_euler", *ON_PAGES) == contents
