"""Results cached between builds, under names that change with everything they depend on."""

import hashlib
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from grader.course.processes import process_pool
from newton_euler.algebra.language import cached_by_language, language

ROOT = Path(__file__).parents[1]
CACHE = ROOT / ".site_cache"
# takes the number of things to do and returns a function that is called with the number done (1)
Start = Callable[[int], Callable[..., object]]


@cached_by_language
def fingerprint(*folders: str) -> str:
    """A hash of the files of the engine, the chapters and these folders, and of the sentences in
    the current language.
    """
    digest = hashlib.sha256(f"{sys.version} {language()}".encode())
    for folder in ("newton_euler", "chapters", *folders):
        for path in sorted((ROOT / folder).rglob("*")):
            names = path.stem, path.parent.name
            other = path.suffix == ".po" and language() not in names  # languages/de.po, de/ch09….po
            if path.is_file() and not other and path.suffix not in (".pyc", ".ipynb"):
                digest.update(f"{path.relative_to(ROOT)}\n".encode() + path.read_bytes())
    return digest.hexdigest()


def kept_name(stem: str, suffix: str, *contents: str) -> str:
    """A file name of ``stem`` and a hash of the contents."""
    digest = hashlib.sha256("\0".join(contents).encode()).hexdigest()[:16]
    return f"{stem}-{digest}{suffix}"


def store(path: Path, data: bytes) -> None:
    """Write bytes to ``path`` and delete earlier versions."""
    path.parent.mkdir(parents=True, exist_ok=True)
    stem, suffix = path.stem.rpartition("-")[0], path.suffix
    for old in path.parent.glob(f"{stem}-{'?' * 16}{suffix}"):
        old.unlink()
    path.write_bytes(data)


def complete(files: Mapping[Any, Path], make: Callable[[Any], bytes], start: Start) -> None:
    """Make the missing files of {key: file} by ``make(key)``, in several processes."""
    missing = [key for key, path in files.items() if not path.exists()]
    done = start(len(files))
    done(len(files) - len(missing))
    with process_pool() as pool:
        for key, data in zip(missing, pool.map(make, missing), strict=True):
            store(files[key], data)
            done()


def put(folder: Path, contents: bytes, suffix: str, stem: str = "") -> str:
    """Write a file that is named by a hash of its contents; returns the name."""
    folder.mkdir(parents=True, exist_ok=True)
    name = f"{stem}{hashlib.sha256(contents).hexdigest()[:16]}{suffix}"
    (folder / name).write_bytes(contents)
    return name
