"""The difficulty of problems for the students of a course, from the scores of all assignments."""

from collections import defaultdict

from ..course import Course
from .records import part_scores


def measured(course: Course) -> dict[str, tuple[float, int]]:
    """{problem: (mean share of its points, number of sheets)} over all graded work."""
    earned: defaultdict[str, dict[tuple[str, str], list[float]]] = defaultdict(dict)
    for folder in sorted((course.path / "scores").glob("*/")):
        for e in part_scores(course, folder.name) if any(folder.glob("*.json")) else ():
            points = earned[e.problem].setdefault((folder.name, e.student), [0.0, 0.0])
            points[0], points[1] = points[0] + e.points, points[1] + e.out_of
    shares = {
        number: [points / most for points, most in sheets.values() if most]
        for number, sheets in earned.items()
    }
    return {n: (sum(found) / len(found), len(found)) for n, found in shares.items() if found}
