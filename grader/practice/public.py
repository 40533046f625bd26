"""The public practice files, one per chapter, with numbers that belong to no course. They are part
of the wheel and of the site, made there and not kept in the repository.
"""

from collections.abc import Callable, Collection
from pathlib import Path

import newton_euler
from exercises.catalogue import chapters, problems
from newton_euler.algebra.language import language, speaking

from .build import LeftOut, svg, write_practice
from .graded import graded_numbers, rules_of

COUNT = 4  # sets of numbers for each problem, including the book's
SETS = Path(newton_euler.__file__).parent / "classroom" / "practising" / "sets"


def write_public(
    folder: Path = SETS,
    names: Collection[str] = (),
    course: Path | None = None,
    done: Callable[[], object] = lambda: None,
) -> list[LeftOut]:
    """Write ``ch04.practice`` … into a folder, by default where ``try_problem`` finds them; returns
    the problems left out.

    names : of chapters, by default all
    course : the folder of a course, whose graded numbers are avoided as in :func:`write_practice`
    done : called after each problem
    """
    with speaking(language()):  # not in the language of the course, which Course sets
        graded, rules = (graded_numbers(course), rules_of(course)) if course else (None, None)
    left = []
    for name in names or chapters():
        path = folder / f"{name}.practice"
        left += write_practice(
            path, problems(name), COUNT, graded=graded, rules=rules, done=done, draw=svg
        )
    return left
