"""10/1: a spinning disk, hanging from a ball joint and precessing."""

from exercises.devices import hanging_disk as device

draw, mistakes, prove = device.draw, device.mistakes, device.prove
solve, steps = device.solve, device.steps
