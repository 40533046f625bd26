"""Families of random models, one subject a file.

:data:`~tests.honesty.cases.FAMILIES` lists them by name.
"""

from importlib import import_module
from pkgutil import iter_modules

for module in iter_modules(__path__, f"{__name__}."):
    import_module(module.name)
