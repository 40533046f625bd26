"""The names of a page's cells. Each statement that bound one is kept with what it bound and with
the runs that its own names came from; as long as these are the same, it is not run again.
"""

import ast
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import count
from typing import Any

from .needed import Statement, statements, statements_needed


@dataclass
class StatementRun:
    """A statement that was run, with the numbers of the runs that its names came from."""

    number: int
    inputs: dict[str, int]
    values: dict[str, Any] = field(default_factory=dict)
    error: Exception | None = None


class Notebook:
    """The cells of a page, of which some were run."""

    def __init__(self) -> None:
        self.names: dict[str, Any] = {"__name__": "__main__"}
        self.ran: dict[int, str] = {}  # the sources of cells that the reader ran
        self._runs: dict[Statement, StatementRun] = {}
        self._numbers = count()

    def prepare(self, cells: Sequence[str], number: int) -> dict[str, StatementRun]:
        """Run what a cell needs, unless it is up to date; {name: the run that bound it}."""
        above = [self.ran.get(n, cell) for n, cell in enumerate(cells[:number])]
        stand: dict[str, StatementRun] = {}
        for n, statement in statements_needed(above, cells[number]):
            done = self._runs.get(statement)
            if done is None or done.error or done.inputs != _inputs(statement, stand):
                done = self._run(statement, n, stand)
            stand |= dict.fromkeys(statement.binds, done)
        return stand

    def run(self, source: str, number: int, stand: dict[str, StatementRun]) -> Any:
        """Run a cell with the present names; the value of its last expression, or None."""
        ast.parse(source, name_of(number))  # an error of syntax
        value = None
        for statement in statements(source):
            done = self._run(statement, number, stand)
            stand |= dict.fromkeys(statement.binds, done)
            if done.error:
                raise _reason(done.error, stand)
            value = done.values.get("")
        self.ran[number] = source
        return value

    def _run(self, statement, number, stand):
        """Run a statement with the present names."""
        done = StatementRun(next(self._numbers), _inputs(statement, stand))
        for name, run in stand.items():
            if name in run.values:
                self.names[name] = run.values[name]
            else:
                self.names.pop(name, None)
        try:
            done.values[""] = self._execute(statement.node, name_of(number))
        except Exception as error:
            done.error = error
        done.values |= {n: self.names[n] for n in statement.binds if n in self.names}
        self._runs[statement] = done
        return done

    def _execute(self, node, name):
        """The value of an expression; None of another statement."""
        if isinstance(node, ast.Expr):
            return eval(compile(ast.Expression(node.value), name, "eval"), self.names)
        exec(compile(ast.Module([node], []), name, "exec"), self.names)
        return None


def _inputs(statement, stand):
    return {x: stand[x].number for x in statement.uses | statement.later if x in stand}


def _reason(error, stand):
    """Why a name is missing: a cell above could not bind it, for want of another name."""
    seen = set()
    while isinstance(error, NameError) and error.name in stand and error.name not in seen:
        seen.add(error.name)
        error = stand[error.name].error or error
    return error


def name_of(number: int) -> str:
    """What a cell is called in tracebacks."""
    return f"<cell {number}>"
