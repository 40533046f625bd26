"""Invented results, and a course with records, for the tests of reports."""

import json
import random
from types import SimpleNamespace

from grader.course import write_json
from grader.course.creation import new_course
from grader.scoring import Part, Score

PARTS = (("4/1", "speed"), ("4/1", "acc_mag"), ("4/16", "alpha_CD"), ("4/16", "a_D"))
MISTAKE = "leaves out the Coriolis term 2 omega x v_r, which is as large as all the others together"
NAMES = ("Doe, Jr.", 'O"Brien', "Müller", "=cmd()", "Ng")


def result(student, right, out_of=4, **more):
    """A result as grade(…) gives it, with the first ``right`` parts right."""
    parts = [
        Part(key, float(n < right), 1, "right" if n < right else "wrong", "not right",
             None if n < right else MISTAKE)
        for n, (_, key) in enumerate(PARTS)
    ]  # fmt: skip
    scores = {i: Score(i, tuple(p for p, (j, _) in zip(parts, PARTS, strict=True) if i == j))
              for i in ("4/1", "4/16")}  # fmt: skip
    own = {
        "student": student, "scores": scores, "points": right, "out_of": out_of, "extra": 0,
        "penalty": 0, "waiting": 0, "sandbox": "namespaces", "note": "", "problem": "",
        "unchanged": False, **more,
    }  # fmt: skip
    diagnoses = [(i, p.key, p.diagnosis) for i, s in scores.items() for p in s.parts if p.diagnosis]
    return SimpleNamespace(**own, diagnoses=lambda: diagnoses)


def graded_course(path, students=20):
    """Student n of N gets a part right with probability n / N, and nobody the last part."""
    rng = random.Random(4)
    with new_course(path, "mechanics") as course:
        course.enrol(
            {
                "id": f"s{n:02}", "first_name": f"Ann {n}", "last_name": NAMES[n % len(NAMES)],
                "email": f"s{n:02}@uni.edu", "lms_user_id": str(900 + n),
            }
            for n in range(students)
        )  # fmt: skip
    notebook = {
        "cells": [], "nbformat": 4, "nbformat_minor": 5,
        "metadata": {"newton_euler": {"problems": []}},
    }  # fmt: skip
    write_json(course.released_path("ch04"), notebook)
    with course.gradebook() as book:
        book.add_assignment("ch04")
    for n in range(students):
        scores = {}
        for problem, key in PARTS:
            right = rng.random() < n / students and key != "a_D"
            scores.setdefault(problem, []).append({
                "key": key, "points": float(right), "out_of": 1.0,
                "verdict": "right" if right else "wrong", "message": "=not right",
                "diagnosis": None if right or n % 2 else MISTAKE,
            })  # fmt: skip
        target = course.record_path("ch04", f"s{n:02}")
        target.parent.mkdir(parents=True, exist_ok=True)
        record = {"scores": [{"problem": p, "parts": x, "note": ""} for p, x in scores.items()]}
        target.write_text(json.dumps(record))
    return course
