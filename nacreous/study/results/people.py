"""Flags of all people: who did not look, who tossed coins, whose page was not as it should be."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from datetime import datetime
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from nacreous.scaling.check.response import MOST_FAST
from nacreous.study.task.counting import is_data
from nacreous.study.task.flag import LONGEST_PAUSE_S, Flag
from nacreous.study.task.row import Row

if TYPE_CHECKING:
    from nacreous.study.running import Running

__all__ = ["people_flags"]

#: What our page notices with an answer. Another client may write what it likes.
_NOTICED = ("away", "early", "not_kept", "resized", "shrunk")
#: What everyone does now and then is a flag from more than this share of answers on: pressing
#: before a pair may be answered, as with answers that are too fast.
_OFTEN = {"early": MOST_FAST}


def people_flags(running: Running) -> dict[int, list[Flag]]:
    """The flags of every person who has answered or checked the screen, by number.

    Excluded people have theirs too; erased ones, of whom nothing is known, have none.
    """
    rows = [row for row in running.store.answers(running.study) if row["number"] is not None]
    by_person: dict[int, list[Row]] = {}
    for row in rows:
        if row["number"] is not None:
            by_person.setdefault(row["number"], []).append(row)
    found: dict[int, list[Flag]] = {
        session.number: list(_screen(session.screen))
        for session in running.store.sessions(running.study)
        if session.erased_at is None
    }
    design = running.frozen.design
    for number, own in by_person.items():
        found[number] += [*_catches(own, running), *_pauses(own), *_noticed(own)]
        found[number] += _unwaited(own, design.sitting.minimum_viewing_ms)
    data = [row for row in rows if is_data(row)]
    for number, flags in running.task.flags(design.asked, data).items():
        found[number] += flags
    return found


def _screen(screen: Mapping[str, Any] | None) -> Iterator[Flag]:
    """What the last check of the screen found."""
    for name in (screen or {}).get("flags", ()):
        yield Flag(f"screen-{name}", "")


def _catches(rows: Sequence[Row], running: Running) -> Iterator[Flag]:
    """Trials whose answer is known and was not given."""
    catches = [row for row in rows if row["kind"] == "catch"]
    asked = running.frozen.design.asked
    missed = sum(running.task.missed(asked, row) for row in catches)
    if missed:
        yield Flag("catches", f"{missed}/{len(catches)}")


def _pauses(rows: Sequence[Row]) -> Iterator[Flag]:
    """The longest time between two answers, by the server's clock."""
    times = [datetime.fromisoformat(row["received_at"]) for row in rows]
    gaps_s = [(after - before).total_seconds() for before, after in pairwise(times)]
    if gaps_s and max(gaps_s) >= LONGEST_PAUSE_S:
        yield Flag("pause", f"{max(gaps_s):.0f} s")


def _noticed(rows: Sequence[Row]) -> Iterator[Flag]:
    """What the participant's page noticed while answers were given."""
    counts = Counter(
        name
        for row in rows
        if row["flags"] != "{}"  # as nearly all are
        for name, value in json.loads(row["flags"]).items()
        if value and name in _NOTICED
    )
    for name, count in sorted(counts.items()):
        if name in _OFTEN and count <= _OFTEN[name] * len(rows):
            continue
        yield Flag(f"answer-{name}", f"{count}/{len(rows)}")


def _unwaited(rows: Sequence[Row], minimum_ms: float) -> Iterator[Flag]:
    """Answers by which a trial was there for a shorter time than our page lets anyone answer."""
    sooner = sum((row["response_ms"] or minimum_ms) < minimum_ms for row in rows)
    if sooner > MOST_FAST * len(rows):
        yield Flag("unwaited", f"{sooner}/{len(rows)}")
