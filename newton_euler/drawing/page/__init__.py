"""The page of a figure: what is recorded is projected, ordered from far to near, and labelled."""
