"""What is known of whoever gave an answer, as columns of an export: times, browser, screen checks.

What may identify a person is left out unless it is asked for: the browser's full name, what a
screen check holds beside our own keys, numbers and words, whom an invitation was for, the address's
parameters, and a completion code of the person's own.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from nacreous.study.store import check
from nacreous.study.store.disclosure import browser_family, plain_check
from nacreous.study.store.record import Session
from nacreous.study.task.column import Column
from nacreous.study.task.flag import Flag

__all__ = ["IDENTIFYING", "PERSON", "Known", "PersonColumns"]

_TIME = "by the server's clock, UTC, ISO 8601; empty of an erased person"

#: In every export.
PERSON = (
    Column("entered_at", f"When the person entered, {_TIME}."),
    Column("consented_at", f"When the person consented, {_TIME}."),
    Column(
        "finished_at",
        f"When the person's last answer was stored, {_TIME}, and of who did not finish.",
    ),
    Column(
        "person_flags",
        "What is odd about the person's answers, as the laboratory's page shows it: a JSON list of "
        "flag (catches, repeats, left, right, circles, fast, unwaited, pause, answer-NAME for what "
        "the page noticed, screen-NAME for what the check of the screen found) and detail (2/3 is "
        "two of three). It excludes nobody. Empty: nothing, an erased person, or a study of "
        "another version.",
    ),
    Column(
        "browser",
        "The browser's family, without its version; empty where it is none that pages tell apart.",
    ),
    Column(
        "screen_checks",
        "Every check of the screen, in order, as a JSON list of objects: at (UTC); flags (what "
        "fell short); window and screen (width_px, height_px in CSS pixels; device_pixel_ratio, "
        "colour_depth in bits); full_screen; card.px_per_mm; picture_width_mm; distance_mm, "
        "distance_by, distance_tries_mm; gamma; darkest_step (grey code, 0 to 255); gamut; hdr; "
        "vision (plates read right, of how many); simulated. Only with what may identify a person: "
        "whatever else a page sent, in other keys, texts or numbers beyond 1000000.",
    ),
)
#: Only where what may identify a person is asked for.
IDENTIFYING = (
    Column("browser_name", "The browser's name and version, as the page told it."),
    Column("invitation", "What the experimenter called the invitation by which the person came."),
    Column(
        "parameters",
        "Of the address by which the person came, those that the study declares, as JSON; they may "
        "identify somebody, as a recruiting platform's id does.",
    ),
    Column("completion_code", "The code of the person's own, told to who has finished."),
)

_AGENT = "agent"


@dataclass(frozen=True)
class Known:
    """What a store knows of a study's people; checks, labels of invitations and flags by number."""

    people: Sequence[Session]
    checks: Mapping[int, Sequence[Mapping[str, Any]]]
    labels: Mapping[int, str]
    flags: Mapping[int, Sequence[Flag]]


class PersonColumns:
    """The columns of rows about people, each person's values put into words once."""

    def __init__(self, known: Known, *, identifying: bool) -> None:
        import pyarrow as pa

        people = [one for one in known.people if one.erased_at is None]
        values = _values(known, people, identifying)
        self.columns = (*PERSON, *(IDENTIFYING if identifying else ()))
        self._place = {one.number: row for row, one in enumerate(people)}
        self._told = {
            column.name: pa.array(values[column.name], pa.string()) for column in self.columns
        }

    def of(self, numbers: Sequence[int | None]) -> dict[str, Any]:
        """Each column, by name, for the people of these numbers, as dictionary-encoded Arrow text.

        None stands for an erased person, of whom nothing is told.
        """
        import pyarrow as pa

        rows = pa.array([None if n is None else self._place.get(n) for n in numbers], pa.int32())
        return {
            name: pa.DictionaryArray.from_arrays(rows, told) for name, told in self._told.items()
        }


def _values(
    known: Known, people: Sequence[Session], identifying: bool
) -> dict[str, list[str | None]]:
    """By the column's name, a value a person."""
    agents = [str((one.screen or {}).get(_AGENT) or "") for one in people]
    return {
        "entered_at": [check.written("entered_at", one.started_at) for one in people],
        "consented_at": [_written(one.consented_at) for one in people],
        "finished_at": [_written(one.finished_at) for one in people],
        "browser": [browser_family(agent) for agent in agents],
        "person_flags": [_marks(known.flags.get(one.number, ())) for one in people],
        "screen_checks": [_told(known.checks.get(one.number, []), identifying) for one in people],
        "browser_name": [agent or None for agent in agents],
        "invitation": [known.labels.get(one.number) for one in people],
        "parameters": [_json(one.parameters) if one.parameters else None for one in people],
        "completion_code": [one.completion_code for one in people],
    }


def _written(at: Any) -> str | None:
    return None if at is None else check.written("at", at)


def _told(checks: Sequence[Mapping[str, Any]], identifying: bool) -> str | None:
    """Checks as JSON."""
    if not checks:
        return None
    return _json([dict(one) if identifying else plain_check(one) for one in checks])


def _marks(flags: Sequence[Flag]) -> str | None:
    """Flags as JSON."""
    return _json([{"flag": one.kind, "detail": one.detail} for one in flags]) if flags else None


def _json(value: Any) -> str:
    return json.dumps(value, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
