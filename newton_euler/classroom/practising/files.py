"""Reads a practice file, which an instructor makes by ``python -m grader practice``. It may come
from anywhere: what is too large, does not fit together, or would write codes to a terminal is
refused in words. Nothing of it is run.
"""

import json
import math
import zipfile
from pathlib import Path
from typing import Any

from ...algebra.errors import NewtonEulerError
from ...algebra.language import Words, _, are_words
from ...algebra.units import unit
from ...answers.causes import DOES
from ...answers.forms import kind_named
from ...answers.messages import SpokenError, one_line
from .programs import OPERATIONS

FORMAT, READ = 7, (4, 5, 6, 7)  # a cause is words from 5 on, a text in 4
# the most that a student is shown: whether an answer is right and which mistake explains it; also
# the steps on the way, with hints; also the solution
HELP = "check", "hints", "solution"
MOST = 8 * 2**20  # bytes of one member; a problem with ten sets of numbers has 0.1 MB
# zipfile bounds what these methods unpack; with others 600 bytes may become a gigabyte
METHODS = zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED
DEEPEST = 32  # lists within lists; a file has less than ten
LONGEST = 200_000  # characters of one text, which is broken into lines in quadratic time


class PracticeFileError(SpokenError):
    """A practice file that cannot be read, or a problem that is not in it."""


class PracticeFile:
    """The problems of a practice file, each read when it is asked for.

    called : its name in errors; default: its path
    """

    def __init__(self, path: str | Path, called: str = ""):
        self.path = Path(path)
        self.called = called or str(path)
        if not self.path.exists():
            raise PracticeFileError(
                "there is no practice file {path}; it comes from your instructor, who writes "
                "it by: python -m grader practice ch04 -o ch04.practice",
                path=self.path,
            )
        head = self._json("practice.json")
        if not isinstance(head, dict) or head.get("format") not in READ:
            found = head.get("format") if isinstance(head, dict) else head
            text = Words(
                "{path} has format {found}; this version of newton_euler reads format "
                "{format}: install the version that your instructor used"
            )
            raise self._refusal(text, found=one_line(found), format=FORMAT)
        sound = _fits(head, HEAD) and head["help"] in HELP and head["problems"]
        if not sound or not set(head["problems"]) <= set(head["titles"]):
            raise self._refusal(Words("{path} is damaged: its list of problems cannot be read"))
        self.help: str = head["help"]
        self.problems: list[str] = head["problems"]
        self.titles: dict[str, list[str]] = head["titles"]

    def read(self, name: str) -> bytes:
        """One member of the archive."""
        try:
            with zipfile.ZipFile(self.path) as archive, archive.open(name) as member:
                if archive.getinfo(name).compress_type not in METHODS:
                    raise ValueError(f"{name} is compressed by a method that is not used here")
                content = member.read(MOST + 1)  # the size stated in an archive may be wrong
        # zipfile and its decompressors have a dozen errors for what is damaged
        except Exception as error:
            raise self._other_file(error) from error
        if len(content) > MOST:
            text = Words("{path}: {name} has more than {most} MB")
            raise self._refusal(text, name=name, most=MOST >> 20)
        return content

    def _json(self, name):
        try:
            found = json.loads(self.read(name))
            printable = _is_printable(found)
        except (ValueError, RecursionError) as error:
            if isinstance(error, PracticeFileError):
                raise
            raise self._other_file(error) from error
        if not printable:
            raise self._refusal(Words("{path}: {name} holds control characters"), name=name)
        return found

    def _refusal(self, sentence, **values):
        return PracticeFileError(sentence, path=self.called, **values)

    def _other_file(self, error):
        """The error for another file, in Python's own words: they are for its author."""
        return PracticeFileError(
            _("{path} is not a practice file", path=self.called) + f": {one_line(str(error))}"
        )

    def page(self, problem: str) -> dict[str, Any]:
        """What the file has of a problem, "4/16"."""
        if problem not in self.problems:
            text = Words("{file} has no problem {problem}; it has {all}")
            named = {"problem": repr(problem), "all": ", ".join(self.problems)}
            raise PracticeFileError(text, file=Path(self.called).name, **named)
        page: dict[str, Any] = self._json(f"{problem.replace('/', '-')}.json")
        for shape, missing in EARLIER:
            if _fits(page, shape):
                page |= {n: [row + missing for row in page[n]] for n in ("labels", "slips")}
        fits = _fits(page, PAGE) and page.get("help", HELP[0]) in HELP
        if not fits or not _fits(page.get("language", ""), str) or not _is_whole(page):
            text = Words("{path} is damaged: problem {problem} cannot be read")
            raise self._refusal(text, problem=problem)
        return page


# -- what a file must hold; {str: x}: names with an x each; (x, y): a list of an x and a y

NUMBER = int | float
TEXT = str | list  # English, or a template with its values, for any language
HEAD = {"help": str, "problems": [str], "titles": {str: (str, str)}}
QUANTITY = {
    **dict.fromkeys(("key", "kind", "unit", "means", "plain", "section"), str),
    **dict.fromkeys(("equation", "latex", "sum"), str),
    "atol": NUMBER, "of": [str], "step": bool,
}  # fmt: skip
VARIANT = {
    "givens": {str: (NUMBER, str, str)}, "statement": str, "text": str, "solution": str,
    "right": {str: str | int | list}, "wrong": [(int, object)], "terms": {str: [TEXT]},
    "program": dict | None, "slips": [(int, list)],
}  # fmt: skip
LABEL = (str, str, str, TEXT, TEXT, TEXT, str, TEXT)
SLIP = (str, int, str, TEXT, TEXT, TEXT, str, TEXT)
PAGE = {
    **dict.fromkeys(("id", "title", "section", "chapter", "preamble", "figure"), str),
    "where": TEXT,
    "book": bool, "quantities": [QUANTITY], "variants": [VARIANT],
    "labels": [LABEL], "slips": [SLIP],
}  # fmt: skip
# before format 6 nothing says what a cause does, and to what; in 4 it has no subject either
EARLIER = [(PAGE | {"labels": [LABEL[:-n]], "slips": [SLIP[:-n]]}, [""] * n) for n in (2, 3)]
PROGRAM = {"operations": [list], "quantities": {str: list}, "earlier": {str: [str]}}


def _fits(x, shape):
    if isinstance(shape, dict):
        names = x if str in shape else shape
        return isinstance(x, dict) and all(
            name in x and _fits(x[name], shape.get(str) or shape[name]) for name in names
        )
    if isinstance(shape, list):
        return isinstance(x, list) and all(_fits(part, shape[0]) for part in x)
    if isinstance(shape, tuple):
        return isinstance(x, list) and len(x) == len(shape) and all(map(_fits, x, shape))
    if isinstance(x, float):
        return isinstance(x, shape) and abs(x) < math.inf
    return isinstance(x, shape) and (not isinstance(x, int) or x.bit_length() < 1000)


def _is_printable(x, levels=DEEPEST):
    """True if no text in it has codes for a terminal, or turns the direction of reading; raises
    RecursionError where it nests deeper than a stack is sure to hold, ValueError of a long text.
    """
    if isinstance(x, str):
        if len(x) > LONGEST:
            raise ValueError(f"it has a text of {len(x)} characters")
        return x.replace("\n", "").replace("\t", "").replace("\xa0", "").isprintable()
    if not levels:
        raise RecursionError(f"it nests more than {DEEPEST} levels deep")
    parts = [*x, *x.values()] if isinstance(x, dict) else x if isinstance(x, list) else ()
    return all(_is_printable(part, levels - 1) for part in parts)


def _is_whole(page):
    """True if the parts of a page fit together."""
    try:
        kinds = {q["key"]: kind_named(q["kind"]) for q in page["quantities"]}
        units = [unit(q["unit"]) for q in page["quantities"]]
    except NewtonEulerError:
        return False
    return (
        len(kinds) == len(units) and page["variants"]
        and all(set(q) - {"rtol"} == set(QUANTITY) for q in page["quantities"])
        and all(_fits(q.get("rtol", 0.0), NUMBER) for q in page["quantities"])
        and _fits(page.get("symbols", {}), {str: str})
        and not any(kind.is_formula for kind in kinds.values())
        and all(group != "axes" or place.isdecimal() for _, group, place, *_ in page["labels"])
        and all(row[-2] in ("", *DOES) for row in (*page["labels"], *page["slips"]))
        and all(map(are_words, _texts(page)))
        and all(_is_variant(v, kinds, page) for v in page["variants"])
    )  # fmt: skip


def _texts(page):
    """The texts of causes and terms."""
    yield page["where"]
    for *_other, text, where, subject, _does, of in (*page["labels"], *page["slips"]):
        yield from (text, where, subject, of)
    for v in page["variants"]:
        yield from (text for texts in v["terms"].values() for text in texts)


def _is_variant(v, kinds, page):
    made = [(page["labels"], v["wrong"]), (page["slips"], v["slips"])]

    def is_answer(key, x):
        if kinds[key].is_word:
            return isinstance(x, kinds[key].python_type)
        return _fits(x, [NUMBER]) and len(x) == kinds[key].length

    return (
        isinstance(v.get("figure", ""), str)
        and all(key in kinds and is_answer(key, x) for key, x in v["right"].items())
        and all(0 <= n < len(rows) and rows[n][0] in kinds and is_answer(rows[n][0], x)
                for rows, own in made for n, x in own)
        and (v["program"] is None or _is_program(v["program"], kinds))
    )  # fmt: skip


def _is_program(program, kinds):
    """True if each operation is known and takes only numbers and what was computed before."""
    if not _fits(program, PROGRAM) or not set(program["quantities"]) <= set(kinds):
        return False
    operations = program["operations"]
    return all(
        step and isinstance(step[0], str) and step[0] in OPERATIONS
        and all(_fits(a, NUMBER) or (_fits(a, (int,)) and 0 <= a[0] < n) for a in step[1:])
        for n, step in enumerate(operations)
    ) and all(
        len(places) == kinds[key].length
        and all(x is None or _fits(x, NUMBER)
                or (_fits(x, (int, NUMBER)) and 0 <= x[0] < len(operations) and x[1])
                for x in places)
        for key, places in program["quantities"].items()
    )  # fmt: skip
