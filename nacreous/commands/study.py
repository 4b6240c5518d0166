"""`nacreous study`: samples before people's eyes; a study is made, and later run, from its file."""

from __future__ import annotations

import argparse
import time

from nacreous.commands import study_demo, study_entry, study_report, study_serve, study_store
from nacreous.commands.terminal import say
from nacreous.problem import InputError
from nacreous.stream import STREAM

_EXAMPLES = """\
examples:
  nacreous study demo                            all of it at once, with simulated observers
  nacreous study new paper                       the experiment of 1996, in the folder paper-study
  nacreous presets study paper > my-study.toml   begin a study of your own with it
  nacreous study new my-study.toml -o my-study   render its stimuli and freeze it
  nacreous study serve my-study                  its pages, for participants and experimenters
"""


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Describe the command and what it can do."""
    parser = subparsers.add_parser(
        "study",
        help="ask people which of two looks more like a pearl",
        description="Make a study of paired comparisons from a file that says what is shown, what "
        "is asked and of whom.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    actions = parser.add_subparsers(title="actions", metavar="ACTION", dest="action", required=True)
    study_demo.add_demo(actions)
    _add_new(actions)
    study_serve.add_actions(actions)
    study_demo.add_rehearse(actions)
    study_report.add_action(actions)
    study_entry.add_actions(actions)
    study_store.add_actions(actions)


def _add_new(actions: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    parser = actions.add_parser(
        "new",
        help="render all stimuli of a study file and freeze it",
        description="Render or read all stimuli of a study file and write them with a manifest "
        "into a folder, all or nothing. A frozen study does not change again: hashes show it.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("study", help="a study file, or a preset's name")
    parser.add_argument(
        "-o", "--output", help="a folder, empty or not there yet (the file's name and -study)"
    )
    parser.set_defaults(run=new)


def new(args: argparse.Namespace) -> int:
    """Freeze a study, and say what a participant will see."""
    from pathlib import Path

    from nacreous.commands.progress import bar
    from nacreous.study.design import Design, freeze
    from nacreous.study.design.outside import files_outside
    from nacreous.study.plan import repetitions, trials

    if args.study == STREAM:
        raise InputError(
            "study is -, and standard input has no folder for the files that a study names; "
            "allowed: a study file, or a preset's name"
        )
    output = args.output or f"{Path(args.study).stem}-study"
    shown = trials(Design.load(args.study), 0)  # what cannot be planned is not frozen
    begin = time.monotonic()
    with bar("making stimuli") as show:
        frozen = freeze(args.study, output, show)
    say(
        f"{output}: study {frozen.design.name}, {len(frozen.stimuli)} stimuli, "
        f"{len(shown)} trials a participant, {time.monotonic() - begin:.1f} s; "
        f"hash {frozen.study_hash[:12]}"
    )
    for place in files_outside(args.study):
        say(f"{output}: holds a picture made with {place}, which is outside the study's folder")
    if again := repetitions(shown):
        say(
            f"{output}: a stimulus is shown twice in a row {again} times; with so few stimuli or "
            "pairs there is no better order"
        )
    return 0
