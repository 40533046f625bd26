"""Running student code without access to keys, submissions, the instructor's files, the network."""

from .harvester import CAGED, CELL_SECONDS, RUN_SECONDS, SECONDS, Harvester
from .worker import HarvestError
