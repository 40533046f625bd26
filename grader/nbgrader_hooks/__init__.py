"""Replacements of steps of nbgrader: ``config.configure`` names the classes of ``preprocessors``,
``release``, ``collect`` … to be run instead; ``patches`` replaces what cannot be configured.

The modules are not imported here: nbgrader reads ``config`` at every command, and rarely needs the
others.
"""
