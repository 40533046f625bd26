"""What README.md says to instructors works as it stands there, for an ordinary user."""

import json
import os
import re
import shutil
import subprocess

import pytest

from grader.assignment import problems_of
from grader.course import Course
from grader.demo import sample_students as sample
from tests.grader.courses import REPOSITORY, environment, points, read, total

README = (REPOSITORY / "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(
    r"(?s)```bash\n(.*?)```", README.partition("## For instructors")[2].partition("\n## ")[0]
)


def as_ordinary_user(script, home, cwd=REPOSITORY):
    """Run a shell script without root's privileges; returns its output."""
    command = ["bash", "-euo", "pipefail", "-c", script]
    if os.geteuid() == 0:
        if not shutil.which("unshare"):
            pytest.skip("no unshare")
        command = ["unshare", "-U", "--map-user=65534", "--map-group=65534", *command]
    variables = environment(HOME=str(home), COLUMNS="80", JUPYTER_NO_CONFIG="")
    done = subprocess.run(
        command, cwd=cwd, env=variables, text=True, capture_output=True, timeout=900, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout + done.stderr


def test_the_block_has_an_exchange_a_due_date_and_every_step():
    text = "".join(BLOCKS)
    for words in ("--exchange", "--due", "release_assignment", "collect", "release_feedback"):
        assert words in text


@pytest.mark.slow
@pytest.mark.integration
def test_the_commands_for_instructors_work_verbatim_for_an_ordinary_user(tmp_path):
    first, second = BLOCKS
    home, student = tmp_path / "home", tmp_path / "student"
    home.mkdir()
    (student / ".jupyter").mkdir(parents=True)
    output = as_ordinary_user(first, home)
    assert "Enrolled 1 student (ids from the column 'Username'" in output
    course = Course(home / "mechanics")
    for file in (course.path / "student").iterdir():
        shutil.copy(file, student / ".jupyter")
    as_ordinary_user("nbgrader fetch_assignment ch04 --student=ada", student, student)
    path = student / "ch04/ch04.ipynb"
    fetched = read(path)
    problems = problems_of(fetched)
    values = course.values("ch04", "ada", problems)
    texts = {p.id: sample.cell_text(p, sample.right_answers(p, values[p.id])) for p in problems}
    path.chmod(0o644)
    path.write_text(json.dumps(sample.fill_in(fetched, texts)))
    as_ordinary_user("nbgrader submit ch04 --student=ada", student, student)
    output = as_ordinary_user(second, home)
    assert "unsandboxed" not in output
    everything = sum(len(p.answers) for p in problems)
    assert total(points(course)["ada"]) == everything
    assert f'"Lovelace, Ada",,,ada,,{everything}' in (home / "ch04.csv").read_text()
    as_ordinary_user("nbgrader fetch_feedback ch04 --student=ada", student, student)
    (page,) = (student / "ch04/feedback").rglob("ch04.html")
    assert f"{everything} / {everything}" in page.read_text()
