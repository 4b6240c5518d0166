"""The parser of the command line: its commands, and what it says of words that it does not know."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence
from importlib import import_module
from typing import Any, NoReturn

from nacreous.problem import InputError

#: Modules of `nacreous.commands`, in the order of the help page.
COMMANDS = (
    "render",
    "view",
    "turn",
    "grow",
    "sheets",
    "paper",
    "crops",
    "measure",
    "card",
    "scale",
    "study",
    "strand",
    "words",
    "presets",
    "schema",
    "completion",
)

#: What options with numbers are told to want.
_NUMBERS: Mapping[type[int] | type[float], str] = {int: "a whole number", float: "a number"}

#: Options that may stand more than once: those that make a list, and those that only say yes.
_REPEATED = (argparse._AppendAction, argparse._StoreTrueAction)

_EXAMPLES = """\
examples:
  nacreous render paper          the pearl of 1996, as pearl.png
  nacreous view                  a pearl to turn, with all its knobs, in the browser
  nacreous turn tahitian         on a turntable, as turn.webp
  nacreous sheets out            families, pigments and scenes on contact sheets
  nacreous paper out             the paper's figures again, measured, on one page
  nacreous measure pearl.png     size, colour by ring and lamp's image in numbers
  nacreous card akoya-rg         its value factors in words and numbers, on a page
  nacreous scale paper           the paper's judgements as a scale, with a report
  nacreous study new paper       the paper's experiment, ready for participants
  nacreous study demo            a whole study on this computer, to look at
  nacreous strand draw           a lot of pearls, to sort into strands that match
  nacreous words luster          the trade's words and the numbers they stand for
  nacreous presets               see the pearls and scenes that come along
  nacreous presets pearl paper   look at the file of one of them
  nacreous schema pearl          every key of a pearl file, for editors

Each command explains itself: nacreous COMMAND --help
"""


class _Parser(argparse.ArgumentParser):
    """argparse, with problems said as the rest of the command line says them."""

    #: What each option was given in this call so far, other than those that make a list.
    _given: dict[argparse.Action, Sequence[str]]

    def _get_values(self, action: argparse.Action, arg_strings: list[str]) -> Any:
        """What an option is given, once: argparse would let the last one win in silence."""
        if action.option_strings and not isinstance(action, _REPEATED):
            if action in self._given:
                both = (self._given[action], arg_strings)
                words = " and ".join(ascii(" ".join(each))[:60] for each in both if each)
                said = f"is given twice{words and f', as {words}'}; allowed: once"
                raise InputError(f"{'/'.join(action.option_strings)} {said}")
            self._given[action] = tuple(arg_strings)
        return super()._get_values(action, arg_strings)

    def _get_value(self, action: argparse.Action, arg_string: str) -> Any:
        """A number as its option takes it, or what it should have been in words."""
        try:
            return super()._get_value(action, arg_string)
        except argparse.ArgumentError:
            for kind, wanted in _NUMBERS.items():
                if action.type is kind:
                    said = f"{arg_string[:40]!r} is not {wanted}"
                    raise argparse.ArgumentError(action, said) from None
            raise

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        """What argparse words differently from version to version, with the nearest choice."""
        if action.choices is None or value in action.choices:
            return
        choices = [str(choice) for choice in action.choices]
        name = argparse._get_action_name(action) or "argument"
        raise InputError(f"{name} is {ascii(value)[:60]}; {nearest(str(value), choices)}")

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """What argparse would leave to the main parser, which knows no command's options."""
        self._given = {}
        found, unknown = super().parse_known_args(args, namespace)
        if unknown:
            from difflib import get_close_matches

            options = [one for action in self._actions for one in action.option_strings]
            near = get_close_matches(unknown[0].partition("=")[0], options, n=1)
            hint = f"; did you mean {near[0]}?" if near else ""
            self.error(f"unrecognized arguments: {' '.join(unknown)}{hint}")
        return found, unknown

    def _print_message(self, message: str, file: Any = None) -> None:
        """Help; a full disk is told, of which argparse is silent."""
        stream = sys.stderr if file is None else file
        if message and stream is not None:
            stream.write(message)

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


def nearest(word: str, choices: Sequence[str]) -> str:
    """The choice that was probably meant, in small letters or capitals, or all of them."""
    from difflib import get_close_matches

    known = {choice.casefold(): choice for choice in choices}
    near = get_close_matches(word.casefold(), known, n=1)
    return f"did you mean {known[near[0]]}?" if near else f"allowed: {', '.join(choices)}"
