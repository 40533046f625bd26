"""A year in the browser: an instructor in nbgrader's formgrader, a student in JupyterLab."""

import copy
import os
import pwd
import shutil
from contextlib import suppress

import pytest

from exercises import problem
from grader.course import Course, write_json
from tests.grader.courses import command, points, ran, read
from tests.grader.instructors_cells import ESSAY
from tests.jupyterlab import REPOSITORY, Page, chromium, served

LOGIN = pwd.getpwuid(os.getuid()).pw_name  # under which nbgrader fetches and submits
ALONE = """# the engine is found, the exercises and the grader are not: as where its wheel is installed
import sys
from pathlib import Path
sys.meta_path = [f for f in sys.meta_path if not f.__module__.startswith("__editable__")]
sys.path = [p for p in sys.path if not (Path(p) / "grader").exists()]
"""


@pytest.fixture
def course(tmp_path):
    """A course with one sheet: a problem, and an essay of the instructor's own."""
    roster, folder = tmp_path / "my roster.csv", tmp_path / "mechanics"
    roster.write_text(f"Username,First name,Last name\n{LOGIN},Ada,Lovelace\n", "utf-8-sig")
    build = "build", "hw1", "2/1", "--course", folder, "--students", roster
    ran(command(*build, "--exchange", tmp_path / "exchange"))
    source = Course(folder).source("hw1")
    notebook = read(source)
    write_json(source, {**notebook, "cells": [*notebook["cells"], copy.deepcopy(ESSAY)]})
    return Course(folder)


class Seen(Page):
    """The page that the instructor or the student looks at."""

    def go(self, served, path):
        """Open a page of a server."""
        at, token = served
        self.driver.get(f"{at}/{path}?token={token}")

    def click(self, css, text=""):
        """Click the first element of a selector that is shown with this text, once it can be."""
        from selenium.common.exceptions import WebDriverException

        def clicked():
            for e in self.all(css):
                if e.is_displayed() and text in e.text:
                    with suppress(WebDriverException):  # covered by something for now
                        e.click()
                        return True
            return False

        self.wait(clicked, f"{text!r} in {css}")

    def reads(self, *words, css="body"):
        """Wait until all words are shown."""
        shown = lambda: "\n".join(e.text for e in self.all(css))
        self.wait(lambda: all(w in shown() for w in words), f"{words} in {css}")

    def types(self, cell, text):
        """Write a text into a cell of a notebook, in place of what is there."""
        from selenium.webdriver import ActionChains, Keys

        ActionChains(self.driver).double_click(cell).perform()
        (editor,) = self.wait(lambda: cell.find_elements("css selector", ".cm-content"), "a cell")
        editor.click()
        self.wait(lambda: "cm-content" in self.focused(), "the focus")
        keys = ActionChains(self.driver).key_down(Keys.CONTROL).send_keys("a").key_up(Keys.CONTROL)
        keys.send_keys(text).perform()

    def manages(self, teacher, step, page="manage_assignments"):
        """Run a step from a list of the formgrader, which must report success."""
        self.go(teacher, f"formgrader/{page}")
        self.click(f".{step} a")
        self.reads("Successfully", css=".modal-body")

    def lists(self, student, step, folder, found):
        """A button of nbgrader's list of assignments in JupyterLab, and the file that it brings."""
        self.go(student, "lab")
        self.click(".lm-MenuBar-itemLabel", "Nbgrader")
        self.click(".lm-Menu-itemLabel", "Assignment List")
        self.click("#nbgrader-assignment-list button", step)
        (path,) = self.wait(lambda: [*folder.glob(found)], f"{found} after {step}")
        return path


@pytest.mark.slow
@pytest.mark.integration
def test_a_year_in_the_browser(course, tmp_path):
    home, alone = tmp_path / "home", tmp_path / "alone"
    for folder in (home, alone, tmp_path / "teacher"):
        folder.mkdir()
    (alone / "newton_euler").symlink_to(REPOSITORY / "newton_euler")
    (alone / "sitecustomize.py").write_text(ALONE)
    shutil.copytree(course.path / "student", tmp_path / "student" / "config")
    with (
        served(course.path, tmp_path / "teacher") as teacher,
        served(home, tmp_path / "student", PYTHONPATH=str(alone), HOME=str(home)) as student,
        chromium(tmp_path / "chromium") as driver,
    ):
        seen = Seen(driver)
        for step in ("assign", "release"):
            seen.manages(teacher, step)
        seen.lists(student, "Fetch", home, "hw1/hw1.ipynb")
        works(seen, student, course)
        seen.lists(student, "Submit", tmp_path, "exchange/*/inbound/*/hw1.ipynb")
        seen.manages(teacher, "collect")
        seen.manages(teacher, "autograde", "manage_submissions/hw1")
        marks(seen, teacher, course)
        for step in ("generate-feedback", "release-feedback"):
            seen.manages(teacher, step)
        page = seen.lists(student, "Fetch Feedback", home, "hw1/feedback/*/hw1.html")
        driver.get(page.as_uri())
        seen.reads("3.5 / 4", "✓ right", "Since the path is curved.", "Well seen")
    assert "has hw1" in ran(command("next-year", course.path, "--course", tmp_path / "mechanics27"))
    assert "essay" in str(read(Course(tmp_path / "mechanics27").source("hw1")))


def works(seen, student, course):
    """A student answers the problem and the essay, runs the cells, presses Validate."""
    from selenium.webdriver import Keys

    p = problem("2/1")
    (right,) = p.solve(course.values("hw1", LOGIN, [p])["2/1"]).values()
    seen.open("{}/lab/tree/hw1/hw1.ipynb?token={}".format(*student), 0)
    alone = "import importlib.util\nassert not importlib.util.find_spec('grader')\n"
    seen.types(seen.cell(2), f"{alone}a = {[*map(float, right)]}")
    for n in range(4):
        seen.run(n)
    seen.says(3, "Form checked only")
    seen.types(seen.all(".jp-MarkdownCell")[-1], "Since the path is curved.")
    seen.press(Keys.ENTER, shift=True)
    seen.click(".jp-NotebookPanel-toolbar jp-button", "Validate")
    seen.reads("Success", css=".jp-Dialog")


def marks(seen, teacher, course):
    """The instructor sees the points of the problem, and gives some for the essay."""
    from selenium.webdriver import Keys

    seen.go(teacher, "formgrader/gradebook/hw1/hw1")
    seen.reads("1 / 4")
    seen.click("td a", "Submission #1")
    seen.reads("Since the path is curved.")
    seen.wait(lambda: seen.all("#essay.needs_manual_grade"), "the essay in the queue")
    shown = seen.all("#answer-2-1, #answer-2-1-comment")
    assert [e.get_attribute("placeholder") for e in shown] == ["1", "- ✓ `a`: right"]
    for css, text in (("#essay-comment", "Well seen"), ("#essay", "2.5")):
        (field,) = seen.all(css)
        field.send_keys(text, Keys.TAB)
    seen.wait(lambda: points(course, "hw1")[LOGIN]["essay"][1] == 2.5, "the points by hand")
