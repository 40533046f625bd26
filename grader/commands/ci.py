"""The command that writes the workflow by which a course's repository proves its problems."""

from pathlib import Path

import click

from .shared import FOLDER

TEMPLATES = Path(__file__).with_name("templates")
# {name of a template: where it is written}
FORGES = {
    "github": ".github/workflows/problems.yml",
    "pages": ".github/workflows/pages.yml",
    "gitlab": ".gitlab-ci.yml",
}


@click.command()
@click.argument("forge", type=click.Choice(list(FORGES)))
@click.option("--problems", "folder", default="problems", help="The folder of the problems there.")
@click.option("--to", default=Path("."), type=FOLDER, help="The repository; default: here.")
def ci(forge: str, folder: str, to: Path) -> None:
    """Write the workflow that proves and diagnoses a course's own problems at each push.

    It is for the repository of a course, and fails where a key is wrong, a text names what is not
    given, or a mistake passes for right. "pages" is the workflow that builds the site and puts it
    on GitHub Pages. A file that is there already is left as it is.
    """
    path = to / FORGES[forge]
    if path.exists():
        raise click.UsageError(f"{path} is there already; delete it to have it written anew")
    path.parent.mkdir(parents=True, exist_ok=True)
    text = (TEMPLATES / f"{forge}.yaml").read_text(encoding="utf-8")
    path.write_text(text.replace("{folder}", folder), encoding="utf-8")
    click.echo(path)
