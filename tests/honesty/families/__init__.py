"""Families of random models, one subject a file.

:data:`~tests.honesty.cases.FAMILIES` lists them by name.
"""

from tests.honesty.families import (
    batches,
    chaotic,
    closed_solutions,
    events,
    forced,
    kinked,
    long_runs,
    mechanics,
    scales,
    singular,
    smooth,
    stiff,
    tiny,
    units_of_measure,
)

__all__ = [
    "batches",
    "chaotic",
    "closed_solutions",
    "events",
    "forced",
    "kinked",
    "long_runs",
    "mechanics",
    "scales",
    "singular",
    "smooth",
    "stiff",
    "tiny",
    "units_of_measure",
]
