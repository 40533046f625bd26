"""What a notebook would show."""

import pytest


class Shown:
    """Stands in for IPython's display: records what was shown, and what replaced it."""

    def __init__(self):
        self.outputs, self.updates = [], []

    def display(self, thing, metadata=None, raw=False, display_id=False):
        self.outputs.append((thing, metadata) if raw else thing)
        return self

    def update(self, thing, metadata=None, raw=False):
        assert raw
        self.updates.append((thing, metadata))


@pytest.fixture
def shown(monkeypatch):
    """A :class:`Shown` in place of IPython's display."""
    shown = Shown()
    monkeypatch.setattr("IPython.display.display", shown.display)
    return shown
