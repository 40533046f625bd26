"""The command that writes the workflow by which a course's repository proves its problems."""

from pathlib import Path

import click

from .shared import FOLDER

GITHUB = """\
# Proves the problems of this repository at each push; a fault fails the run.
# COURSEWARE is a variable of the repository: the address of the checkout that has grader/
name: problems
on: [push, pull_request]
jobs:
  prove:
    runs-on: ubuntu-latest
    env:
      PYTHONPATH: ${{{{ github.workspace }}}}/courseware
    steps:
      - uses: actions/checkout@v4
      - uses: actions/setup-python@v5
        with:
          python-version: "3.12"
      - run: git clone --depth 1 "${{{{ vars.COURSEWARE }}}}" courseware
      - run: pip install -e 'courseware[course]'
      - run: python -m grader prove --problems-from {folder} --seeds 5
      - run: python -m grader diagnose --problems-from {folder}
"""
GITLAB = """\
# Proves the problems of this repository at each push; a fault fails the job.
# COURSEWARE is a variable of the project: the address of the checkout that has grader/
prove:
  image: python:3.12
  variables:
    PYTHONPATH: $CI_PROJECT_DIR/courseware
  script:
    - git clone --depth 1 "$COURSEWARE" courseware
    - pip install -e 'courseware[course]'
    - python -m grader prove --problems-from {folder} --seeds 5
    - python -m grader diagnose --problems-from {folder}
"""
PAGES = """\
# Builds the site (python -m website) of a repository with this courseware, for GitHub Pages.
# In its settings, under Pages, choose "GitHub Actions" as the source.
name: pages
on:
  push:
    branches: [main]
  workflow_dispatch:
permissions:
  contents: read
  pages: write
  id-token: write
concurrency: pages
jobs:
  pages:
    runs-on: ubuntu-latest
    environment:
      name: github-pages
      url: ${{{{ steps.deployed.outputs.page_url }}}}
    steps:
      - uses: actions/checkout@v4
      - uses: actions/setup-python@v5
        with:
          python-version: "3.12"
      - uses: actions/cache@v4
        with:
          path: .site_cache
          key: site-${{{{ github.sha }}}}
          restore-keys: site-
      - run: pip install -e '.[fast,course,site]'
      - run: python -m website --out _site
      - uses: actions/upload-pages-artifact@v3
        with:
          path: _site
      - id: deployed
        uses: actions/deploy-pages@v4
"""
FORGES = {
    "github": (".github/workflows/problems.yml", GITHUB),
    "pages": (".github/workflows/pages.yml", PAGES),
    "gitlab": (".gitlab-ci.yml", GITLAB),
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
    place, text = FORGES[forge]
    path = to / place
    if path.exists():
        raise click.UsageError(f"{path} is there already; delete it to have it written anew")
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text.format(folder=folder), encoding="utf-8")
    click.echo(path)
