"""The command line: `nacreous COMMAND ...`.

This frame turns what goes wrong into one plain line and an exit code; the commands do the work.

| code | meaning |
|---|---|
| 0 | done |
| 1 | the machine refused: a full disk, a folder without permission |
| 2 | something given cannot be used; nothing was written |
| 130 | interrupted; nothing was written |
| 141 | the reader of a pipe went away, as `head` does |
| 143 | terminated; nothing was written |
"""

from __future__ import annotations

import atexit
import gc
import io
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from nacreous.commands.parser import COMMANDS, build_parser, nearest
from nacreous.frames import without_pandas
from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.stopping import code_of, how_stopped, stop_cleanly


def prepare() -> None:
    """Make this process ready for the command that it was started for."""
    # Python's last search for garbage would take as long as reading the files did; what lies in
    # no circle is cleaned up all the same.
    atexit.register(gc.freeze)
    # A notebook names a backend of its own to the programs that it starts; ours open no window.
    os.environ.pop("MPLBACKEND", None)
    without_pandas()
    stop_cleanly()
    _speak_utf8()


def _speak_utf8() -> None:
    """Write UTF-8 into files and pipes, and to terminals of other codes what these can show.

    Labels are in any script; a terminal of code page 932 or 1252, or of ASCII, shows the others by
    their number. Who sets PYTHONIOENCODING gets that.
    """
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            chosen = stream.isatty() or os.environ.get("PYTHONIOENCODING")
            stream.reconfigure(encoding=None if chosen else "utf-8", errors="backslashreplace")


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command and give its exit code; argv is without the program's name."""
    arguments = list(sys.argv[1:] if argv is None else argv)
    try:
        code = _run(arguments)
        if sys.stdout is not None:
            sys.stdout.flush()  # so that a closed pipe or a full disk shows here
    except InputError as problem:
        return _complain(str(problem), 2)
    except KeyboardInterrupt as stop:
        return _stopped(stop)
    except BrokenPipeError:
        _leave_pipe()
        return 141
    except OSError as problem:
        _leave_pipe()
        return _complain(f"{_place(problem)}{problem.strerror or problem}", 1)
    except Exception as problem:
        if not _wraps_interrupt(problem):
            raise
        return _stopped(problem)
    return code


def _stopped(stop: BaseException) -> int:
    return _complain(f"{how_stopped(stop)}; nothing was written", code_of(stop))


def _place(problem: OSError) -> str:
    """What could not be had; the folder one stands in, where it was removed meanwhile."""
    if problem.filename:
        return f"{problem.filename}: "
    try:
        Path.cwd()
    except FileNotFoundError:
        return "the working folder: "
    return ""


def _wraps_interrupt(problem: Exception) -> bool:
    """Whether a signal met pydantic's compiled part at work, which raises errors that quote it."""
    return type(problem).__module__.startswith("pydantic_core") and any(
        name in str(problem) for name in ("KeyboardInterrupt", "Terminated")
    )


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
    raise InputError(f"{ascii(name)[1:-1]} is not a command; {nearest(name, COMMANDS)}")


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
