"""Calls from a page: what is found, what is refused, and that both come back as JSON."""

import json
import re

import pytest

from website.browser import answer


def test_a_function_of_the_room_answers_as_json():
    assert json.loads(answer("practice.advice", '{"titles": {}}'))["value"]["problem"] == ""


@pytest.mark.parametrize("name", [
    "cells", "cells.sys", "cells.__name__", "calls._function", "os.system", "..algebra.names.guide",
    "calls.import_module", "",
])  # fmt: skip
def test_nothing_else_can_be_called(name):
    found = json.loads(answer(name))
    assert set(found) == {"error"}
    assert re.search("has no function|No module named", found["error"])


@pytest.mark.parametrize("arguments", ['{"of": 1}', "[]", "{", "1"])
def test_arguments_that_do_not_fit_are_an_error_in_words(arguments):
    assert "rror: " in json.loads(answer("practice.advice", arguments))["error"]
