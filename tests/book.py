"""The book against the engine: which room and which tests belong to each section.
``python -m tests.book`` prints the table.

A test says in its name what it is for: ``test_eqn_4_18_…``, ``test_eqn_2_15_to_2_18_…``,
``test_example_4_11_…``, ``test_section_6_3_…``.
"""

import re
from collections import defaultdict
from pathlib import Path

# section | rooms of newton_euler/, and its worked examples in chapters/examples/ | first and last
# numbered equation | E: a worked example
SECTIONS = """
A algebra/vectors, kinematics/curvilinear_systems, chapters/examples/appA | 1-22 | E
1.2 kinematics/paths, kinematics/frames | 1-3 |
2.1 kinematics/frames | 1-3 |
2.2 chapters/examples/ch02 | | E
2.3 kinematics/paths | 4-14 |
2.4 chapters/examples/ch02 | | E
2.5 chapters/examples/ch02 | | E
2.6 kinematics/coordinates | 15-18 |
2.7 chapters/examples/ch02 | | E
2.8 kinematics/frames | 19-19 |
2.9 kinematics/frames | 20-22 |
2.10 kinematics/frames | 23-26 |
2.11 chapters/examples/ch02 | | E
2.12 chapters/examples/ch02 | | E
3.1 kinematics/frames, chapters/examples/ch03 | 1-3 | E
3.2 kinematics/paths, chapters/examples/ch03 | 4-13 | E
3.3 chapters/examples/ch03 | | E
3.4 kinematics/curvilinear_systems | 14-17 |
3.5 kinematics/coordinates | 18-23 |
3.6 chapters/examples/ch03 | | E
3.7 kinematics/coordinates | 24-27 |
3.8 kinematics/coordinates | 28-38 |
3.9 chapters/examples/ch03 | | E
4.2 kinematics/rotations | 1-8 |
4.4 kinematics/frames | 9-12 |
4.5 kinematics/frames, algebra/linear | | E
4.6 algebra/vectors | 13-15 |
4.8 kinematics/frames | 16-18 |
4.9 kinematics/frames | 19-26 |
4.10 kinematics/frames | 27-29 |
4.11 kinematics/frames | | E
5.1 bodies/body | 1-3 |
5.2 bodies/body | 4-9 |
5.3 chapters/examples/ch05 | | E
5.4 bodies/body, bodies/parametric | 10-13 |
5.5 chapters/examples/ch07 | | E
5.6 chapters/examples/ch07 | | E
5.8 kinematics/frames, bodies/body | 14-17 |
5.9 kinematics/frames | 18-19 |
5.10 dynamics/gravity | 20-27 |
5.11 dynamics/constraints | 28-28 |
6.1 dynamics/newton | 1-6 |
6.2 chapters/examples/ch06 | | E
6.3 scenes/particles/aircraft | | S
6.4 dynamics/newton | 7-9 |
6.5 chapters/examples/ch06 | | E
6.6 dynamics/newton | 10-10 |
6.7 scenes/particles/space_station, chapters/examples/ch06 | | E
6.8 applications/earth | 11-14 |
6.9 applications/earth | 15-15 |
6.10 applications/earth, scenes/particles/projectile | 16-31 |
6.11 applications/earth, scenes/particles/low_pressure | 32-34 |
6.12 scenes/particles/aircraft, chapters/examples/ch06 | | S
7.1 bodies/body | 1-8 |
7.2 bodies/inertia | 9-14 |
7.3 bodies/solids, chapters/examples/ch07 | | E
7.4 bodies/principal_axes | 15-20 |
7.5 bodies/principal_axes, chapters/examples/ch07 | | E
7.6 bodies/principal_axes | 21-21 |
7.7 bodies/body | 22-23 |
7.8 bodies/inertia | 24-26 |
7.9 bodies/inertia | 27-27 | E
7.10 bodies/inertia, chapters/examples/ch07 | | E
8.1 dynamics/momentum | 1-11 |
8.2 dynamics/euler | 12-14 |
8.3 dynamics/momentum, dynamics/euler | 15-17 |
8.4 chapters/examples/ch08 | | E
8.5 dynamics/euler | 18-19 |
8.6 scenes/planar/sliding_sphere, chapters/examples/ch08 | | E
8.7 dynamics/force_systems | 20-21 |
9.2 applications/rotors, chapters/examples/ch09 | 1-3 |
9.3 applications/rotors, chapters/examples/ch09 | 4-6 |
9.5 applications/rotors, scenes/planar/rotor, chapters/examples/ch09 | 7-10 |
10.2 kinematics/rotations | 1-4 |
10.3 kinematics/rotations | 5-10 |
10.4 scenes/spatial/spherical_pendulum, chapters/examples/ch10 | 11-16 |
10.5 applications/gyroscopes | 17-27 |
10.6 applications/gyroscopes, applications/nutation | 28-34 |
10.8 applications/gyroscopes, chapters/examples/ch10 | 35-36 |
10.9 applications/gyroscopes | 37-38 |
11.2 dynamics/work | 1-1 |
11.3 dynamics/work | 2-5 |
11.4 dynamics/work | 6-7 | E
11.5 dynamics/work | 8-9 |
11.6 dynamics/work | 10-11 |
11.7 dynamics/energy | 12-14 |
11.8 chapters/examples/ch11 | | E
11.9 dynamics/potential | 15-20 |
11.10 dynamics/potential, chapters/examples/ch11 | 21-25 | E
11.11 dynamics/energy | 26-33 |
11.12 dynamics/potential, chapters/examples/ch11 | 34-35 | E
11.14 dynamics/energy | 36-49 |
11.15 scenes/planar/rolling_sphere, chapters/examples/ch11 | | E
11.16 dynamics/energy, scenes/spatial/top, chapters/examples/ch11 | 50-53 | E
11.17 scenes/planar/pendulum, chapters/examples/ch11 | | E
11.19 scenes/particles/car_on_hill, chapters/examples/ch11 | | E"""
HERE = Path(__file__).parent


def sections():
    """[(section, rooms, equation numbers, needs an example)] in the order of the book."""
    rows = []
    for line in SECTIONS.strip().splitlines():
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
        rows.append(
            (
                section,
                rooms,
                f"({chapter}.{numbers[0]})-({chapter}.{numbers[-1]})" if numbers else "",
                sorted(files),
                missing,
            )
        )
    return rows


def main():
    """Print the table as Markdown."""
    print("| section | room | equations | tests | missing |\n|---|---|---|---|---|")
    for section, rooms, equations, files, missing in table():
        print(f"| {section} | {rooms} | {equations} | {', '.join(files)} | {', '.join(missing)} |")


if __name__ == "__main__":
    main()
