"""How a hint tells its reader to go on: by calls, or by the buttons of the form."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Ways:
    """How an answer and a step are checked, and other numbers taken, in words."""

    answer: str = "by p.check({}=...)"
    step: str = "by p.check_step({}=...)"
    new: str = "p.new()"


PRESSED = Ways(
    "in the field {} above, by Check",
    "in the field of steps, as {} with its value, by Check step",
    "New numbers",
)
