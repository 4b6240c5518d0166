"""`nacreous scale`: answers in, a scale and its report out."""

from __future__ import annotations

import argparse
import time
from typing import TYPE_CHECKING, Any

from nacreous.commands.scale_data import PAPER, check_group, data_of, settings_of
from nacreous.commands.terminal import say

if TYPE_CHECKING:
    from nacreous.scaling.report.analysis import Analysis
    from nacreous.scaling.report.called import Called
    from nacreous.scaling.report.settings import Settings

_EXAMPLES = """\
examples:
  nacreous scale paper                             the paper's example, as report.html
  nacreous scale answers.csv -o report.html -o scale.csv
  nacreous scale answers.csv --question "Which shines more?" --group sex --language ja
  nacreous scale answers.csv --column left=first --column right=second --unit JOD
  nacreous scale answers.csv --stimuli numbers.csv   with the trade's words for their numbers
  nacreous scale counts.csv --counts               a square table: row chosen over column
"""


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Describe the command."""
    parser = subparsers.add_parser(
        "scale",
        help="turn choices between two things into a scale, with a report",
        description="Turn answers to 'which of these two ...?' into a scale, and write a report "
        "that reads without statistics. Answers are a .csv, .tsv, .txt or .parquet file, "
        "a row an answer, with the columns left, right and chosen (or winner and loser), and where "
        "known person, time, response_s and groups. Qualtrics's wide tables are read too. "
        "Of a file by 'nacreous study export' what counts is taken, as in the study's own report.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "answers", help=f"a file of answers, - for CSV from standard input, or {PAPER}"
    )
    parser.add_argument(
        "-o",
        "--output",
        action="append",
        default=[],
        help="report.html, or .csv (the scale), .json (every number), - (CSV); may be repeated",
    )
    parser.add_argument(
        "--question",
        help="as it was put to people, for the report; of a "
        "study's export, or a column question, with several, one of them",
    )
    parser.add_argument("--language", choices=("en", "ja"), default="en", help="of the report (en)")
    _add_data(parser)
    _add_model(parser)
    parser.set_defaults(run=run)


def _add_data(parser: argparse.ArgumentParser) -> None:
    data = parser.add_argument_group("the data")
    data.add_argument("--counts", action="store_true", help="the file is a square table of counts")
    data.add_argument(
        "--column",
        action="append",
        default=[],
        metavar="ROLE=NAME",
        help="left, right, chosen (or winner, loser), person, time, trial, response_s, "
        "response_ms, count by another name; time= and the like for none",
    )
    data.add_argument("--left", metavar="WORD", help="what chosen holds where the left one was")
    data.add_argument("--right", metavar="WORD", help="what chosen holds where the right one was")
    data.add_argument("--tie", metavar="WORD", help="what chosen holds where neither was (tie)")
    data.add_argument(
        "--skip-rows", type=int, metavar="N", help="leave out the first rows, above the names"
    )
    data.add_argument(
        "--skip-unanswered", action="store_true", help="leave out rows whose chosen is empty"
    )
    data.add_argument(
        "--encoding", metavar="NAME", help="of a text file, such as shift-jis or windows-1252"
    )
    data.add_argument(
        "--no-sides", action="store_true", help="left and right were no places before the eye"
    )
    data.add_argument("--repeats", action="store_true", help="take answers given twice")
    data.add_argument("--group", metavar="COLUMN", help="compare the groups of this column")
    data.add_argument(
        "--stimuli",
        metavar="PLACE",
        help="say the trade's words of the stimuli in the report, by their numbers: a frozen "
        "study's folder, or a table with the columns stimulus and, say, facet_spread_rad",
    )
    data.add_argument(
        "--simulated", action="store_true", help="nobody gave the answers, and the report says so"
    )


def _add_model(parser: argparse.ArgumentParser) -> None:
    model = parser.add_argument_group("the model")
    model.add_argument(
        "--model",
        choices=("probit", "logit"),
        default="probit",
        help="Thurstone's case V, or Bradley and Terry's (probit)",
    )
    model.add_argument(
        "--method",
        choices=("maximum-likelihood", "bias-reduced", "least-squares"),
        help="bias-reduced: few answers do not stretch the scale; least-squares: as in the paper "
        "of 1996 (maximum-likelihood; of a study's export as the study asks for)",
    )
    model.add_argument(
        "--ties",
        action=argparse.BooleanOptionalAction,
        help="fit how near things are called equal, or count ties half (where more than 5 %% are)",
    )
    model.add_argument("--order", action="store_true", help="fit the advantage of the left one")
    model.add_argument(
        "--prior",
        type=_prior,
        metavar="SPREAD",
        help="draw the places together: a spread, or hierarchical, where it is learnt too, for "
        "pairs chosen by earlier answers (none; of a study's export as the study asks for)",
    )
    model.add_argument("--unit", choices=("z", "d'", "JOD", "JND", "logit"), help="of the scale")
    model.add_argument("--level", type=float, default=0.95, help="of intervals and tests (0.95)")
    model.add_argument(
        "--bootstrap", type=int, default=1000, metavar="N", help="resamplings, 0 for none (1000)"
    )
    model.add_argument("--seed", type=int, default=1, help="of the resamplings (1)")


def run(args: argparse.Namespace) -> int:
    """Check everything, compute, write, say what was found."""
    from dataclasses import replace

    from nacreous.commands import standard
    from nacreous.commands.progress import bar
    from nacreous.commands.scale_lines import told
    from nacreous.commands.scale_people import of_people
    from nacreous.commands.spoken import spoken
    from nacreous.scaling.report.analysis import SUFFIXES, analyse

    outputs = args.output or ["report.html"]
    for output in outputs:
        standard.check_output(output, SUFFIXES)
    read = [] if args.answers == PAPER else [args.answers]
    read += [] if args.stimuli is None else [args.stimuli]
    standard.require_apart(outputs, read)
    with standard.reading(args.answers, ".csv") as args.answers, spoken(args.answers):
        data = data_of(args)
        settings = _settings(args, settings_of(args))
        check_group(data, args.group)
        called = _called(args, data)
    begin = time.monotonic()
    with bar("resampling") as show, spoken(args.answers):
        found = analyse(data, settings, example=args.answers == PAPER, progress=show)
    _write(replace(found, called=called), outputs, args.language)
    say(told(found, time.monotonic() - begin), outputs)
    for line in of_people(data):
        say(line, outputs)
    for output in outputs:
        say(f"{output}: written", outputs)
    return 0


def _called(args: argparse.Namespace, data: Any) -> dict[str, tuple[Called, ...]]:
    """What the trade calls the stimuli, where their numbers are given."""
    if args.stimuli is None:
        return {}
    from nacreous.commands.scale_words import called_of

    return called_of(args.stimuli, data.stimuli)


def _prior(text: str) -> float | str:
    """A spread as a number, or a word."""
    if text in ("none", "hierarchical"):
        return text
    try:
        return float(text)
    except ValueError:
        allowed = "none, hierarchical or a number above 0"
        raise argparse.ArgumentTypeError(f"{text[:40]!r} is none of: {allowed}") from None


def _settings(args: argparse.Namespace, of_study: Settings) -> Settings:
    """What was asked for; where neither method nor prior was, those of the study."""
    from dataclasses import replace

    names = set(of_study.__dataclass_fields__) - {"method", "prior"}
    wanted = replace(of_study, **{name: getattr(args, name) for name in names})
    if args.method is None and args.prior is None:
        return wanted
    prior = None if args.prior == "none" else args.prior
    return replace(wanted, method=args.method or "maximum-likelihood", prior=prior)


def _write(found: Analysis, outputs: list[str], language: str) -> None:
    """All files or none: each is written beside its place, and all take their places at the end."""
    from contextlib import ExitStack

    from nacreous import file
    from nacreous.commands import standard

    with ExitStack() as streams, ExitStack() as stack:
        paths = [streams.enter_context(standard.writing(output, ".csv")) for output in outputs]
        texts = [found.text(str(path), language) for path in paths]
        places = [stack.enter_context(file.atomic(path)) for path in paths]
        for place, text in zip(places, texts, strict=True):
            place.write_text(text, encoding="utf-8", newline="\n")
