"""Replaces steps of nbgrader: ``config.configure`` names the classes of ``preprocessors``,
``release``, ``collect`` … that it runs instead of its own; ``patches`` replaces what cannot be
configured.

The modules are not imported here: nbgrader reads ``config`` at every command, and few commands need
the others.
"""
