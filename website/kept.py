"""Results that are kept between builds, each under a name that changes with all it depends on."""

import hashlib
import sys
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[1]


@cache
def fingerprint(*folders):
    """What changes when a file of the engine changes, or of these folders beside it."""
    digest = hashlib.sha256(sys.version.encode())
    for folder in ("newton_euler", "chapters", *folders):
        for path in sorted((ROOT / folder).rglob("*")):
            if path.is_file() and path.suffix not in (".pyc", ".ipynb"):
                digest.update(f"{path.relative_to(ROOT)}\n".encode() + path.read_bytes())
    return digest.hexdigest()


def kept_name(stem, suffix, *contents):
    """A file name made of ``stem`` and of all that the contents say."""
    digest = hashlib.sha256("\0".join(contents).encode()).hexdigest()[:16]
    return f"{stem}-{digest}{suffix}"


def store(path, data):
    """Write bytes to ``path`` and delete what was kept of the same thing before."""
    path.parent.mkdir(parents=True, exist_ok=True)
    stem, suffix = path.stem.rpartition("-")[0], path.suffix
    for old in path.parent.glob(f"{stem}-{'?' * 16}{suffix}"):
        old.unlink()
    path.write_bytes(data)
