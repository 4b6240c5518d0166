"""The command line's door: `nacreous` and `python -m nacreous`."""

import sys


def run() -> int:
    """Run the command that this process was started for, and give its exit code."""
    try:
        from nacreous.cli import main, prepare

        prepare()
    except KeyboardInterrupt:  # pressed before there was anything to interrupt
        print("nacreous: interrupted; nothing was written", file=sys.stderr)
        return 130
    return main()


if __name__ == "__main__":
    sys.exit(run())
