"""Reads a practice file, which an instructor makes by ``python -m grader practice``."""

import json
import zipfile
from pathlib import Path
from typing import Any

from ...algebra.errors import NewtonEulerError

FORMAT = 2
# the most that a student is shown: whether an answer is right and which mistake explains it; also
# the steps on the way, with hints; also the solution
HELP = "check", "hints", "solution"


class PracticeFileError(NewtonEulerError, ValueError):
    """A practice file that cannot be read, or a problem that is not in it."""


class PracticeFile:
    """The problems of a practice file, each read when it is asked for."""

    def __init__(self, path: str | Path):
        self.path = Path(path)
        try:
            head = json.loads(self.read("practice.json"))
        except FileNotFoundError:
            raise PracticeFileError(
                f"there is no practice file {self.path}; it comes from your instructor, who writes "
                "it by: python -m grader practice ch04 -o ch04.practice"
            ) from None
        except (zipfile.BadZipFile, KeyError, ValueError, OSError) as error:
            raise PracticeFileError(f"{self.path} is not a practice file: {error}") from error
        if head.get("format") != FORMAT:
            raise PracticeFileError(
                f"{self.path} has format {head.get('format')!r}; this version of newton_euler "
                f"reads format {FORMAT}: install the version that your instructor used"
            )
        self.help: str = head["help"]
        self.problems: list[str] = head["problems"]
        self.titles: dict[str, list[str]] = head["titles"]

    def read(self, name: str) -> bytes:
        """One member of the archive."""
        with zipfile.ZipFile(self.path) as archive:
            return archive.read(name)

    def page(self, problem: str) -> dict[str, Any]:
        """What the file has of a problem, "4/16"."""
        if problem not in self.problems:
            raise PracticeFileError(
                f"{self.path.name} has no problem {problem!r}; it has {', '.join(self.problems)}"
            )
        page: dict[str, Any] = json.loads(self.read(f"{problem.replace('/', '-')}.json"))
        return page
