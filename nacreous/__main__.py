"""`python -m nacreous` is the command line."""

import sys

from nacreous.cli import run_program

if __name__ == "__main__":
    sys.exit(run_program())
