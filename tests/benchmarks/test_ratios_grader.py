"""How many times faster than nbgrader's own autograde do we grade? Both in one run, interleaved, on
the same submissions.
"""

import copy
import json
import logging
import shutil
import time
from statistics import median

import pytest

from exercises.catalogue import problems

pytestmark = [pytest.mark.benchmark, pytest.mark.slow, pytest.mark.filterwarnings("ignore")]
STUDENTS = tuple(f"s{n}" for n in range(8))
NBGRADERS = 2  # submissions that nbgrader grades in each round; it takes seconds for each
ROUNDS = 3


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    """A course with all 43 problems of the chapter, everyone's right answers handed in, with the
    figures of the numbers of the book.
    """
    from grader.assignment import build_assignment
    from grader.assignment import notebook as nb
    from grader.course import read_json, write_json
    from grader.demo import sample_students as sample
    from grader.demo.run import nbgrader_api, require_success

    course, path = build_assignment(tmp_path_factory.mktemp("ratios") / "c", "ch04")
    course.enrol(STUDENTS)
    require_success(nbgrader_api(course).generate_assignment("ch04"))
    released = course.released("ch04")
    figures = {
        c["metadata"]["newton_euler"]["problem"]: c["attachments"]
        for c in released["cells"]
        if "attachments" in c
    }
    for s in STUDENTS:
        values = course.values("ch04", s, problems("ch04"))
        own = copy.deepcopy(nb.personal_notebook(released, s, values, {}))
        for cell in own["cells"]:
            ours = cell["metadata"].get("newton_euler", {})
            if ours.get("role") == "statement":
                cell["attachments"] = figures[ours["problem"]]
        write_json(course.personal_path("ch04", s), own)
        texts = {
            p.id: sample.cell_text(p, sample.right_answers(p, values[p.id]))
            for p in problems("ch04")
        }
        write_json(course.path / "submitted" / s / "ch04/ch04.ipynb", sample.fill_in(own, texts))
    assert path.exists()
    assert read_json(path)
    return course


def _nbgraders_own(course):
    """nbgrader's API on the same submissions in a course folder of its own, configured as it comes."""
    from nbgrader.apps import NbGraderAPI
    from nbgrader.coursedir import CourseDirectory
    from traitlets.config import Config

    root = course.path.parent / "plain"
    root.mkdir()
    for name in ("release", "source", "submitted"):
        shutil.copytree(course.path / name, root / name)
    shutil.copy(course.path / "gradebook.db", root)
    config = Config()
    config.CourseDirectory.root, config.CourseDirectory.db_url = (
        str(root),
        f"sqlite:///{root / 'gradebook.db'}",
    )
    config.Execute.timeout = 120
    logging.getLogger("traitlets").setLevel(logging.CRITICAL)
    return NbGraderAPI(CourseDirectory(config=config), config=config)


def test_grading_all_43_problems_against_nbgraders_autograde(course):
    from grader.grading.run import _Run, grade, save_results
    from grader.sandbox import Harvester

    api, submitted = _nbgraders_own(course), course.submissions("ch04")
    ours, without_start, theirs, run, save = [], [], [], [], []
    with Harvester(2) as harvester:
        harvester.run("", []), harvester.run("", [])
        for n in range(ROUNDS):
            start = time.perf_counter()
            results = grade(course, "ch04", force=True)
            ours.append((time.perf_counter() - start) / len(STUDENTS))
            assert [r.points for r in results] == [
                sum(len(p.answers) for p in problems("ch04"))
            ] * len(STUDENTS)

            from concurrent.futures import ThreadPoolExecutor

            start = time.perf_counter()
            step = _Run(course, "ch04", True, "state")
            with ThreadPoolExecutor(2) as pool:
                results = list(
                    pool.map(
                        lambda s, run=step: run.grade(s, submitted[s], True, harvester), STUDENTS
                    )
                )
            run.append((time.perf_counter() - start) / len(STUDENTS))
            middle = time.perf_counter()
            save_results(course, "ch04", results)
            save.append((time.perf_counter() - middle) / len(STUDENTS))
            without_start.append((time.perf_counter() - start) / len(STUDENTS))

            start = time.perf_counter()
            for s in STUDENTS[n * NBGRADERS :][:NBGRADERS]:
                api.autograde("ch04", s, force=True)
            theirs.append((time.perf_counter() - start) / NBGRADERS)
    a, b, c = median(ours), median(without_start), median(theirs)
    figures = {
        "seconds a notebook, ours, with the start of the workers": round(a, 4),
        "without": round(b, 4),
        "of which running and scoring": round(median(run), 4),
        "gradebook": round(median(save), 4),
        "nbgrader": round(c, 3),
        "ratio with start": round(c / a, 1),
        "ratio": round(c / b, 1),
    }
    print("\n" + json.dumps(figures, indent=1))
    assert c / b > 10
