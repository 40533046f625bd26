"""The place from which notebooks released before version 0.3 import ``expect`` and ``receipt``."""

from ..answers.receipts import expect, receipt

__all__ = ["expect", "receipt"]
