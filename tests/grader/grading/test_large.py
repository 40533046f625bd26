"""Large classes and large notebooks: memory does not grow with the number of submissions, and a
notebook that takes long delays only itself.
"""

import base64
import copy
import json
import os
import sys
import threading

import pytest

from grader.grading import grade, one
from tests.grader.courses import ran, run, submit
from tests.grader.submissions import RIGHT, work

FEW, MANY = 50, 500


# ru_maxrss would be that of the parent process if that is larger
SCRIPT = """
import re, sys
from grader.__main__ import main
main(sys.argv[1:], standalone_mode=False)
print(re.search(r"VmHWM:\\s+(\\d+)", open("/proc/self/status").read())[1])
"""


def peak(course):
    """The peak memory of ``python -m grader grade`` in MB."""
    output = ran(run(
        sys.executable, "-c", SCRIPT, "grade", "ch04", "--course", str(course.path),
        "--workers", "1",
    ))  # fmt: skip
    return int(output.split()[-1]) / 1024


@pytest.mark.slow
def test_memory_is_flat_in_the_number_of_submissions(ungraded):
    notebook = work(ungraded, "dan", p4_16="v_D = [1, 2, 3]")
    memory = {}
    for count in (FEW, MANY):
        students = [f"s{n:03d}" for n in range(count)]
        ungraded.enrol(students)
        for s in students:
            submit(ungraded, s, notebook)
        memory[count] = peak(ungraded)
        size = (ungraded.path / "submitted/s000/ch04/ch04.ipynb").stat().st_size / 2**20
    print(f"\npeak memory, MB: {memory}; a notebook has {size:.2f} MB")
    growth = (memory[MANY] - memory[FEW]) / (MANY - FEW)
    assert growth < 0.2 * size
    assert memory[MANY] < 1.3 * memory[FEW]


def with_output(notebook, text):
    notebook = copy.deepcopy(notebook)
    cell = next(c for c in notebook["cells"] if c["cell_type"] == "code")
    cell["outputs"] = [{"output_type": "display_data", "metadata": {}, "data": {"image/png": text}}]
    return notebook


@pytest.mark.slow
def test_a_notebook_of_60_mb_is_graded_within_a_few_hundred_mb(ungraded):
    picture = base64.b64encode(os.urandom(45 * 2**20)).decode()
    submit(ungraded, "ada", with_output(work(ungraded, "ada"), picture))
    submit(ungraded, "ben", work(ungraded, "ben"))
    memory = peak(ungraded)
    record = json.loads((ungraded.path / "scores/ch04/ada.json").read_text())
    assert sum(s["points"] for s in record["scores"]) == RIGHT["ada"]
    assert memory < 600


def test_a_slow_notebook_delays_nobody_else(fresh, monkeypatch):
    """ada's is held up until all others have their grades."""
    all_others, read = threading.Event(), one.read_notebook
    waiting, waited = set(fresh.roster()) - {"ada"}, []

    def slow(path):
        if path.parts[-3] == "ada":
            waited.append(all_others.wait(60))
        return read(path)

    def progress(result):
        waiting.discard(result.student)
        if not waiting:
            all_others.set()

    monkeypatch.setattr(one, "read_notebook", slow)
    results = grade(fresh, "ch04", force=True, progress=progress)
    assert waited == [True]
    assert {r.student: r.points for r in results} == {**RIGHT, "dan": 0}
