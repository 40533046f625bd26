"""The worked situations of the book as ready models and computations, one scene a file."""
