"""Reads and writes files: our own as JSON, and those of students, of which nothing is believed."""

import contextlib
import json
import os
import shutil
import stat
from pathlib import Path

try:
    import orjson
except ImportError:  # the standard library does the same, and takes three times as long for figures
    orjson = None

PRIVATE = 0o600
MAX_FILES = 1000  # in one submission
MAX_DEPTH = 8  # of its folders


def read_json(path):
    """A notebook that this package or nbgrader wrote, as a plain dict with each cell's source as
    one string.
    """
    notebook = load_json(Path(path).read_bytes())
    for cell in notebook["cells"]:
        cell["source"] = "".join(cell["source"])  # nbgrader writes lists of lines
    return notebook


def load_json(data):
    """The value of JSON in UTF-8, as ``json.loads`` reads it, but for integers of more than 64
    bits, which may come as floats: notebooks have none.
    """
    if orjson:
        # it refuses what the standard library allows: NaN, halves of characters, deep nesting
        with contextlib.suppress(orjson.JSONDecodeError):
            return orjson.loads(data)
    return json.loads(data.decode("utf-8-sig"))  # some editors begin a file with a mark


def write_json(path, content, indent=1, mode=PRIVATE):
    """Write a dict as JSON, atomically and readable by its owner alone; ``indent=None`` is 20 times
    faster.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    write_text(path, json.dumps(content, ensure_ascii=False, indent=indent) + "\n", mode)


def write_notebook(path, notebook):
    """:func:`write_json` in one line, for notebooks of a whole class: they are mostly figures."""
    path.parent.mkdir(parents=True, exist_ok=True)
    _write(path, _as_json(notebook) + b"\n", PRIVATE)


def _as_json(content):
    if orjson:
        with contextlib.suppress(orjson.JSONEncodeError):  # an integer of more than 64 bits
            return orjson.dumps(content)
    return json.dumps(content, ensure_ascii=False, separators=(",", ":")).encode("utf-8")


def write_text(path, text, mode=PRIVATE):
    """Write a text file, atomically."""
    _write(path, text.encode("utf-8"), mode)  # what cannot be written leaves nothing behind


def _write(path, data, mode):
    partial = path.with_name(f".{path.name}.partial")
    partial.unlink(missing_ok=True)
    with open(os.open(partial, os.O_WRONLY | os.O_CREAT | os.O_EXCL, mode), "wb") as f:
        f.write(data)
    os.chmod(partial, mode)  # whatever the umask is
    os.replace(partial, path)


class NotTaken(ValueError):
    """A file of a submission that is not read, and why."""


def read_regular(path, limit, at=None):
    """The bytes of a regular file of at most ``limit`` bytes; otherwise :class:`NotTaken`.

    A link, a pipe or a device is not followed, waited for, or read; ``at`` is the descriptor of the
    folder in which ``path`` is.
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
            raise NotTaken("it belongs to somebody else than its folder")
        # room for its size, not for the limit, which would cost more than to read it; it may grow
        content = f.read(min(found.st_size, limit) + 1)
        if len(content) > found.st_size:
            content += f.read(limit + 1 - len(content))
    if len(content) > limit:
        raise NotTaken(f"it has more than the {limit / 1e6:.3g} MB that are read")
    return content


def _is_link(path, at):
    with contextlib.suppress(OSError):
        return stat.S_ISLNK(os.stat(path, dir_fd=at, follow_symlinks=False).st_mode)
    return False


def copy_regular(source, target, file_limit, limit, skip=()):
    """Copy the regular files below ``source`` into the new folder ``target``, which appears when it
    is complete; returns {name of what was left out: why}.

    file_limit, limit : in bytes, of one file and of all together. skip : names that are not copied.
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
