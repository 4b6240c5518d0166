"""`python -m nacreous` is the command line."""

import sys

from nacreous.cli import main

if __name__ == "__main__":
    sys.exit(main())
