"""The worked examples of the book, one module for each chapter:
``from newton_euler.chapters.examples.ch02 import Nozzle``.
"""
