"""``python -m tests.house``: how large each room is, and who imports whom."""

import io
import tokenize
from collections import Counter, defaultdict
from pathlib import Path

from tests.imports import circle, imports, modules

ROOT = Path(__file__).parent.parent
PACKAGES = ("newton_euler", "exercises", "grader", "website")
AIMS = {"newton_euler": 25_000, "exercises": 25_000, "tests": 48_000}
BEGINS = (tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT)  # after these a statement begins
BLANK = (tokenize.NL, tokenize.COMMENT, tokenize.ENDMARKER)  # NL also ends lines within brackets


def room_of(module: str, path: Path) -> str:
    """The room of a module: "newton_euler.motion", "exercises.ch04"; "grader" for files at a top."""
    package, room = (*module.split("."), "", "")[:2]
    at_the_top = path.parent.name == package or not room
    return package if at_the_top else f"{package}.{room}"


def sizes(path: Path) -> Counter:
    """Lines, lines of code, and files (1): blank lines, comments and docstrings are not code."""
    text = path.read_text(encoding="utf-8")
    code: set[int] = set()
    statement = True  # a string that begins a line of its own is a docstring
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type in BEGINS:
            statement = True
        elif token.type not in BLANK:
            if not (token.type == tokenize.STRING and statement):
                code |= set(range(token.start[0], token.end[0] + 1))
            statement = False
    return Counter(lines=text.count("\n"), code=len(code), files=1)


def arrows() -> dict[str, set[str]]:
    """{room: the rooms that it imports from} of all packages."""
    files = {name: path for package in PACKAGES for name, path in modules(ROOT / package).items()}
    found: dict[str, set[str]] = defaultdict(set)
    for module in files:
        for target in {t for t, _ in imports(module, files)} & set(files):
            room, above = room_of(target, files[target]), room_of(module, files[module])
            if room != above:
                found[above].add(room)
    return found


def rows() -> dict[str, Counter]:
    """{room or package: its sizes}."""
    table: dict[str, Counter] = defaultdict(Counter)
    for package in (*PACKAGES, "chapters", "tests"):
        for module, path in modules(ROOT / package).items():
            table[package] += sizes(path)
            if room_of(module, path) != package:
                table[room_of(module, path)] += sizes(path)
    return table


def main() -> None:
    """Print the table."""
    graph = arrows()
    print(f"{'room':32}{'lines':>8}{'code':>8}{'files':>7}  imports from")
    for room, size in sorted(rows().items()):
        aim = f"(aim {AIMS[room]})" if room in AIMS else ""
        to = " ".join(sorted(r.removeprefix("newton_euler.") for r in graph.get(room, ())))
        name = room if "." not in room else f"  {room.partition('.')[2]}"
        print(f"{name:32}{size['lines']:8}{size['code']:8}{size['files']:7}  {aim or to}")
    print(f"arrows between rooms: {sum(map(len, graph.values()))}; circle: {circle(graph)}")


if __name__ == "__main__":
    main()
