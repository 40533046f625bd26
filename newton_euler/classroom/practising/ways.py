"""What a hint says to do next: calls, or the buttons of the form."""

from dataclasses import dataclass

from ...algebra.language import Words


@dataclass(frozen=True)
class Ways:
    """How an answer and a step are checked, and other numbers taken, in words."""

    answer: str = Words("by p.check({name}=...)")
    step: str = Words("by p.check_step({name}=...)")
    new: str = "p.new()"


PRESSED = Ways(
    Words("in the field {name} above, by Check"),
    Words("in the field of steps, as {name} with its value, by Check step"),
    Words("New numbers"),
)
