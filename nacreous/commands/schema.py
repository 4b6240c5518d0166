"""`nacreous schema`: the JSON Schema of the files."""

from __future__ import annotations

import argparse

_EXAMPLES = """\
examples:
  nacreous schema pearl                      every key with its meaning, range and source
  nacreous schema scene > scene.schema.json  for an editor that completes and checks TOML
"""


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Describe the command."""
    parser = subparsers.add_parser(
        "schema",
        help="print the JSON Schema of pearl, scene or study files",
        description="Print the JSON Schema (draft 2020-12) of pearl, scene or study files.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("kind", choices=("pearl", "scene", "study"), help="which file")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Print the schema."""
    import json

    from nacreous.spec import Pearl, Scene, json_schema
    from nacreous.spec.specfile import SpecFile
    from nacreous.study.design import Design

    models: dict[str, type[SpecFile]] = {"pearl": Pearl, "scene": Scene, "study": Design}
    print(json.dumps(json_schema(models[args.kind]), indent=2, ensure_ascii=False))
    return 0
