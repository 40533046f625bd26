"""Integrals over one and several variables, and roots between two places, of functions of every
kind of number.
"""

from .integrals import WorkError, integral
from .roots import root
