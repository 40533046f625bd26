"""Charts of what was measured, and captions that follow from it."""
