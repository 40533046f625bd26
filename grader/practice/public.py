"""What everyone may practise: a practice file for each chapter, of numbers that are no course's.
They come with the wheel and with the site, and are made there: none is kept in the repository.
"""

from collections.abc import Callable, Collection
from pathlib import Path

import newton_euler
from exercises.catalogue import chapters, problems
from newton_euler.algebra.language import language, speaking

from .build import LeftOut, svg, write_practice
from .graded import graded_numbers, rules_of

COUNT = 4  # sets of numbers for each problem, the book's among them
SETS = Path(newton_euler.__file__).parent / "classroom" / "practising" / "sets"


def write_public(
    folder: Path = SETS,
    names: Collection[str] = (),
    course: Path | None = None,
    done: Callable[[], object] = lambda: None,
) -> list[LeftOut]:
    """Write ``ch04.practice`` … into a folder, by default where ``try_problem`` finds them; returns
    the problems that are left out.

    names : of chapters, by default all
    course : the folder of a course: nothing that is near its graded numbers is in the files, as for
        :func:`write_practice`
    done : called after each problem
    """
    with speaking(language()):  # not the course's, which is opened
        graded, rules = (graded_numbers(course), rules_of(course)) if course else (None, None)
    left = []
    for name in names or chapters():
        path = folder / f"{name}.practice"
        left += write_practice(
            path, problems(name), COUNT, graded=graded, rules=rules, done=done, draw=svg
        )
    return left
