"""Families of random models that judge the engine, and that no repair of it may be fitted to.

Written by another hand than :mod:`tests.honesty.families`; ``python -m tests.honesty --holdout``
runs them. :data:`~tests.honesty.cases.HOLDOUT` lists them by name. Looking into one to find out why
it fails uses it up: let a new one take its place here, and move the old one to
:mod:`tests.honesty.families`.
"""

from importlib import import_module
from pkgutil import iter_modules

for module in iter_modules(__path__, f"{__name__}."):
    import_module(module.name)
