"""The import path of ``configure`` in the nbgrader_config.py of every course."""

from .nbgrader_hooks.config import configure

__all__ = ["configure"]
