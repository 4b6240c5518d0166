"""`nacreous presets`: what comes with the package."""

from __future__ import annotations

import argparse

_EXAMPLES = """\
examples:
  nacreous presets                       every preset, one line each
  nacreous presets scene                 the scenes only
  nacreous presets scene booth           the file of one preset, as it stands
  nacreous presets pearl paper > my.toml begin a pearl of your own with it
"""


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Describe the command."""
    parser = subparsers.add_parser(
        "presets",
        help="list the pearls, scenes, nacre and studies that come along",
        description="List the presets, or show the file of one. A preset's name serves wherever "
        "a file does.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "kind", nargs="?", choices=("pearl", "scene", "nacre", "study"), help="only these"
    )
    parser.add_argument("name", nargs="?", help="show this preset's file")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Print the list or the file."""
    from nacreous.spec import preset

    if args.name:
        print(preset.text(args.kind, args.name), end="")
        return 0
    kinds = [args.kind] if args.kind else list(preset.FOLDERS)
    width = max(len(name) for kind in kinds for name in preset.names(kind))
    for kind in kinds:
        print(f"{kind}:")
        for name in preset.names(kind):
            print(f"  {name:{width}}  {preset.summary(kind, name)}")
    return 0
