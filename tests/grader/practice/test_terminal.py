"""Practice in a plain Python: python -c."""

import subprocess
import sys

from tests.grader.courses import environment

SCRIPT = """
import sys
sys.modules["ipywidgets"] = sys.modules["IPython"] = None
from newton_euler.classroom import practice
for name in practice(sys.argv[1], progress=None):
    p = practice(sys.argv[1], progress=None)[name]
    for part in (p, p.next_step(), p.next_step(), p.next_step(), p.solution()):
        print(part)
    print(p.new())
p = practice(sys.argv[1], progress=None)["4/16"]
print(p.check(a_D=[0, -7.38, -2.80592]))
print(practice(sys.argv[1], progress=None))
"""


def test_all_is_readable_in_a_terminal(practice_file):
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, practice_file],
        env=environment(), capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
    for sign in ("$", "{", "\\", "**", ", 1)"):
        assert sign not in done.stdout
    assert "a_D: not right; it fits a solution that leaves out the Coriolis term" in done.stdout
    assert max(map(len, done.stdout.partition("Numbers 1 of ")[0].splitlines())) <= 80
