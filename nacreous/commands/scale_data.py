"""What `nacreous scale` reads: a table of answers, a study's export, counts, or the paper's."""

from __future__ import annotations

import argparse
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from nacreous.scaling import Answers
    from nacreous.scaling.report.settings import Settings

#: The word for the paper's own counts in place of a file.
PAPER = "paper"

#: Options about a table of answers, which counts and exports of a study do not need.
_OF_ANSWERS = (
    "column",
    "left",
    "right",
    "tie",
    "no_sides",
    "repeats",
    "skip_rows",
    "skip_unanswered",
    "encoding",
)
#: Columns that the table of people of a study's export has.
_OF_PEOPLE = frozenset({"person", "excluded", "simulated", "answers", "trials", "entered_at"})


def data_of(args: argparse.Namespace) -> Any:
    """Answers or counts, as the options say they are to be read."""
    from nacreous.problem import InputError
    from nacreous.scaling import Answers, Comparisons, paper
    from nacreous.scaling.data.question import SeveralQuestionsError

    if args.answers.casefold() == PAPER != args.answers and not Path(args.answers).exists():
        raise InputError(f"{args.answers}: does not exist; did you mean {PAPER}?")
    names = _columns(args)
    unneeded = [f"--{name.replace('_', '-')}" for name in _OF_ANSWERS if _is_given(args, name)]
    if (args.counts or args.answers == PAPER) and unneeded:
        raise InputError(f"{unneeded[0]} is given with counts; allowed: with a table of answers")
    if args.answers == PAPER:
        return paper()
    if args.counts:
        return Comparisons.read_counts(args.answers)
    exported = _exported(args)
    if exported is not None and unneeded:
        raise InputError(
            f"{unneeded[0]} is given with an export of a study, whose columns and repeats are "
            "known; allowed: with another table of answers"
        )
    if exported is not None:
        return exported
    read = partial(
        Answers.read,
        args.answers,
        repeats=args.repeats,
        sided=not args.no_sides,
        skip_unanswered=args.skip_unanswered,
        skip_rows=args.skip_rows or 0,
        encoding=args.encoding,
    )
    try:
        return read(**names)
    except SeveralQuestionsError:
        if args.question is None:
            raise
    return read(question=args.question, **names)


def _exported(args: argparse.Namespace) -> Answers | None:
    """The answers of a study's export that count; None for any other table."""
    if not _may_be_export(args.answers):
        return None
    from nacreous.study.results import exported_answers

    return exported_answers(args.answers, args.question, simulated=args.simulated)


def _may_be_export(path: str) -> bool:
    """Whether it is worth a second to load what reads exports, the store's database included."""
    from nacreous.problem import InputError
    from nacreous.scaling.data.table import column_names
    from nacreous.study.task.counting import HEEDED

    names = {name.casefold() for name in column_names(path, [HEEDED])}
    if names >= _OF_PEOPLE and not names & {"left", "kind"}:
        raise InputError(
            f"{path}: is the table of people of a study's export; wanted: the table of answers, as "
            "`nacreous study export -o answers.csv` writes it"
        )
    return len(names.intersection(HEEDED)) > 1  # of an export without one of them it is said


def _is_given(args: argparse.Namespace, name: str) -> bool:
    return getattr(args, name) not in (None, False, [])


def _columns(args: argparse.Namespace) -> dict[str, Any]:
    """The columns' names by role."""
    from nacreous.problem import InputError

    words = {"tie": args.tie, "left_word": args.left, "right_word": args.right}
    names: dict[str, Any] = {role: word for role, word in words.items() if word is not None}
    for setting in args.column:
        role, equals, name = setting.partition("=")
        if not equals or not role or role in words:
            raise InputError(f'--column "{setting}": wanted: role=name, such as left=first')
        if role in names:
            raise InputError(f"--column {role} is given twice; allowed: once")
        names[role] = name
    return names


def settings_of(args: argparse.Namespace) -> Settings:
    """How the study's own report fits its export; of other data the defaults.

    Where method or prior is given, the export is not asked.
    """
    from nacreous.scaling.report.settings import Settings

    said = args.method is not None or args.prior is not None
    if said or args.counts or args.answers == PAPER or not _may_be_export(args.answers):
        return Settings()
    from nacreous.study.results import exported_settings

    return exported_settings(args.answers) or Settings()


def check_group(data: Any, column: str | None) -> None:
    """Refuse a column in which all are alike, by its name."""
    from nacreous.problem import InputError
    from nacreous.scaling import Answers
    from nacreous.scaling.data.fault import listed

    if column is None or not isinstance(data, Answers):
        return
    groups = data.split(column)
    if len(groups) < 2:
        held = listed(groups) or "nothing"
        raise InputError(
            f"group is {column!r}, a column that holds {held}; allowed: one with 2 groups or more"
        )
