"""The workflow that puts the site on GitHub Pages."""

import pytest

from tests.grader.courses import command, ran


def test_the_workflow_builds_the_site_and_deploys_what_was_built(tmp_path):
    yaml = pytest.importorskip("yaml")
    ran(command("ci", "pages", "--to", tmp_path))
    text = (tmp_path / ".github/workflows/pages.yml").read_text("utf-8")
    job = yaml.safe_load(text)["jobs"]["pages"]
    assert job["environment"]["url"] == "${{ steps.deployed.outputs.page_url }}"
    assert [step["run"] for step in job["steps"] if "run" in step] == [
        "pip install -e '.[fast,course,site]'",
        "python -m website --out _site",
    ]
    assert job["steps"][-1]["id"] == "deployed"
