"""10/2: the hanging disk of 10/1, closer to the vertical."""

from exercises.devices.hanging_disk import draw, mistakes, prove, solve, steps
