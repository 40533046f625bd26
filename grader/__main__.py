"""The command line of the grader: ``python -m grader --help``."""

import sys

import click

from .commands import COMMANDS
from .commands.shared import PROBLEMS_FROM, STOPPED

# jsonschema, which nbgrader imports, would spend a second per command on a grammar of
# internationalised addresses, which notebooks do not have
sys.modules.setdefault("rfc3987_syntax", None)  # type: ignore[arg-type]


class _Commands(click.Group):
    """Print errors that the user can correct as sentences, with exit code 2; after Ctrl-C the
    progress so far, with 130.
    """

    def list_commands(self, context):
        return [name for name in self.commands if name != "list"]

    def invoke(self, context):
        from exercises.catalogue import CatalogueError
        from exercises.catalogue.errors import of_own_problem
        from newton_euler.algebra.units import UnitError

        from .course import CourseError
        from .sandbox import HarvestError

        try:
            return super().invoke(context)
        except (CatalogueError, CourseError, HarvestError, UnitError) as error:
            raise click.UsageError(str(error)) from error
        except KeyboardInterrupt as stopped:
            click.echo(f"Stopped by Ctrl-C. {stopped}".rstrip(), err=True)
            context.exit(STOPPED)
        except OSError as error:  # no permission, disk full, a file in place of a folder
            raise click.UsageError(
                f"{error.filename or 'the system'}: {error.strerror or error}"
            ) from error
        except Exception as error:
            if words := of_own_problem(error):
                raise click.UsageError(f"{words}; see python -m grader prove") from error
            raise


@click.group(
    cls=_Commands,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110},
)
def main() -> None:
    """Build nbgrader assignments from the exercises and grade what students submit.

    \b
    Try it:          python -m grader demo
    See an answer:   python -m grader solve 4/16
    Make a course:   python -m grader build ch04 --course ~/mechanics --students roster.csv
                     (cd ~/mechanics && nbgrader generate_assignment ch04 &&
                     nbgrader release_assignment ch04)
    Grade it:        (cd ~/mechanics && nbgrader collect ch04)
                     python -m grader grade ch04 --course ~/mechanics
    Look at it:      python -m grader stats ch04 --course ~/mechanics
    """


for command in COMMANDS:
    main.add_command(PROBLEMS_FROM(command))
main.add_command(COMMANDS[0], "list")  # an earlier name

if __name__ == "__main__":
    main(prog_name="python -m grader")
