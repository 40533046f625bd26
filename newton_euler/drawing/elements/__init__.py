"""What a sketch can draw, one file for each kind: vectors, supports, measures, lines, solids,
machine parts. Each is a class of methods that :class:`~newton_euler.drawing.Sketch` gathers.
"""
