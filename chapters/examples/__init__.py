"""The worked examples of the book, one module a chapter:
``from newton_euler.chapters.examples.ch02 import Nozzle``.
"""
