"""Results cached between builds, under names that change with everything they depend on."""

import hashlib
import sys
from functools import cache
from pathlib import Path

from newton_euler.algebra.language import language

ROOT = Path(__file__).parents[1]


def fingerprint(*folders: str) -> str:
    """A hash of the files of the engine, the chapters and these folders, and of the sentences in
    the current language.
    """
    return _fingerprint(language(), *folders)


@cache
def _fingerprint(spoken, *folders):
    digest = hashlib.sha256(f"{sys.version} {spoken}".encode())
    for folder in ("newton_euler", "chapters", *folders):
        for path in sorted((ROOT / folder).rglob("*")):
            names = path.stem, path.parent.name
            other = path.suffix == ".po" and spoken not in names  # languages/de.po, de/ch09….po
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
