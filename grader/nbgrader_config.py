"""The fixed import path of :func:`configure`: every course's nbgrader_config.py has it."""

from .nbgrader_hooks.config import configure

__all__ = ["configure"]
