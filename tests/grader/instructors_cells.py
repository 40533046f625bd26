"""Cells that an instructor adds to an assignment, of every kind that nbgrader has."""


def cell(kind, source, grade_id, **marks):
    marks = {"schema_version": 3, "grade_id": grade_id, "cell_type": kind, "task": False,
             "grade": False, "solution": False, "locked": False, **marks}  # fmt: skip
    own = {"cell_type": kind, "id": grade_id, "metadata": {"nbgrader": marks}, "source": source}
    return own | ({"outputs": [], "execution_count": None} if kind == "code" else {})


ESSAY = cell("markdown", "Why? *Write here.*", "essay", grade=True, solution=True, points=3)
SKETCH = cell("code", "# your plot\n", "sketch", grade=True, solution=True, points=2)
SQUARE = cell("code", "def square(x):\n    ### BEGIN SOLUTION\n    return x * x\n"
              "    ### END SOLUTION", "square", solution=True)  # fmt: skip
TEST = cell("code", "assert square(2) == 4\n### BEGIN HIDDEN TESTS\n"
            "assert square(-7) == 49, 'hidden words'\n### END HIDDEN TESTS",
            "test_square", grade=True, locked=True, points=4)  # fmt: skip
SHARE = cell("code", "0.5 * (square(3) == 9)", "share", grade=True, locked=True, points=1)
TASK = cell("markdown", "Measure it at home.\n### BEGIN MARK SCHEME\n2 for a photo\n"
            "### END MARK SCHEME", "at_home", task=True, locked=True, points=5)  # fmt: skip
HELPER = cell("code", "TWO = 2", "helper", locked=True)
PLAIN = {"cell_type": "code", "id": "plain", "metadata": {}, "source": "free = 1", "outputs": [],
         "execution_count": None}  # fmt: skip
OWN = (HELPER, ESSAY, SKETCH, SQUARE, TEST, SHARE, TASK, PLAIN)


def with_texts(notebook, **texts):
    for c in notebook["cells"]:
        name = c["metadata"].get("nbgrader", {}).get("grade_id")
        if name in texts:
            c["source"] = texts[name]
    return notebook
