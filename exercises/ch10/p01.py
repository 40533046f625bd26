"""10/1: a spinning disk, hanging from a ball joint and precessing."""

from exercises.devices.hanging_disk import draw, mistakes, prove, solve, steps
