"""Flags of all people: who did not look, who tossed coins, whose page was not as it should be."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from datetime import datetime
from itertools import pairwise
from typing import Any

from nacreous.scaling.check.response import MOST_FAST
from nacreous.study.design.design import Design
from nacreous.study.store.record import Session
from nacreous.study.task.counting import is_data
from nacreous.study.task.flag import LONGEST_PAUSE_S, Flag
from nacreous.study.task.row import Row
from nacreous.study.task.tasks import TASKS

__all__ = ["flags_of_people"]

#: What our page notices with an answer. Another client may write what it likes.
_NOTICED = ("away", "early", "not_kept", "resized", "shrunk")
#: What everyone does now and then is a flag from more than this share of answers on: pressing
#: before a pair may be answered, as with answers that are too fast.
_OFTEN = {"early": MOST_FAST}


def flags_of_people(
    design: Design, rows: Sequence[Row], people: Sequence[Session]
) -> dict[int, list[Flag]]:
    """The flags of each of these people by number; rows: all answers of the study.

    Excluded people have theirs too; erased ones, of whom nothing is known, have none.
    """
    by_person: dict[int, list[Row]] = {}
    for row in rows:
        if row["number"] is not None:
            by_person.setdefault(row["number"], []).append(row)
    found: dict[int, list[Flag]] = {
        one.number: list(_screen(one.screen)) for one in people if one.erased_at is None
    }
    for number, own in by_person.items():
        found[number] += [*_catches(own, design), *_pauses(own), *_noticed(own)]
        found[number] += _unwaited(own, design.sitting.minimum_viewing_ms)
    data = [row for row in rows if row["number"] is not None and is_data(row)]
    for number, flags in TASKS[design.task].flags(design.asked, data).items():
        found[number] += flags
    return found


def _screen(screen: Mapping[str, Any] | None) -> Iterator[Flag]:
    """What the last check of the screen found."""
    for name in (screen or {}).get("flags", ()):
        yield Flag(f"screen-{name}", "")


def _catches(rows: Sequence[Row], design: Design) -> Iterator[Flag]:
    """Trials whose answer is known and was not given."""
    catches = [row for row in rows if row["kind"] == "catch"]
    missed = sum(TASKS[design.task].missed(design.asked, row) for row in catches)
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
