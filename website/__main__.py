"""``python -m website``: the course as static pages; ``--help`` says more."""

from .command import main

if __name__ == "__main__":
    main(prog_name="python -m website")
