"""What is distributed to students."""

import io
import os
import re
import sys
import zipfile

import pytest

from exercises.catalogue import problem
from grader.practice import write_practice
from tests.grader.courses import REPOSITORY, ran, run

README = (REPOSITORY / "README.md").read_text(encoding="utf-8")
STUDENTS, CHARTS = (
    re.findall(r"(?m)^    (.*)$", README.partition(f"## For {who}")[2].partition("\n## ")[0])
    for who in ("students", "developers")
)


def built(folder):
    """The wheel of this checkout."""
    command = "pip", "wheel", "--no-deps", "-w", str(folder), str(REPOSITORY)
    done = run(*command, "--no-build-isolation", timeout=300)
    ran(run(*command, timeout=300) if done[0] and "setuptools" in done[1] else done)
    (wheel,) = folder.glob("*.whl")
    return wheel


PRACTICE = """
import importlib.util, sys
for name in ("exercises", "grader", *sys.argv[2:]):
    assert importlib.util.find_spec(name) is None, name
from newton_euler.classroom import practice
p = practice(sys.argv[1])["4/16"]
print(p, p.check(a_D=[0, -7.38, -2.80592]), p.check_step(omega_CD=[-0.45, 0, 0.6]), p.next_step(),
      p.new(), p.solution(), sep="\\n")
try:
    p.form()
except ImportError as error:
    print(error)
"""


@pytest.fixture
def shell(tmp_path):
    """A function that runs a shell command in an empty environment, in its own folder."""
    assert run(sys.executable, "-m", "venv", str(tmp_path / "venv"))[0] == 0

    def typed(line, cwd=tmp_path):
        own = f"{tmp_path / 'venv/bin'}{os.pathsep}{os.environ['PATH']}"
        done = run("bash", "-c", line, cwd=cwd, timeout=900, PATH=own, PYTHONPATH="")
        if "No matching distribution found for numpy" in done[1]:
            pytest.skip("the dependencies of the wheel cannot be fetched")
        return ran(done)

    return typed


@pytest.mark.slow
@pytest.mark.integration
def test_what_the_readme_says_to_students_works_in_an_empty_environment(shell, tmp_path):
    built(tmp_path)
    install, chapters, jupyter = STUDENTS
    shell(install)
    assert "ch04" in shell(chapters)
    shell(jupyter.replace("DIR", "--version"))
    assert "top" in shell(CHARTS[0])
    assert "written: charts/top.png" in shell(f"{CHARTS[1]} --quick")


@pytest.mark.slow
@pytest.mark.integration
def test_the_engine_in_a_repository_of_its_own_is_installed_by_its_address(shell, tmp_path):
    (archive,) = re.findall(r"(git archive .*)$", README, re.M)
    (tmp_path / "engine").mkdir()
    shell(archive.replace("~", str(tmp_path)), REPOSITORY)
    shell("git init -q engine && cd engine && git add . && git commit -qm engine")
    found = ran(run("git", "-C", str(tmp_path / "engine"), "ls-files"))
    assert not re.search(r"(?m)^(exercises|grader|tests)|\.yaml$", found)
    (line,) = re.findall(r"(?m)^    (pip install .* @ git\+)https", README)
    shell(f"{line}file://localhost{tmp_path}/engine'")
    assert shell("pip show newton-euler").startswith("Name: newton-euler")


@pytest.mark.slow
@pytest.mark.integration
def test_practice_needs_only_the_wheel(shell, tmp_path):
    """In a new environment, with the wheel's dependencies and nothing else."""
    write_practice(tmp_path / "one.practice", [problem("4/16")], count=2, workers=1)
    (tmp_path / "practice.py").write_text(PRACTICE)
    shell(f"pip install -q {built(tmp_path)}")
    out = shell("python practice.py one.practice IPython ipywidgets")
    assert "leaves out the Coriolis term" in out
    assert "omega_CD: right" in out
    assert "p.form() needs ipywidgets: pip install ipywidgets" in out
    assert (tmp_path / "one.practice.progress.json").exists()


@pytest.mark.slow
def test_the_wheel_holds_the_engine_and_no_exercise(tmp_path):
    wheel = built(tmp_path)
    with zipfile.ZipFile(io.BytesIO(wheel.read_bytes())) as z:
        names = z.namelist()
        texts = [n for n in names if n.endswith((".py", ".yaml", ".json", ".ipynb"))]
        everything = "".join(z.read(n).decode("utf-8", "replace") for n in texts)
    assert "newton_euler/answers/receipts.py" in names
    others = "exercises", "grader", "tests", "problems", "book"
    assert not [n for n in names if n.startswith(others)]
    assert not [n for n in names if n.endswith((".yaml", "p16.py"))]
    assert "no_coriolis:" not in everything
    assert "coriolis_of_horizontal_nozzle" not in everything
