"""The command line: `nacreous COMMAND ...`.

This frame turns what goes wrong into one plain line and an exit code; the commands do the work.

| code | meaning |
|---|---|
| 0 | done |
| 1 | the machine refused: a full disk, a folder without permission |
| 2 | something given cannot be used; nothing was written |
| 130 | interrupted; nothing was written |
| 141 | the reader of a pipe went away, as `head` does |
"""

from __future__ import annotations

import argparse
import atexit
import gc
import os
import sys
from collections.abc import Sequence
from importlib import import_module
from typing import NoReturn

from nacreous.printable import printable
from nacreous.problem import InputError

#: Modules of `nacreous.commands`, in the order of the help page.
COMMANDS = ("render", "grow", "sheets", "paper", "crops", "scale", "study", "presets", "schema")

_EXAMPLES = """\
examples:
  nacreous render paper          the pearl of 1996, as pearl.png
  nacreous sheets out            families, pigments and scenes on contact sheets
  nacreous paper out             the paper's figures again, measured, on one page
  nacreous scale paper           the paper's judgements as a scale, with a report
  nacreous study new paper       the paper's experiment, ready for participants
  nacreous study demo            a whole study on this computer, to look at
  nacreous presets               see the pearls and scenes that come along
  nacreous presets pearl paper   look at the file of one of them
  nacreous schema pearl          every key of a pearl file, for editors

Each command explains itself: nacreous COMMAND --help
"""


class _Parser(argparse.ArgumentParser):
    """argparse, with problems said as the rest of the command line says them."""

    def error(self, message: str) -> NoReturn:
        raise InputError(f"{message}; try: {self.prog} --help")


def build_parser(commands: Sequence[str]) -> argparse.ArgumentParser:
    """The parser with these commands."""
    parser = _Parser(
        prog="nacreous",
        description="From the layers of a pearl to the way people judge its look.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="store_true", help="print the version and stop")
    subparsers = parser.add_subparsers(title="commands", metavar="COMMAND", dest="command")
    for command in commands:
        import_module(f"nacreous.commands.{command}").add_parser(subparsers)
    return parser


def run_program() -> int:
    """Run the command that this process was started for, and give its exit code."""
    # Python's last search for garbage would take as long as reading the files did; what lies in
    # no circle is cleaned up all the same.
    atexit.register(gc.freeze)
    return main()


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command and give its exit code; argv is without the program's name."""
    arguments = list(sys.argv[1:] if argv is None else argv)
    try:
        code = _run(arguments)
        if sys.stdout is not None:
            sys.stdout.flush()  # so that a closed pipe or a full disk shows here
    except InputError as problem:
        return _complain(str(problem), 2)
    except KeyboardInterrupt:
        return _complain("interrupted; nothing was written", 130)
    except BrokenPipeError:
        _leave_pipe()
        return 141
    except OSError as problem:
        where = f"{problem.filename}: " if problem.filename else ""
        _leave_pipe()
        return _complain(f"{where}{problem.strerror or problem}", 1)
    except Exception as problem:
        if not _wraps_interrupt(problem):
            raise
        return _complain("interrupted; nothing was written", 130)
    return code


def _wraps_interrupt(problem: Exception) -> bool:
    """Whether Ctrl-C met pydantic as it built a validator: it raises an error that quotes it."""
    return type(problem).__name__ == "SchemaError" and "KeyboardInterrupt" in str(problem)


def _run(arguments: list[str]) -> int:
    commands: Sequence[str] = COMMANDS
    if arguments and not arguments[0].startswith("-"):
        _check_command(arguments[0])
        commands = arguments[:1]  # the others need not be loaded
    parser = build_parser(commands)
    try:
        args = parser.parse_args(arguments)
    except SystemExit as done:  # --help has been printed
        return int(done.code or 0)
    if args.version:
        print(f"nacreous {_version()}")
        return 0
    if args.command is None:
        raise InputError(f"wanted: a command, such as {COMMANDS[0]}; try: {parser.prog} --help")
    return int(args.run(args))


def _check_command(name: str) -> None:
    """Say which command was probably meant."""
    if name in COMMANDS:
        return
    from difflib import get_close_matches

    near = get_close_matches(name, COMMANDS, n=1)
    hint = f"did you mean {near[0]}?" if near else f"commands: {', '.join(COMMANDS)}"
    raise InputError(f"{ascii(name)[1:-1]} is not a command; {hint}")


def _version() -> str:
    from importlib.metadata import version

    return version("nacreous")


def _complain(lines: str, code: int) -> int:
    """Each line on stderr under the program's name."""
    if sys.stderr is not None:
        for line in lines.splitlines():
            print(f"nacreous: {printable(line)}", file=sys.stderr)
    return code


def _leave_pipe() -> None:
    """Send what is still buffered nowhere, or Python would complain about it on leaving."""
    if sys.stdout is None:
        return
    try:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        os.close(nowhere)
    except (OSError, ValueError):  # a stdout that is no file, as under test
        return
