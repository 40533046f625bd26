"""What the repository holds: nothing by accident."""

import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
AT_THE_ROOT = {
    "ARCHITECTURE.md", "CHANGELOG.md", "CONTRIBUTING.md", "LICENSE", "README.md", "pyproject.toml",
    "chapters", "exercises", "grader", "newton_euler", "tests", "website",
    ".ci", ".gitignore", ".pre-commit-config.yaml",
}  # fmt: skip
KINDS = {
    ".css", ".html", ".in", ".ipynb", ".j2", ".js", ".json", ".md", ".po", ".py", ".pyi", ".svg",
    ".toml", ".txt", ".typ", ".typed", ".yaml",
}  # fmt: skip
WITHOUT_A_KIND = {".ci/run", ".ci/versions", ".gitignore", "LICENSE", "newton_euler/chapters"}


def tracked():
    """The paths that git tracks; skips the test outside of a checkout."""
    done = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True)
    if done.returncode:
        pytest.skip("not a checkout")
    return [Path(name) for name in done.stdout.split("\0") if name]


def test_nothing_is_at_the_root_that_is_not_listed():
    assert {path.parts[0] for path in tracked()} - AT_THE_ROOT == set()


def test_file_names_are_plain_and_of_known_kinds():
    for path in tracked():
        assert not any(part.startswith("-") or part != part.strip() for part in path.parts), path
        assert path.suffix in KINDS or str(path) in WITHOUT_A_KIND, path
        assert (ROOT / path).stat().st_size or path.name in ("__init__.py", "py.typed"), path


PATH = r"(?<![\w…/.-])[\w/-]+(?:\.(?:py|toml|po|yaml|txt|md\.j2|md)\b|/(?=[\s`,;:.)]|$))"


def test_each_path_that_the_architecture_names_exists():
    """A path may begin at any folder; ``_givens.py`` is the end of a name like the one before it."""
    text = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")
    named = set(re.findall(PATH, text.replace("/es", "/de")))  # Spanish, a language to add
    files = tracked()
    folders = {f"/{folder}/" for path in files for folder in path.parents}
    ends = (*folders, *(f"/{path}" for path in files))
    assert len(named) > 150
    assert not [
        p for p in named if not any(e.endswith(p if p[0] == "_" else f"/{p}") for e in ends)
    ]
