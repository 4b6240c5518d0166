"""`nacreous completion`: what a shell needs to complete commands, options and file names."""

from __future__ import annotations

import argparse

from nacreous.commands.terminal import say

_EXAMPLES = """\
examples:
  nacreous completion bash > ~/.local/share/bash-completion/completions/nacreous
  nacreous completion zsh > ~/.zfunc/_nacreous   with fpath+=~/.zfunc before compinit
"""


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Describe the command."""
    parser = subparsers.add_parser(
        "completion",
        help="print what a shell needs to complete this program's words",
        description="Print the script with which a shell completes commands, options and files.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("shell", choices=("bash", "zsh", "tcsh"), help="which shell")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Print the script."""
    import shtab

    from nacreous.commands.parser import COMMANDS, build_parser

    parser = build_parser(COMMANDS)
    _complete_files(parser)
    say(shtab.complete(parser, args.shell))
    return 0


def _complete_files(parser: argparse.ArgumentParser) -> None:
    """Tell shtab that whatever takes a word of any kind may take a file's name."""
    import shtab

    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for child in action.choices.values():
                _complete_files(child)
        elif action.choices is None and action.type is None and action.nargs != 0:
            action.complete = shtab.FILE  # type: ignore[attr-defined]
