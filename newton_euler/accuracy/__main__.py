"""``python -m newton_euler.accuracy``: see :mod:`.command`."""

try:
    from .command import main
except ModuleNotFoundError as error:
    missing = error.name.partition(".")[0] if error.name else ""
    if missing not in ("click", "rich"):
        raise
    raise SystemExit(
        f"python -m newton_euler.accuracy needs the package {missing}: pip install click rich"
    ) from None

main(prog_name="python -m newton_euler.accuracy")
