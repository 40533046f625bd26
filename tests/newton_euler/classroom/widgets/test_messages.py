"""messages.py: error messages as text."""

import pytest

from newton_euler import Frame
from newton_euler.classroom.widgets.messages import error_message


def test_a_refusal_is_shown_in_lines_and_its_absence_is_an_error():
    ground = Frame("ground")
    message = error_message(lambda: ground.i.rate())
    assert message.startswith("FrameError: a rate of a vector is seen from")
    assert max(map(len, message.splitlines())) <= 100
    with pytest.raises(AssertionError, match="nothing was refused; the result is 3"):
        error_message(lambda: 3)
