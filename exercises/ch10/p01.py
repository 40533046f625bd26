"""10/1: a spinning disk that hangs from a ball joint and precesses."""

from exercises.devices import hanging_disk as device

draw, mistakes, prove = device.draw, device.mistakes, device.prove
solve, steps = device.solve, device.steps
