"""Answers, receipts and widgets of a student's notebook."""
