"""What stands in a pickle for what cannot be pickled: for a function that computes something on
demand, what it returns; for a read-only mapping, its contents.
"""

import copyreg
from types import MappingProxyType

from .scalars import NewtonEulerError


class Found:
    """What a function without arguments returns now, or the error of the engine that it raises; as
    a function again, which can be pickled where that one cannot. It may get arguments.
    """

    def __init__(self, find):
        self.value = self.error = None
        try:
            self.value = find()
        except NewtonEulerError as error:
            self.error = error

    def __call__(self, *_):
        if self.error is not None:
            raise self.error
        return self.value


def read_only(values):
    """The read-only mapping of these values, a dict."""
    return MappingProxyType(values)


# results of the engine are read-only mappings, which Python itself does not pickle
copyreg.pickle(MappingProxyType, lambda values: (read_only, (dict(values),)))
