"""From exercise to assignment, from submission to grade. Run as ``python -m grader``; stays with the instructor."""
