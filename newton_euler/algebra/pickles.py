"""What pickles hold in place of a function that computes on demand, or a read-only mapping."""

import copyreg
from collections.abc import Callable
from types import MappingProxyType
from typing import Any

from .scalars import NewtonEulerError


class Computed:
    """A function that returns what ``find()`` returned, or raises what it raised; to be pickled."""

    def __init__(self, find: Callable[[], Any]):
        self.value = self.error = None
        try:
            self.value = find()
        except NewtonEulerError as error:
            self.error = error

    def __call__(self, *_: object) -> Any:
        if self.error is not None:
            raise self.error
        return self.value


def read_only(values: dict) -> MappingProxyType:
    """The read-only mapping of these values, a dict."""
    return MappingProxyType(values)


# results of the engine are read-only mappings, which Python itself does not pickle
copyreg.pickle(MappingProxyType, lambda values: (read_only, (dict(values),)))
