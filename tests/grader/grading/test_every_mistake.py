"""A perfect, a blank and one submission for each listed mistake of a chapter, handed in as notebooks
and graded with the real cage and gradebook: each earns what it should, with the mistake named.
"""

import pytest

from exercises.catalogue import problems
from grader.assignment import build_assignment
from grader.assignment.numbers import kept_numbers
from grader.course import read_json, write_json
from grader.demo import sample_students as sample
from grader.demo.run import nbgrader_api, require_success
from grader.grading import grade

CHAPTERS = "ch02", "ch03", "ch04", "ch05", "ch06", "ch07", "ch08", "ch09", "appA"


def wrong_answers(p, values, name):
    """(literals of all answers with this mistake, the keys that it changes)."""
    right = p.solve({**p.sympy_symbols(), **values})
    wrong = p.wrong({**p.sympy_symbols(), **values})[name]
    # a mistake in a word may give the right one
    wrong = {k: x for k, x in wrong.items() if not p.answer(k).kind.is_word or x != right[k]}
    literals = {key: sample.literal(p.answer(key), x) for key, x in wrong.items()}
    return sample.right_answers(p, values) | literals, set(wrong)


def hand_in(course, chapter, student, answers):
    """Write the submission in which these problems are answered: {problem id: literals}."""
    released = read_json(course.released_path(chapter))
    texts = {p.id: sample.cell_text(p, answers[p.id]) for p in problems(chapter) if p.id in answers}
    done = sample.fill_in(released, texts)
    write_json(course.personal_path(chapter, student), released, indent=None)
    write_json(course.path / "submitted" / student / chapter / f"{chapter}.ipynb", done)


@pytest.mark.integration
@pytest.mark.slow
@pytest.mark.parametrize("chapter", CHAPTERS)
def test_each_mistake_of_a_chapter_is_graded_and_named(chapter, tmp_path):
    asked = problems(chapter)
    most = max(len(p.mistakes) for p in asked)
    students = ["perfect", "blank", *(f"mistake{n}" for n in range(most))]
    course = build_assignment(tmp_path / "course", chapter).course
    course.enrol(students)
    require_success(nbgrader_api(course).generate_assignment(chapter))
    changed = {}
    for student in students:
        numbers = kept_numbers(course, chapter, student, asked)
        answers = {p.id: sample.right_answers(p, numbers[p.id]) for p in asked}
        for p in asked if student.startswith("mistake") else ():
            n = int(student.removeprefix("mistake"))
            if n < len(p.mistakes):
                name = list(p.mistakes)[n]
                answers[p.id], keys = wrong_answers(p, numbers[p.id], name)
                changed[student, p.id] = name, keys
        hand_in(course, chapter, student, {} if student == "blank" else answers)

    made, named, wrong = 0, 0, []
    for result in grade(course, chapter):
        assert not result.problem
        for p in asked:
            name, keys = changed.get((result.student, p.id), ("", set()))
            for part in result.scores[p.id].parts:
                where = result.student, p.id, part.key, name, part.verdict, part.diagnosis
                if result.student == "blank":
                    assert (part.points, part.verdict) == (0, "blank"), where
                elif part.key not in keys:
                    assert (part.points, part.verdict) == (part.out_of, "right"), where
                else:
                    made += 1
                    follows = "follows from your" in part.message
                    assert part.verdict == "wrong", where
                    assert part.points == 0 or follows, where
                    listed = [cause.text for cause in part.causes]
                    named += p.mistakes[name] in listed or follows
                    if listed and p.mistakes[name] not in listed and not follows:
                        wrong.append(where)
    print(f"{chapter}: {made} wrong answers, {100 * named / made:.1f} % named")
    assert made > 30
    assert wrong == []
    assert named >= 0.95 * made
