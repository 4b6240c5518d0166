"""`nacreous study backup | restore | export`, `exclude | readmit | erase`: what is kept of one."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from nacreous.commands.terminal import say

if TYPE_CHECKING:
    from nacreous.study.store import Copied, Session, Store

_EXAMPLES = """\
examples:
  nacreous study backup my-study -o monday.sqlite          while people go on answering
  nacreous study restore monday.sqlite another-folder
  nacreous study export my-study -o answers.csv            or .parquet
  nacreous study export my-study --table people            who entered, with flags
  nacreous study export my-study -o for-others             a folder by Psych-DS, with a code book
  nacreous study exclude my-study 17 --reason "left the room"
  nacreous study readmit my-study 17                       takes that back
  nacreous study erase my-study 17                         at that person's wish, for ever
"""

#: What is said after what was so already.
_UNCHANGED = "; nothing was changed"

Actions = argparse._SubParsersAction


def add_actions(actions: Actions[argparse.ArgumentParser]) -> None:
    """Describe what `nacreous study` can do with a store."""
    parser = _add(actions, "backup", "copy a store to one file, while it is in use")
    _add_place(parser)
    parser.add_argument("-o", "--output", required=True, help="a .sqlite file, from either kind")
    parser.set_defaults(run=backup)
    parser = _add(actions, "restore", "make a store from a backup")
    parser.add_argument("backup", help="what `nacreous study backup` wrote")
    _add_place(
        parser, "a folder, made if its name has no ending and is not there; a new .sqlite file; or "
    )
    parser.set_defaults(run=restore)
    parser = _add(actions, "export", "write all answers as .csv, .parquet or a Psych-DS folder")
    _add_place(parser)
    parser.add_argument(
        "--table",
        choices=["answers", "people", "log"],
        default="answers",
        help="what a file holds: answers, people (everyone who has entered), or the log; a folder "
        "holds all (answers)",
    )
    parser.add_argument(
        "-o",
        "--output",
        help="- for CSV to standard output; a name without ending is a folder (TABLE.csv)",
    )
    parser.add_argument(
        "--bom", action="store_true", help="begin a .csv with a byte order mark, as Excel wants it"
    )
    parser.add_argument(
        "--identifying",
        action="store_true",
        help="with what may identify a person: the browser's full name, whatever a page sent "
        "beside what it measures, whom an invitation was for, parameters of the address, "
        "completion codes; of the log who and details",
    )
    _add_study(parser)
    parser.set_defaults(run=export)
    parser = _add(actions, "exclude", "mark a person's answers as not to be counted")
    _add_person(parser)
    parser.add_argument("--reason", required=True, help="kept with the answers")
    parser.set_defaults(run=exclude)
    parser = _add(actions, "readmit", "count an excluded person's answers after all")
    _add_person(parser)
    parser.set_defaults(run=readmit)
    parser = _add(actions, "erase", "take away all that leads from answers to a person")
    _add_person(parser)
    parser.set_defaults(run=erase)


def backup(args: argparse.Namespace) -> int:
    """Copy, and say how much."""
    from nacreous.study.store import backup

    say(f"{args.output}: written, {_told(backup(args.place, args.output))}")
    return 0


def restore(args: argparse.Namespace) -> int:
    """Check, copy, and say how much, and where."""
    from nacreous.study.store import restore
    from nacreous.study.store.engine import engine_of
    from nacreous.study.store.fault import place_of

    told = _told(restore(args.backup, args.place))
    say(f"{place_of(engine_of(args.place))}: restored, {told}")
    return 0


def export(args: argparse.Namespace) -> int:
    """Write, and say how many rows, and how many of them are marked."""
    from nacreous.commands import standard
    from nacreous.study.memory import hold_little
    from nacreous.study.store import Store, export

    hold_little()
    table = args.table
    name = f"{table}.csv" if args.output is None else args.output
    with (
        Store.open(args.place, make=False) as store,
        standard.writing(name, ".csv") as output,
    ):
        study = store.study(args.study)
        rows = export(store, study, output, table=table, bom=args.bom, identifying=args.identifying)
        found = store.progress(study)
    marked = (
        f"; among them, marked: {found.excluded} people excluded, {found.erased} erased, "
        f"{found.simulated} answers simulated"
    )
    told = {
        "answers": f"{rows} answers of {found.entered} people{marked}",
        "people": f"{rows} people{marked}",
        "log": f"{rows} lines",
    }
    say(f"{name}: written, {told[table]}", [name])
    return 0


def exclude(args: argparse.Namespace) -> int:
    """Mark a person's answers."""
    from nacreous.study.store import Store

    with Store.open(args.place, make=False) as store:
        session = person_of(store, store.study(args.study), args.number)
        changed = store.exclude(session.id, args.reason, who())
    told = "excluded; the answers stay, marked" if changed else f"was excluded so{_UNCHANGED}"
    say(f"person {session.number}: {told}")
    return 0


def readmit(args: argparse.Namespace) -> int:
    """Take an exclusion back."""
    from nacreous.study.store import Store

    with Store.open(args.place, make=False) as store:
        session = person_of(store, store.study(args.study), args.number)
        changed = store.readmit(session.id, who())
    told = "readmitted; the answers count again" if changed else f"is not excluded{_UNCHANGED}"
    say(f"person {session.number}: {told}")
    return 0


def erase(args: argparse.Namespace) -> int:
    """Take a person out of the store."""
    from nacreous.study.store import Store

    with Store.open(args.place, make=False) as store:
        session = person_of(store, store.study(args.study), args.number)
        changed = store.erase(session.id, who())
    told = "erased" if changed else "was erased before"
    say(f"person {session.number}: {told}; backups and exports made before still hold the data")
    return 0


def _add(
    actions: Actions[argparse.ArgumentParser], name: str, does: str
) -> argparse.ArgumentParser:
    return actions.add_parser(
        name,
        help=does,
        description=f"{does[0].upper()}{does[1:]}.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )


def _add_place(
    parser: argparse.ArgumentParser, kinds: str = "the study's folder, a file, or "
) -> None:
    """Where the store is, or nothing for what NACREOUS_STORE says."""
    parser.add_argument(
        "place", nargs="?", help=f"{kinds}postgresql://... (what NACREOUS_STORE says)"
    )


def _add_study(parser: argparse.ArgumentParser) -> None:
    """Which study of a store."""
    parser.add_argument("--study", help="the beginning of its hash, where a store has several")


def _add_person(parser: argparse.ArgumentParser) -> None:
    """Which person of which store."""
    parser.add_argument("place", help="the study's folder, a file, or postgresql://...")
    parser.add_argument("number", type=int, help="the participant's number, from 0")
    _add_study(parser)


def person_of(store: Store, study: str, number: int) -> Session:
    """The person of a number. Raises `InputError` where there is none."""
    from nacreous.problem import InputError

    people = store.sessions(study)
    for session in people:
        if session.number == number:
            return session
    allowed = f"0 to {len(people) - 1}" if people else "none, for nobody has entered"
    raise InputError(f"person is {number}; allowed: {allowed}")


def _told(copied: Copied) -> str:
    return f"{copied.studies} studies, {copied.sessions} people, {copied.answers} answers"


def who() -> str:
    """Whose hand it was, for the audit log."""
    from getpass import getuser

    try:
        return getuser()
    except (KeyError, OSError):  # a user without a name, as in containers
        return "command line"
