"""What is distributed to students."""

import io
import sys
import zipfile

import pytest

from exercises.catalogue import problem
from grader.practice import write_practice
from tests.grader.courses import REPOSITORY, ran, run


def built(folder):
    """The wheel of this checkout."""
    command = "pip", "wheel", "--no-deps", "-w", str(folder), str(REPOSITORY)
    code, out = run(*command, "--no-build-isolation", timeout=300)
    if code and "setuptools" in out:
        code, out = run(*command, timeout=300)
    assert code == 0, out
    (wheel,) = folder.glob("*.whl")
    return wheel


PRACTICE = """
import importlib.util, sys
for name in ("exercises", "grader", "IPython", "ipywidgets"):
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


@pytest.mark.slow
@pytest.mark.integration
def test_practice_needs_the_wheel_alone(tmp_path):
    """In a new environment, with what the wheel asks for and nothing else."""
    write_practice(tmp_path / "one.practice", [problem("4/16")], count=2, workers=1)
    wheel, python = built(tmp_path), tmp_path / "venv" / "bin" / "python"
    assert run(sys.executable, "-m", "venv", str(tmp_path / "venv"))[0] == 0
    install = str(python), "-m", "pip", "install", "-q", str(wheel)
    code, out = run(*install, timeout=600, PYTHONPATH="")
    if code and ("No matching distribution" in out or "connection" in out.lower()):
        pytest.skip("the dependencies of the wheel cannot be fetched")
    assert code == 0, out
    script = str(python), "-c", PRACTICE, str(tmp_path / "one.practice")
    out = ran(run(*script, cwd=tmp_path, PYTHONPATH=""))
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
