"""The import path of :func:`configure` that stands in the nbgrader_config.py of every course; it
must not change.
"""

from .nbgrader_hooks.config import configure

__all__ = ["configure"]
