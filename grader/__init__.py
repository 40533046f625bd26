"""Building nbgrader assignments from the exercises and grading submissions. Run it as ``python -m
grader``; it holds the keys.

    course          a course folder: paths, students, secret, each student's numbers, work handed in
    sandbox         runs student code in a process that reaches no key, no file and no network
    scoring         compares answers with the key: points, and the known mistake behind a wrong one
    assignment      builds the notebook of an assignment, and each student's copy with own numbers
    practice        writes practice files, with numbers that no one is graded on
    paper           writes sheets with own numbers, and their keys, as PDF
    lms             writes banks of questions for learning platforms
    submission      reads a submitted notebook, runs its answers, scores them
    grading         grades all submissions of an assignment and writes nbgrader's gradebook
    nbgrader_hooks  nbgrader's configuration, and the classes that it runs in place of its own
    reports         answers, results and statistics as text, JSON, tables and CSV
    demo            an example course with six students
    commands        the commands of python -m grader

Each line imports from the lines above it, from exercises and from newton_euler only;
tests/grader/test_imports.py reads the imports.
"""
