"""What comes out of the cage is data: whatever it is, it is read or skipped, at little cost."""

import json

import pytest

from grader.sandbox import receipts
from grader.sandbox.receipts import NOT_REACHED, read_lines, read_outcome

RIGHT = b'{"id": "0/1", "answers": {"x": 1}, "faults": {}, "error": null}'
OTHERS = {
    "nothing": b"",
    "no json": b"points = 100",
    "half": b'{"id": "0/1", "answers": {',
    "a list": b'["0/1"]',
    "another problem": b'{"id": "9/9", "answers": {"x": 1}}',
    "an id that is not text": b'{"id": ["0/1"], "answers": {"x": 1}}',
    "an id and a half character": b'{"id": "0/1\xff"}',
    "nested deep": b'{"id": "0/1", "answers": ' + b"[" * 985 + b"]" * 985 + b"}",
    "nested deeper": b'{"id": "0/1", "answers": ' + b"[" * 30_000 + b"]" * 30_000 + b"}",
    "too long": b'{"id": "0/1", "answers": {"x": "' + b"a" * 2**16 + b'"}}',
    "a name that was not asked for": b'{"name": "receipt", "error": "x"}',
    "a number as an error": b'{"name": "own", "error": 3}',
}


@pytest.mark.parametrize("what", OTHERS)
def test_a_line_that_is_not_a_receipt_is_skipped_and_the_next_one_is_read(what):
    read, errors = read_lines(OTHERS[what] + b"\n" + RIGHT + b"\n", {"0/1"}, {"own"})
    assert read == {"0/1": json.loads(RIGHT)}
    assert errors == {}


def test_the_first_of_two_receipts_counts_and_only_what_belongs_to_one_is_kept():
    read, _ = read_lines(RIGHT + b"\n" + RIGHT.replace(b'"x": 1', b'"x": 2'), {"0/1"}, ())
    assert read["0/1"]["answers"] == {"x": 1}
    read, _ = read_lines(b'{"id": "0/1", "answers": {}, "points": 100}', {"0/1"}, ())
    assert read["0/1"] == {"id": "0/1", "answers": {}, "faults": None, "error": None}
    # halves of characters are replaced, since no file takes them
    line = b'{"id": "0/1", "answers": {"\\udc80": "\\uD83D\\uDE00"}, "error": "\\udfff"}'
    read, _ = read_lines(line, {"0/1"}, ())
    assert (read["0/1"]["answers"], read["0/1"]["error"]) == ({"?": "\U0001f600"}, "?")
    _, errors = read_lines(json.dumps({"name": "own", "error": "e" * 3000}).encode(), (), {"own"})
    assert errors == {"own": "e" * receipts.ERROR_LIMIT}


def test_only_a_limited_number_of_lines_is_parsed(monkeypatch):
    parsed = []
    monkeypatch.setattr(receipts, "_entry", lambda line: parsed.append(line) or {})
    read_lines(b"{}\n" * 300_000, (), ())
    assert len(parsed) == receipts.MOST_LINES


OUTCOMES = {
    '"error": null, "value": 1.5': {"error": None, "value": 1.5},
    '"error": null, "value": null': {"error": None, "value": None},
    '"error": null, "value": "other"': {"error": None, "value": "other"},
    '"error": "no", "value": 5': {"error": "no", "value": None},
    '"error": null, "value": "5"': NOT_REACHED,
    '"error": null, "value": true': NOT_REACHED,
    '"error": null, "value": NaN': NOT_REACHED,
    '"error": null, "value": 1e999': NOT_REACHED,
    '"error": null, "value": [1]': NOT_REACHED,
    '"error": 3': NOT_REACHED,
    '"value": 5': NOT_REACHED,
    "5": NOT_REACHED,
}


@pytest.mark.parametrize("data", OUTCOMES)
def test_an_outcome_is_read_or_the_test_counts_as_not_reached(data):
    line = '{"token": "abc", ' + data + "}"
    assert read_outcome(line.encode(), "abc") == OUTCOMES[data]


def test_an_outcome_without_the_token_of_the_test_is_skipped():
    forged = b'{"error": null, "value": 9}\n{"token": "xyz", "error": null, "value": 9}\nhalf'
    assert read_outcome(forged, "abc") == NOT_REACHED
    right = b'\n{"token": "abc", "error": null, "value": 1}\n'
    assert read_outcome(forged + right, "abc") == {"error": None, "value": 1}
    assert read_outcome(b"", "abc") == NOT_REACHED
