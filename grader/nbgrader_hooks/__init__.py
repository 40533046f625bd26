"""What nbgrader runs in place of its own: ``config.configure`` names the classes of
``preprocessors``, ``release`` and ``assignment.fetch``.

The modules are not imported here: nbgrader reads ``config`` at every command, and only some of them
need the others.
"""
