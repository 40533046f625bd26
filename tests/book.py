"""The book against the engine: which room and which tests belong to each section.
``python -m tests.book`` prints the table.

A test says in its name what it is for: ``test_eqn_4_18_…``, ``test_eqn_2_15_to_2_18_…``,
``test_example_4_11_…``, ``test_section_6_3_…``.
"""

import re
from collections import defaultdict
from pathlib import Path

HERE = Path(__file__).parent
# a section in each line: its number and the rooms of newton_euler/, or its worked examples in
# chapters/examples/ | first and last numbered equation | E: a worked example, S: only a section
SECTIONS = HERE / "book.txt"


def sections():
    """[(section, rooms, equation numbers, needs an example)] in the order of the book."""
    rows = []
    for line in SECTIONS.read_text(encoding="utf-8").splitlines():
        left, numbers, marks = (part.strip() for part in line.split("|"))
        section, _, rooms = left.partition(" ")
        first, _, last = numbers.partition("-")
        rows.append(
            (section, rooms, range(int(first), int(last) + 1) if numbers else range(0), marks)
        )
    return rows


def numbers_in(name):
    """Numbered equations in the name ``test_eqn_2_15_to_2_18_and_4_1_…``, as {(chapter, number)}."""
    match = re.match(r"test_eqns?_((?:A|\d+)_\d+(?:_(?:and|to|A|\d+)(?=_|$))*)", name)
    tokens, found = match[1].split("_") if match else [], []
    chapter, word = "", "and"
    while tokens:
        token, after = tokens.pop(0), tokens[0] if tokens else ""
        if token in ("and", "to"):
            word = token
            continue
        if after.isdigit() and (word == "and" or token == chapter):
            chapter, token = token, tokens.pop(0)
        first = found[-1][1] + 1 if word == "to" else int(token)
        found += [(chapter, n) for n in range(first, int(token) + 1)]
        word = ""
    return set(found)


def tests():
    """{name: file under tests/} of all tests."""
    found = {}
    for path in sorted(HERE.rglob("test_*.py")):
        for name in re.findall(r"^def (test_\w+)", path.read_text(encoding="utf-8"), re.M):
            found[name] = path.relative_to(HERE).as_posix()
    return found


def table():
    """[(section, rooms, equations, files, missing)]"""
    names = tests()
    of_equation = defaultdict(set)
    for name, file in names.items():
        for key in numbers_in(name):
            of_equation[key].add(file)
    rows = []
    for section, rooms, numbers, marks in sections():
        chapter = section.partition(".")[0]
        files = set().union(*(of_equation[chapter, n] for n in numbers)) if numbers else set()
        missing = [f"({chapter}.{n})" for n in numbers if not of_equation[chapter, n]]
        if marks:
            kind = "section" if marks == "S" else "examples?"
            pattern = re.compile(
                rf"test_{kind}_(?:[\dA]+_\d+(?:_\d)?_and_)?{section.replace('.', '_')}(?!\d)"
            )
            hits = {f for n, f in names.items() if pattern.match(n)}
            files |= hits
            missing += [] if hits else [f"example {section}"]
        span = f"({chapter}.{numbers[0]})-({chapter}.{numbers[-1]})" if numbers else ""
        rows.append((section, rooms, span, sorted(files), missing))
    return rows


def main():
    """Print the table as Markdown."""
    print("| section | room | equations | tests | missing |\n|---|---|---|---|---|")
    for section, rooms, equations, files, missing in table():
        print(f"| {section} | {rooms} | {equations} | {', '.join(files)} | {', '.join(missing)} |")


if __name__ == "__main__":
    main()
