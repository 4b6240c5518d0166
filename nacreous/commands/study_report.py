"""`nacreous study report`: what a study has found, as a page that reads without statistics."""

from __future__ import annotations

import argparse

from nacreous.commands.study_store import Actions
from nacreous.commands.terminal import say

_EXAMPLES = """\
examples:
  nacreous study report my-study -o report.html
  nacreous study report my-study --question deeper --language ja -o report.html
  nacreous study report my-study --simulated -o rehearsal.html   what simulated observers answered
"""


def add_action(actions: Actions[argparse.ArgumentParser]) -> None:
    """Describe what it can do."""
    parser = actions.add_parser(
        "report",
        help="write what a study has found as a page, report.html",
        description="Fit a scale to the answers that count and write the report: pairs and "
        "repeats, of people who are not excluded; or of simulated observers, said to be so.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("study", help="the folder of a frozen study")
    parser.add_argument("-o", "--output", default="report.html", help="report.html")
    parser.add_argument("--store", help="where the answers are (NACREOUS_STORE, or the folder)")
    parser.add_argument("--question", help="its id (the study's first)")
    parser.add_argument("--language", choices=("en", "ja"), default="en", help="of the report (en)")
    parser.add_argument("--simulated", action="store_true", help="simulated observers, not people")
    parser.add_argument("--group", metavar="NAME", help="compare the groups of this factor")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Check, compute, write."""
    import os

    from nacreous import file
    from nacreous.commands import standard
    from nacreous.commands.progress import bar
    from nacreous.study.design import open_frozen
    from nacreous.study.memory import hold_little
    from nacreous.study.results import report
    from nacreous.study.running import Running
    from nacreous.study.store import Store

    hold_little()
    standard.check_output(args.output, [".html"])
    frozen = open_frozen(args.study)
    question = frozen.design.questions[0].id if args.question is None else args.question
    place = args.store or os.environ.get("NACREOUS_STORE") or args.study
    with Store.open(place, make=False) as store, bar("resampling") as show:
        standard.require_apart([args.output], [store.place])
        page = report(
            Running(store, frozen), question, args.language, args.simulated, args.group, show
        )
    with standard.writing(args.output, ".html") as path, file.atomic(path) as temporary:
        temporary.write_text(page, encoding="utf-8", newline="\n")
    say(f"{args.output}: written", [args.output])
    return 0
