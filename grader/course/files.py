"""Reading and writing files: our own JSON, and students' files, which are not trusted."""

import contextlib
import json
import os
import shutil
import stat
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any

try:
    import orjson
except ImportError:  # the standard library is equivalent, but three times slower for figures
    orjson = None  # type: ignore[assignment]

PRIVATE = 0o600
MAX_FILES = 1000  # the most files in one submission
MAX_DEPTH = 8  # levels of folders


def read_json(path: str | Path) -> Any:
    """A notebook by this package or nbgrader, each cell's source as one string."""
    notebook = load_json(Path(path).read_bytes())
    for cell in notebook["cells"]:
        cell["source"] = "".join(cell["source"])  # nbgrader writes lists of lines
    return notebook


def load_json(data: bytes) -> Any:
    """Like ``json.loads``, for UTF-8; integers beyond 64 bits, which notebooks do not have, may
    become floats, lone surrogates, which no file takes, are replaced.
    """
    if orjson:
        # orjson refuses NaN, lone surrogates and deep nesting, which json allows
        with contextlib.suppress(orjson.JSONDecodeError):
            return orjson.loads(data)
    text = data.decode("utf-8-sig")  # some editors write a byte-order mark
    found = json.loads(text)
    if "\\ud" not in text.lower():
        return found
    return json.loads(json.dumps(found, ensure_ascii=False).encode("utf-8", "replace"))


def write_json(path: Path, content: Any, indent: int | None = 1) -> None:
    """Write JSON, atomically and private; ``indent=None`` is 20 times faster."""
    path.parent.mkdir(parents=True, exist_ok=True)
    write_text(path, json.dumps(content, ensure_ascii=False, indent=indent) + "\n")


def write_notebook(path: Path, notebook: Mapping[str, Any]) -> None:
    """:func:`write_json` without line breaks, faster for notebooks with figures."""
    path.parent.mkdir(parents=True, exist_ok=True)
    write_bytes(path, _as_json(notebook) + b"\n")


def _as_json(content):
    if orjson:
        with contextlib.suppress(orjson.JSONEncodeError):  # an integer beyond 64 bits
            return orjson.dumps(content)
    return json.dumps(content, ensure_ascii=False, separators=(",", ":")).encode("utf-8")


def write_text(path: Path, text: str, mode: int = PRIVATE) -> None:
    """Write a text file, atomically."""
    write_bytes(path, text.encode("utf-8"), mode)  # encoded first: a failure leaves no file


def write_bytes(path: Path, data: bytes, mode: int = PRIVATE) -> None:
    """Write a file, atomically."""
    partial = path.with_name(f".{path.name}.partial")
    partial.unlink(missing_ok=True)
    with open(os.open(partial, os.O_WRONLY | os.O_CREAT | os.O_EXCL, mode), "wb") as f:
        f.write(data)
    os.chmod(partial, mode)  # regardless of the umask
    os.replace(partial, path)


class NotTaken(ValueError):
    """A file of a submission is not read; the message says why."""


def read_regular(path: str | Path, limit: int, at: int | None = None) -> bytes:
    """The bytes of a regular file of at most ``limit`` bytes; else raises :class:`NotTaken`.

    Links are not followed, pipes and devices are not read; ``at`` is the descriptor of the folder
    of ``path``.
    """
    flags = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK
    try:
        descriptor = os.open(path, flags, dir_fd=at)
    except OSError as error:
        what = "a link" if _is_link(path, at) else error.strerror
        raise NotTaken(f"it cannot be read ({what})") from error
    found = os.fstat(descriptor)
    if not stat.S_ISREG(found.st_mode):
        os.close(descriptor)
        raise NotTaken("it is not a regular file")
    with open(descriptor, "rb") as f:
        if at is not None and found.st_uid != os.fstat(at).st_uid:  # a hard link to a neighbour's
            raise NotTaken("its owner is not that of its folder")
        # reserves the size of the file, which may grow, since reserving the limit costs more than
        # reading
        content = f.read(min(found.st_size, limit) + 1)
        if len(content) > found.st_size:
            content += f.read(limit + 1 - len(content))
    if len(content) > limit:
        raise NotTaken(f"it has more than the {limit / 1e6:.3g} MB that are read")
    return content


def _is_link(path: str | Path, at: int | None) -> bool:
    with contextlib.suppress(OSError):
        return stat.S_ISLNK(os.stat(path, dir_fd=at, follow_symlinks=False).st_mode)
    return False


def copy_regular(
    source: str | Path, target: str | Path, file_limit: int, limit: int, skip: Collection[str] = ()
) -> dict[str, str]:
    """Copy the regular files below ``source`` into the new folder ``target``, which appears when
    complete; returns {omitted name: reason}.

    file_limit, limit : in bytes, of one file and of all. skip : names not to copy.
    """
    source, target = Path(source), Path(target)
    partial = target.with_name(f".{target.name}.partial")
    shutil.rmtree(partial, ignore_errors=True)
    partial.mkdir(parents=True, mode=0o700)
    left_out, count, total = {}, 0, 0
    try:
        for folder, folders, names, at in os.fwalk(source, follow_symlinks=False):
            inner = Path(folder).relative_to(source)
            if len(inner.parts) >= MAX_DEPTH:
                folders.clear()
            for name in list(folders):
                if _is_link(name, at) or name in skip:
                    left_out[str(inner / name)] = "it is a link to a folder, or not wanted"
                    folders.remove(name)
            for name in sorted(set(names) - set(skip)):
                try:
                    if count >= MAX_FILES or total >= limit:
                        raise NotTaken("the submission has too many files, or too large ones")
                    content = read_regular(name, min(file_limit, limit - total), at)
                except NotTaken as reason:
                    if len(left_out) < 20:
                        left_out[str(inner / name)] = str(reason)
                    continue
                count, total = count + 1, total + len(content)
                place = partial / inner / name
                place.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
                with open(os.open(place, os.O_WRONLY | os.O_CREAT, PRIVATE), "wb") as f:
                    f.write(content)
        os.rename(partial, target)
    except BaseException:
        shutil.rmtree(partial, ignore_errors=True)
        raise
    return left_out
