"""The fixed import path of :func:`configure`, for every course's nbgrader_config.py."""

from .nbgrader_hooks.config import configure

__all__ = ["configure"]
