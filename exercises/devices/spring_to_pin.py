"""A spring from a fixed pin to a particle on a smooth track, as in 11/8, 11/11 and 11/12: its pull
for the proof.
"""

from exercises.tools import minus, scaled, size


def pull(k, free_length, pin):
    """The force on the particle as a function of its place, toward the pin."""

    def force(place):
        d = minus(pin, place)
        length = size(d)
        return scaled(k * (length - free_length) / length, d)

    return force
