"""Ready models of the motions in the book, one scene a file."""
