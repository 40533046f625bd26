"""The chapters in a checkout: a pointer to ``chapters/`` beside the engine, which the wheel holds
in this place.
"""

from pathlib import Path

__path__ = [str(Path(__file__).resolve().parents[2] / "chapters")]
