"""What is drawn and said of measurements: axes, captions, the table of charts, and the atlas."""
