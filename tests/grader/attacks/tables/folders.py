"""Submissions that are not a notebook, or not a file, and what lies beside a notebook."""

import json
import os
import socket

from tests.grader.attacks.attack import Attack, edited

UNREADABLE = {"readable": False}


def text(content):
    return Attack(lambda scene: scene.hand_in(content), **UNREADABLE)


def place(make, **flags):
    """``make(path, scene)`` makes what is at the notebook's place."""

    def submission(scene):
        scene.folder.mkdir(parents=True)
        make(scene.folder / "ch04.ipynb", scene)

    return Attack(submission, **(flags or UNREADABLE))


def beside(make, **flags):
    """A notebook without answers, and what ``make(folder, scene)`` puts beside it."""

    def submission(scene):
        scene.hand_in(scene.sheet())
        make(scene.folder, scene)

    return Attack(submission, **flags)


def sparse(size):
    def make(path, scene):
        with open(path, "wb") as f:
            f.truncate(size)

    return make


def unix_socket(path, scene):
    with socket.socket(socket.AF_UNIX) as s:
        s.bind(f"/tmp/{scene.mark}.sock")
    os.rename(f"/tmp/{scene.mark}.sock", path)


def link_of_the_folder(scene):
    scene.folder.parent.mkdir(parents=True)
    scene.folder.symlink_to(scene.honest.parent)


def link_of_the_student(scene):
    scene.folder.parent.symlink_to(scene.honest.parents[1])


def named(name, content=b"x"):
    def make(folder, scene):
        path = os.path.join(os.fsencode(folder), os.fsencode(name))
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as f:
            f.write(content)

    return make


def links(folder, scene):
    for name, target in (("notes.txt", ".course_secret"), ("data.csv", "gradebook.db"),
                         ("pages", "personal"), ("submission_secret.txt", ".course_secret")):  # fmt: skip
        (folder / name).symlink_to(scene.course.path / target)


def pipes(folder, scene):
    (folder / "timestamp.txt").unlink(missing_ok=True)
    for name in ("timestamp.txt", "data.csv", "submission_secret.txt"):
        os.mkfifo(folder / name)


def many_files(folder, scene):
    for n in range(1500):
        (folder / f"{n}.txt").write_bytes(b"")


def deep_folders(folder, scene):
    path = folder
    for _ in range(100):
        path = path / "d"
        path.mkdir()
    (path / "x.txt").write_text("x")


ATTACKS = {
    "not JSON": text("# my homework\n"),
    "empty": text(""),
    "cut off": text('{"cells": [{"cell_type": "co'),
    "a list": text("[1, 2, 3]"),
    "cells that are not a list": text('{"cells": {"a": 1}, "nbformat": 4}'),
    "nested too deep": text("[" * 100_000),
    "bytes": text(b"\xff\xfe\x00\x89PNG"),
    "format 3": text('{"worksheets": [], "nbformat": 3, "nbformat_minor": 0, "metadata": {}}'),
    "twenty million values": text('{"cells": [' + "[]," * 20_000_000 + "[]]}"),
    "fifty megabytes of text": edited(
        lambda n, scene: n["cells"][4].update(source="#" + "x" * 50_000_000)
    ),
    "fifty megabytes of blank lines": edited(lambda n, scene: n["cells"][4].update(source="\n" * 25_000_000)),
    "more than is read": place(sparse(65 * 2**20)),
    "a folder": place(lambda path, scene: path.mkdir()),
    "a pipe": place(lambda path, scene: os.mkfifo(path)),
    "a socket": place(unix_socket),
    "a link to a neighbour's work": place(lambda path, scene: path.symlink_to(scene.honest)),
    "a link to the secret": place(lambda path, scene: path.symlink_to(scene.course.path / ".course_secret")),
    "a link without end": place(lambda path, scene: path.symlink_to("/dev/zero")),
    "a link to itself": place(lambda path, scene: path.symlink_to(path)),
    "a link to a neighbour's folder": Attack(link_of_the_folder, **UNREADABLE),
    "a link to a neighbour": Attack(link_of_the_student, **UNREADABLE),
    "another name": place(lambda path, scene: named("a\x1b[2J\x1b[1;1H\nada 11 of 11\x07\u202e.ipynb")(path.parent, scene)),
    "a name that is not text": place(lambda path, scene: named(b"\xff\xfe\x1b[31m.ipynb")(path.parent, scene)),
    "no file": place(lambda path, scene: None),
    "another notebook beside it": beside(named("ch05\x1b[31m\n[AutogradeApp] done.ipynb", b"{}")),
    "a file with a strange name": beside(named("x\x1b]0;title\x07\nEvil \u202e.txt")),
    "a file whose name is not text": beside(named(b"\xff\xfe.txt")),
    "a page in the place of the page": beside(named("ch04.html", b"<script>alert(1)</script>")),
    "a folder in the place of the page": beside(named("ch04.html/x", b"x")),
    "a folder for the partial file": beside(named(".ch04.ipynb.partial/x", b"x")),
    "a configuration": beside(named("nbgrader_config.py", b"import os; os.system('touch /tmp/configured')")),
    "links beside it": beside(links),
    "pipes beside it": beside(pipes),
    "a time in a folder": beside(lambda folder, scene: (folder / "timestamp.txt").mkdir()),
    "a time in the far future": beside(named("timestamp.txt", b"99999-01-01 10:00:00 UTC")),
    "a time with terminal codes": beside(named("timestamp.txt", b"\x1b[2J2026-01-01 10:00:00 UTC")),
    "many files": beside(many_files),
    "deep folders": beside(deep_folders),
    "a byte-order mark": Attack(lambda scene: scene.hand_in(b"\xef\xbb\xbf" + json.dumps(scene.sheet()).encode())),
}  # fmt: skip
