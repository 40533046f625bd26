"""The telescoping boom OA of 3/17 and 3/18 on a vertical shaft: it turns with the shaft, is raised
or lowered, and its length changes.
"""

from mpmath import mp

from exercises.proofs import rot, times
from newton_euler import Frame, moving, pi, spherical
from newton_euler.drawing import Sketch


def boom_end(g, beta, length, omega):
    """Ground, and the end A by spherical coordinates; ``beta``, from the upward vertical, and
    ``length`` are moving.
    """
    ground = Frame("ground")
    elevation = pi(beta.value) / 2 - beta
    return ground, spherical(ground, "A", length, moving(0, rate=omega), elevation)


def end_in_time(omega, beta, length):
    """Proof, the place of A in time; ``beta`` and ``length`` are functions of it."""

    def A(t):
        along = [length(t) * mp.sin(beta(t)), 0, length(t) * mp.cos(beta(t))]
        return times(rot("z", omega * t), along)

    return A


def figure(g, ax, beta, length, rates=()):
    """The figure for these numbers; ``rates``: which of "beta" and "l" have an arrow."""
