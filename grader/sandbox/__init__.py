"""Runs student code in a process that reaches no key, no other submission, no file of the
instructor and no network.
"""

from .harvester import CELL_SECONDS, SECONDS, Harvester
from .worker import HarvestError

__all__ = ["CELL_SECONDS", "SECONDS", "HarvestError", "Harvester"]
