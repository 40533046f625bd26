"""Exact solutions that scenes share."""
