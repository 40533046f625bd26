"""Forged, doubled, oversized, nested and malformed receipts; other people's work and numbers."""

from tests.grader.attacks.attack import code, edited, put, right_texts
from tests.grader.courses import read


def forged(*lines, **flags):
    """Writes these bytes (Python expressions) to every file that the process has."""
    return code(
        "import os\n"
        f"for line in ({', '.join(lines)},):\n"
        "    for fd in range(3, 64):\n"
        "        try: os.write(fd, line)\n"
        "        except OSError: pass\n",
        **flags,
    )


FORGED = {
    "points and verdict": forged(
        r"""b'{"id": "4/1", "points": 1e9, "verdict": "right", "answers": {"speed": "right"}}\n'"""
    ),
    "the score itself": forged(
        r"""b'{"problem": "4/1", "parts": [{"key": "speed", "points": 2, "out_of": 2, '"""
        r"""b'"verdict": "right", "message": "right"}], "note": ""}\n'"""
    ),
    "doubled": forged(
        *(
            rf"""b'{{"id": "4/1", "answers": {{"speed": {n}, "acc_mag": 1}}}}\n'"""
            for n in range(20)
        )
    ),
    "oversized": forged(r"""b'{"id": "4/1", "answers": {"speed": "' + b'9' * 2**21 + b'"}}\n'"""),
    "nested": forged(
        r"""b'{"id": "4/1", "answers": {"speed": ' + b'[' * 900 + b']' * 900 + b'}}\n'""",
        r"""b'{"id": "4/16", "answers": {"v_D": ' + b'{"x":' * 390 + b'1' + b'}' * 390 + b'}}\n'""",
    ),
    "malformed": forged(
        r"""b'{"id": "4/1", "answers": {"speed": NaN, "acc_mag": Infinity}}\n'""",
        r"""b'{"id": "4/1", "answers": {"speed": ' + b'9' * 5000 + b'}}\n'""",
        r"""b'{"id": ["4/1"], "answers": []}\n'""",
        r"""b'\xff\xfe{"id": 1}\n'""",
        r"""b'[]\nnull\ntrue\n"id"\n'""",
        r"""b'{"id": "4/16", "answers": "right", "faults": [1], "error": {"a": 1}}\n'""",
    ),
    "of other problems": forged(
        r"""b'{"id": "4/99", "answers": {"speed": 1}}\n{"id": "", "answers": {}}\n'""",
        r"""b'{"id": "../../gradebook", "answers": {}}\n'""",
    ),
    "of the cage": forged(
        r"""b'{"sandbox": "namespaces", "ended": "done"}\n{"ended": ""}\nend\n'""",
        r"""b'{"token": "", "error": null, "value": 4}\n'""",
    ),
    "trees of other things": forged(
        r"""b'{"id": "4/1", "answers": {"speed": {"op": "eval", "args": ["1"]}, '"""
        r"""b'"acc_mag": {"a": {"b": 1}, "c": [1, 2]}}}\n'""",
        r"""b'{"id": "4/16", "answers": {"v_D": {"A": [1, 0, 0], "B": [0, 1, 0], "C": [0, 0, 1]},'"""
        r"""b'"a_D": [null, true, "x"], "alpha_CD": [[1], [2], [3]]}}\n'""",
    ),
    "frames whose names are HTML": forged(
        r"""b'{"id": "4/16", "answers": {"a_D": {"<script>alert(1)</script>": [1, 2, 3], '"""
        r"""b'"\\u001b[2J<iframe>": [3, 2, 1]}}}\n'"""
    ),
    "ten thousand lines": forged(r"""b'{"id": "4/1"}\n' * 9000"""),
}


def neighbours_notebook(notebook, scene):
    """Another's numbers: what is copied of the instructor's question is right for everyone."""
    theirs = read(scene.honest)
    put(theirs, {"square": ""})
    return theirs


def neighbours(*roles):
    """Cells of these roles, of both problems, as a neighbour has them."""

    def change(notebook, scene):
        theirs = {c["id"]: c["source"] for c in read(scene.honest)["cells"]}
        put(notebook, {i: theirs[i] for i in theirs if i.startswith(roles)})

    return edited(change)


def answers_of_the_book(notebook, scene):
    from exercises.catalogue import problem
    from grader.demo import sample_students as sample

    for number in ("4/1", "4/16"):
        p = problem(number)
        text = sample.cell_text(p, sample.right_answers(p, p.book_values))
        put(notebook, {f"answer-{number.replace('/', '-')}": text})


def answers_of_nobody(notebook, scene):
    put(notebook, right_texts(scene.course, "somebody else"))


def answers_under_the_wrong_problem(notebook, scene):
    own = right_texts(scene.course, scene.student)
    put(notebook, {"answer-4-1": own["answer-4-16"], "answer-4-16": own["answer-4-1"]})


REPLAYED = {
    "a neighbour's notebook": edited(neighbours_notebook),
    "a neighbour's answers": neighbours("answer-"),
    "a neighbour's numbers and answers": neighbours("answer-", "givens-"),
    "the answers for the book's numbers": edited(
        answers_of_the_book, shown="this is the answer for the book's numbers"
    ),
    "the answers for another variant": edited(answers_of_nobody),
    "right answers in the cells of each other": edited(answers_under_the_wrong_problem),
}

ATTACKS = {**FORGED, **REPLAYED}
