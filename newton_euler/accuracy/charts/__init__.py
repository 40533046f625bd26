"""What is drawn and said of measurements: axes, captions, the table of all charts, and the atlas."""
