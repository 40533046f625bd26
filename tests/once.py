"""What several workers of pytest need is made by the first that asks for it."""

import json
import os


def common(tmp_path_factory):
    """The temporary folder shared by all workers of a run."""
    own = tmp_path_factory.getbasetemp()
    return own.parent if "PYTEST_XDIST_WORKER" in os.environ else own


def once(tmp_path_factory, name, make):
    """(a common folder of this name, what ``make(folder)`` returned: JSON)."""
    import fcntl

    folder = common(tmp_path_factory) / name
    with open(folder.with_suffix(".json"), "a+") as result:
        fcntl.flock(result, fcntl.LOCK_EX)
        result.seek(0)
        if not (text := result.read()):
            folder.mkdir(exist_ok=True)
            text = json.dumps(make(folder))
            result.write(text)
    return folder, json.loads(text)
