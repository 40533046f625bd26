"""10/2: the hanging disk of 10/1, closer to the vertical."""

from exercises.devices import hanging_disk as device

draw, mistakes, prove = device.draw, device.mistakes, device.prove
solve, steps = device.solve, device.steps
