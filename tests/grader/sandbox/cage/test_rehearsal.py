"""What runs ahead of all submissions raises no error and leaves nothing behind."""

import json
import sys

from grader.sandbox.cage import rehearsal


def test_the_sheet_is_read_without_a_fault_and_leaves_no_trace():
    before, path = sys.modules["__main__"], list(sys.path)
    receipts = [json.loads(line) for line in rehearsal.rehearse()]
    assert (sys.modules["__main__"], sys.path) == (before, path)
    assert [(r["error"], r["faults"]) for r in receipts] == [(None, {})] * 2
    read = {k: x for r in receipts for k, x in r["answers"].items()}
    assert [k for k, x in read.items() if x is None] == ["blank"]
