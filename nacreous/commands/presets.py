"""`nacreous presets`: what comes with the package."""

from __future__ import annotations

import argparse

_EXAMPLES = """\
examples:
  nacreous presets                       every preset, one line each
  nacreous presets scene                 the scenes only
  nacreous presets scene booth           the file of one preset, as it stands
  nacreous presets pearl paper > my.toml begin a pearl of your own with it
  nacreous presets --json                pearls, scenes and nacre with every key, for a browser
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
    parser.add_argument(
        "--json", action="store_true", help="with every key written out, as JSON (not of studies)"
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Print the list, the file or the JSON."""
    from nacreous.spec import preset

    if args.json:
        print(_json(args.kind, args.name))
        return 0
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


def _json(kind: str | None, name: str | None) -> str:
    """Presets by kind and name, or one of them."""
    import json

    from nacreous.complete import KINDS, complete, presets
    from nacreous.problem import InputError

    kinds = [one for one in KINDS if kind in (None, one)]
    if not kinds:
        raise InputError(f"{kind} presets have no JSON; allowed: {', '.join(KINDS)}")
    if name:
        return json.dumps(complete(kinds[0], name), ensure_ascii=False)
    return json.dumps(presets(kinds), ensure_ascii=False)
