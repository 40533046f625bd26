"""``python -m newton_euler.accuracy``: see :mod:`.command`."""

try:
    from .command import main
except ModuleNotFoundError as error:
    if error.name not in ("click", "rich"):
        raise
    raise SystemExit(
        f"python -m newton_euler.accuracy needs {error.name}: pip install 'newton-euler[course]'"
    ) from None

main(prog_name="python -m newton_euler.accuracy")
