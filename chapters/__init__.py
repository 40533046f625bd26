"""The notebooks of the course, one a chapter, and the worked examples of the book
(``newton_euler.chapters.examples``).
"""
