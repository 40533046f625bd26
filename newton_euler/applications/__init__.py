"""The Earth as a frame, rotors, gyroscopes (chapters 6, 9, 10)."""
