"""The numbers with which an answer was computed: problems share names such as ``omega``, and cells
may run in any order. From the first call of ``given``, which ends a problem's cell of numbers,
IPython's cells are watched: when a name gets a value, the given names at the start of that cell are
remembered.
"""

import ast
import re
import sys
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from ..algebra.errors import checked
from ..algebra.language import Words, _
from ..algebra.scalars import clipped


@checked
def given(problem: str, sealed: dict | None = None, **values: object) -> None:
    """Record the numbers that ``problem`` gives, by name; the last line of their cell.

    sealed : {answer: seal} of the right answers, where the instructor lets receipts say whether an
        answer is right

    >>> given("0/1", omega=0.6, b=8)
    """
    _given[problem] = values
    seals[problem] = sealed or {}
    watch = watching()
    for name in values:
        watch.givers[name] = problem
        watch.changers.pop(name, None)


_given: dict[str, dict[str, Any]] = {}
seals: dict[str, dict[str, Any]] = {}


@dataclass(frozen=True)
class _Snapshot:
    """A given name at the start of a cell: its value, its problem, what cell changed it."""

    value: Any
    giver: str
    changer: Any = None


@dataclass
class Watch:
    """Follows the cells of one IPython shell; ``shell`` is None outside IPython."""

    shell: Any = None
    givers: dict = field(default_factory=dict)
    changers: dict = field(default_factory=dict)
    at_start: dict = field(default_factory=dict)
    before: dict = field(default_factory=dict)
    # {name: (the given names at the start of the cell in which it got its value, that cell)}
    computed: dict = field(default_factory=dict)
    # the names whose cell has ended in an error since, and the problem whose receipt has read the
    # present value of a name
    failed: set = field(default_factory=set)
    read: dict = field(default_factory=dict)

    def start(self, info: object = None) -> None:
        """Before a cell: keep the values of all names."""
        self.before = names = dict(self.shell.user_ns)
        given = ((name, giver) for name, giver in self.givers.items() if name in names)
        self.at_start = {n: _Snapshot(names[n], giver, self.changers.get(n)) for n, giver in given}

    def end(self, result: Any) -> None:
        """After a cell: the names that it set were computed with the values at its start."""
        text = getattr(result.info, "raw_cell", "")
        # the identity of a cell survives edits where the front end sends an id
        cell = getattr(result.info, "cell_id", None) or text or None
        # a cell that sets a name to an equal small number leaves the same object
        stored = _stored(text) if result.success else set()
        self.failed |= set() if result.success else _stored(text)
        nothing = object()
        for name, value in self.shell.user_ns.items():
            if name in stored or self.before.get(name, nothing) is not value:
                self.computed[name] = self.at_start, cell
                self.failed.discard(name)
                self.read.pop(name, None)
                own = _given.get(self.givers.get(name, ""), {})
                if own.get(name, value) is not value:
                    self.changers[name] = cell


def _stored(text):
    """The names that the text of a cell sets."""
    try:
        nodes = ast.walk(ast.parse(text))
    except (SyntaxError, ValueError):  # a magic, or an error that IPython reports
        return set(re.findall(r"(?m)^ *(\w+) *=(?!=)", text))
    return {n.id for n in nodes if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}


_watch = Watch()


def watching() -> Watch:
    """The watch on the shell that runs this; it starts at the first call."""
    shell = _shell()
    if shell is not None and shell is not _watch.shell:
        _watch.__init__(shell)  # type: ignore[misc]
        shell.events.register("pre_run_cell", _watch.start)
        shell.events.register("post_run_cell", _watch.end)
        _watch.start()
    return _watch


def _shell():
    """IPython's shell; None outside IPython, or if it does not announce its cells."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython else None
    return shell if hasattr(shell, "events") and hasattr(shell, "user_ns") else None


def in_notebook() -> bool:
    """True in the kernel of a notebook, which can show more than text."""
    return getattr(_shell(), "kernel", None) is not None


def running_cell() -> tuple[str, str]:
    """The cell that a notebook runs, by the id that its front end sends, else by its text; and this
    run of it. Both are "" outside a notebook.
    """
    if not in_notebook():
        return "", ""
    parent = _shell().get_parent()
    sent, content, header = (parent.get(n) or {} for n in ("metadata", "content", "header"))
    return sent.get("cellId") or content.get("code", ""), header.get("msg_id", "")


def outdated(problem: str, names: Iterable[str]) -> dict[str, str]:
    """{name: why its value is not an answer to this problem}: its cell has ended in an error since,
    or the value was read as the answer to another problem.
    """
    watch, found = watching(), {}
    for name in names if watch.shell else ():
        other = watch.read.setdefault(name, problem)
        if name in watch.failed:
            found[name] = _("the cell that gives {name} a value ended in an error", name=name)
        elif other != problem and watch.shell.user_ns.get(name) is not None:
            text = Words("{name} has its value from {other}: run your cell of {problem}")
            found[name] = _(text, name=name, other=other, problem=problem)
    return found


def stale(problem: str, answers: dict, names_of_answers: set) -> str:
    """A sentence on the first of ``answers`` that was computed with other numbers than ``problem``
    gives, or "". What is computed under one of ``names_of_answers``, of all problems, is not a
    given number.
    """
    watch = watching()
    for key, value in answers.items():
        if watch.shell is None or value is None or key not in watch.computed:
            continue
        snapshots, cell = watch.computed[key]
        if watch.shell.user_ns.get(key) is not value:
            continue
        for name, own in _given.get(problem, {}).items():
            was = snapshots.get(name)
            if was is None or _same(was.value, own):
                continue
            # the student's own change of the problem's number, as from degrees to radians
            converted = was.giver == problem and was.changer not in (None, cell)
            if not converted or name in names_of_answers:
                text = Words(
                    "{key} was computed when {name} was {value}; {problem} gives {own}: run the"
                    " cell of its givens, then yours"
                )
                numbers = {"value": clipped(was.value), "own": clipped(own)}
                return _(text, key=key, name=name, problem=problem, **numbers)
    return ""


def _same(a, b):
    if a is b:
        return True
    try:
        equal = a == b
        return bool(equal.all()) if hasattr(equal, "all") else bool(equal)
    except Exception:  # objects of any library may refuse to be compared
        return False
