"""Small helps for the code of a problem."""

from newton_euler import Vector


def in_frame(frame, answers):
    """The answers, or whole mistakes of answers, with every Vector expressed in ``frame`` (or in the frame of that name in its own tree)."""
    if isinstance(answers, dict):
        return {name: in_frame(frame, answer) for name, answer in answers.items()}
    if not isinstance(answers, Vector):
        return answers
    return answers if answers.frame.name == frame.name else answers.expressed_in(frame)
