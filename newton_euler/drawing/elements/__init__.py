"""What a sketch can draw: classes that :class:`~newton_euler.drawing.Sketch` gathers."""
