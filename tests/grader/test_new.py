"""``grader new``: the files of a chapter's problems from its spec."""

from grader.commands.exercises import new
from tests.exercises.kinds.test_specs import SPEC


def test_the_command_prints_the_paths(tmp_path, capsys):
    spec, to = tmp_path / "ch02.yaml", str(tmp_path / "to")
    spec.write_text(SPEC)
    new.main(["ch02", "--spec", str(spec), "--to", to, "--only", "2/1"], standalone_mode=False)
    assert capsys.readouterr().out.split() == [f"{to}/ch02/p01.yaml", f"{to}/ch02/p01.py"]
