"""What is distributed to students."""

import io
import zipfile

import pytest

from tests.grader.courses import REPOSITORY, run


@pytest.mark.slow
def test_the_wheel_holds_the_engine_and_no_exercise(tmp_path):
    code, out = run(
        "pip",
        "wheel",
        "--no-deps",
        "--no-build-isolation",
        "-w",
        str(tmp_path),
        str(REPOSITORY),
        timeout=300,
    )
    if code and "setuptools" in out:
        code, out = run(
            "pip", "wheel", "--no-deps", "-w", str(tmp_path), str(REPOSITORY), timeout=300
        )
    assert code == 0, out
    (wheel,) = tmp_path.glob("*.whl")
    with zipfile.ZipFile(io.BytesIO(wheel.read_bytes())) as z:
        names = z.namelist()
        everything = "".join(
            z.read(n).decode("utf-8", "replace")
            for n in names
            if n.endswith((".py", ".yaml", ".json", ".ipynb"))
        )
    assert "newton_euler/classroom/answers.py" in names
    assert not [
        n for n in names if n.startswith(("exercises", "grader", "tests", "problems", "book"))
    ]
    assert not [n for n in names if n.endswith((".yaml", "p16.py"))]
    assert "no_coriolis:" not in everything
    assert "coriolis_of_horizontal_nozzle" not in everything
