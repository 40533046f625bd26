"""What the README shows is what a reader gets."""

import contextlib
import doctest
import io
import re
from pathlib import Path

from exercises.catalogue import problem
from grader.practice import write_practice

README = (Path(__file__).parent.parent / "README.md").read_text(encoding="utf-8")


def test_the_example_prints_what_the_readme_says():
    code, after = re.search(r"```python\n(.*?)```\n\n(.*?)\n\n[^ ]", README, re.S).groups()
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(code, {})
    assert printed.getvalue().rstrip() == re.sub(r"(?m)^    ", "", after)


def test_the_two_commands_are_there_and_ci_calls_the_second():
    assert "pip install -e '.[fast,course]' && python -m grader demo" in README
    assert "pip install -e '.[dev]' && python -m pytest" in README
    assert "python -m pytest" in (Path(__file__).parent.parent / ".ci" / "run").read_text(
        encoding="utf-8"
    )


def test_the_practice_session_runs_as_printed(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_practice("ch04.practice", [problem("4/16")], count=2, workers=1)
    (session,) = re.findall(r"(?s)```pycon\n(.*?)```", README)
    output = []
    test = doctest.DocTestParser().get_doctest(session, {}, "README.md", "README.md", 0)
    doctest.DocTestRunner(verbose=False).run(test, out=output.append)
    assert not output, "".join(output)
