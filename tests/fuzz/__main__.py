"""``python -m tests.fuzz``: what do the public names of the engine do with bad values?"""

import argparse
import sys
from collections import Counter

from tests.fuzz.judge import OUTCOMES, counts, stripped, table
from tests.fuzz.names import public_callables
from tests.fuzz.valid import valid_calls

HELP = """\
Calls every public name with valid arguments, one of which is replaced by a bad value: text, None,
nan, quantities with units, frames where a number belongs ... A call is

  answered  with a result
  refused   by an error in words: a NewtonEulerError, or one that the engine raises itself
  raw       by an error that comes from inside
  slow      not ended in some seconds
  units     of those answered, the calls with a quantity of pint or astropy
"""


def main():
    parser = argparse.ArgumentParser(
        prog="python -m tests.fuzz", description=HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )  # fmt: skip
    parser.add_argument("names", nargs="*", help="parts of names; default: all")
    parser.add_argument("--every", type=int, help="one call in EVERY, always the same ones")
    parser.add_argument("--raw", action="store_true", help="list the calls that are raw or slow")
    given = parser.parse_args()
    functions = public_callables()
    calls = valid_calls(functions)
    if given.names:
        functions = {n: f for n, f in functions.items() if any(part in n for part in given.names)}
    width = max(map(len, functions))
    print(f"{'name':<{width}}  calls {' '.join(f'{o:>8}' for o in OUTCOMES)}    units")

    def line(name, rows):
        found = counts(rows)
        numbers = " ".join(f"{found[o] or '':>8}" for o in OUTCOMES)
        print(
            f"{name:<{width}} {len(rows):>6} {numbers} {len(stripped(rows)) or '':>8}", flush=True
        )
        if given.raw:
            for argument, bad, outcome, message in rows:
                if outcome in ("raw", "slow"):
                    print(f"    {argument} = {bad}: {outcome}, {message}")

    rows = table(functions, calls, given.every, line)
    every = [row for name in rows for row in rows[name]]
    line("all", every)
    print(f"{len(functions)} names, {len(functions) - len(rows)} without a valid call")
    print(", ".join(n for n in functions if n not in rows))
    return Counter(row[2] for row in every)["raw"] > 0


if __name__ == "__main__":
    sys.exit(main())
