"""What a process can do to the machine: kill, outlive, fill, lock, connect, read what is not its own."""

from tests.grader.attacks.attack import cells, code, edited, filled

ATTACKS = {
    **{
        name: code(cell) if isinstance(cell, str) else code(**cell)
        for table in cells(__file__).values()
        for name, cell in table.items()
    },
    "a shell": edited(lambda notebook, scene: [
        c.update(source=filled(
            "!touch $OUTSIDE/shell\n%%bash\ntouch $OUTSIDE/bash" if n % 2 else
            "%%bash\ntouch $OUTSIDE/bash", scene))
        for n, c in enumerate(notebook["cells"]) if c["id"].startswith("answer")] and None),
}  # fmt: skip
