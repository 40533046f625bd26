"""A spring from a pin to a particle on a smooth track (11/5, 11/8, 11/11, 11/12): its pull."""

from exercises.catalogue.proofs.digits import Force, Number, Place
from exercises.tools import minus, scaled, size


def pull(k: Number, free_length: Number, pin: Place) -> Force:
    """The force on the particle as a function of its place, toward the pin."""

    def force(place):
        d = minus(pin, place)
        length = size(d)
        return scaled(k * (length - free_length) / length, d)

    return force
