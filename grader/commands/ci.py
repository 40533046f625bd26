"""The command ``ci``: a workflow that proves the problems in a course's repository."""

from pathlib import Path

import click

from .shared import FOLDER

TEMPLATES = Path(__file__).with_name("templates")
# {template: path in the repository}
FORGES = {
    "github": ".github/workflows/problems.yml",
    "pages": ".github/workflows/pages.yml",
    "gitlab": ".gitlab-ci.yml",
}


@click.command()
@click.argument("forge", type=click.Choice(list(FORGES)))
@click.option("--problems", "folder", default="problems", help="The folder of problems in it.")
@click.option("--to", default=Path("."), type=FOLDER, help="The repository; default: here.")
def ci(forge: str, folder: str, to: Path) -> None:
    """Write the workflow that proves and diagnoses a course's own problems at each push.

    It is for the repository of a course, and fails if a key is wrong, a text uses something not
    given, or a mistake passes for right. "pages" is the workflow that builds the site for GitHub
    Pages. An existing file is kept.
    """
    path = to / FORGES[forge]
    if path.exists():
        raise click.UsageError(f"{path} exists; delete it to have it written again")
    path.parent.mkdir(parents=True, exist_ok=True)
    text = (TEMPLATES / f"{forge}.yaml").read_text(encoding="utf-8")
    path.write_text(text.replace("{folder}", folder), encoding="utf-8")
    click.echo(path)
