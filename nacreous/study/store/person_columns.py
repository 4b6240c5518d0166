"""What is known of whoever gave an answer, as columns of an export: times, browser, screen checks.

What may identify a person is left out unless it is asked for: the browser's full name, texts that a
screen check holds beside its own words, and whom an invitation was for.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from typing import Any

import sqlalchemy as sa

from nacreous.study.store import check, invitations, people
from nacreous.study.store.record import Session
from nacreous.study.store.schema import sessions
from nacreous.study.task.column import Column

__all__ = ["IDENTIFYING", "PERSON", "PersonColumns"]

_TIME = "by the server's clock, UTC, ISO 8601; empty of an erased person"

#: In every export.
PERSON = (
    Column("entered_at", f"When the person entered, {_TIME}."),
    Column("consented_at", f"When the person consented, {_TIME}."),
    Column(
        "finished_at",
        f"When the person's last answer was stored, {_TIME}, and of who did not finish.",
    ),
    Column("browser", "The browser's family, without its version; empty where unknown."),
    Column(
        "screen_checks",
        "Every check of the screen, in order, as a JSON list of objects: at (UTC); flags (what "
        "fell short); window and screen (width_px, height_px in CSS pixels; device_pixel_ratio, "
        "colour_depth in bits); full_screen; card.px_per_mm; picture_width_mm; distance_mm, "
        "distance_by, distance_tries_mm; gamma; darkest_step (grey code, 0 to 255); gamut; hdr; "
        "vision (plates read right, of how many); simulated; and what other versions of the page "
        "measured.",
    ),
)
#: Only where what may identify a person is asked for.
IDENTIFYING = (
    Column("browser_name", "The browser's name and version, as the page told it."),
    Column("invitation", "What the experimenter called the invitation by which the person came."),
)

#: The keys of a screen check whose texts are words of ours, and not what somebody wrote.
_WORDS = frozenset(("flags", "distance_by", "gamut"))
_AGENT = "agent"


class PersonColumns:
    """The columns of one study, each person's values put into words once.

    identifying: with those that may identify a person.
    """

    def __init__(self, connection: sa.Connection, study: str, *, identifying: bool) -> None:
        import pyarrow as pa

        everyone = people.find(connection, sessions.c.study == study)
        living = [one for one in everyone if one.erased_at is None]
        self.columns = (*PERSON, *(IDENTIFYING if identifying else ()))
        values = _values(connection, study, living, identifying)
        self._place = {one.number: row for row, one in enumerate(living)}
        self._values = {one: pa.array(values[one.name], pa.string()) for one in self.columns}

    def of(self, numbers: Sequence[int | None]) -> dict[str, Any]:
        """Each column, by name, for answers of the people of these numbers, as Arrow dictionaries.

        None stands for an erased person, of whom nothing is told.
        """
        import pyarrow as pa

        rows = pa.array([None if n is None else self._place.get(n) for n in numbers], pa.int32())
        return {
            column.name: pa.DictionaryArray.from_arrays(rows, told)
            for column, told in self._values.items()
        }


def _values(
    connection: sa.Connection, study: str, living: Sequence[Session], identifying: bool
) -> dict[str, list[str | None]]:
    """By the column's name, a value a person."""
    checks = people.screen_checks(connection, study)
    invited = invitations.of_study(connection, study)
    labels = {one.number: one.label for one in invited if one.number is not None}
    agents = [str((one.screen or {}).get(_AGENT) or "") for one in living]
    return {
        "entered_at": [check.written("entered_at", one.started_at) for one in living],
        "consented_at": [_written(one.consented_at) for one in living],
        "finished_at": [_written(one.finished_at) for one in living],
        "browser": [_family(agent) for agent in agents],
        "screen_checks": [_told(checks.get(one.number, []), identifying) for one in living],
        "browser_name": [agent or None for agent in agents],
        "invitation": [labels.get(one.number) for one in living],
    }


def _written(at: Any) -> str | None:
    return None if at is None else check.written("at", at)


def _family(agent: str) -> str | None:
    """A browser's name up to its version.

    >>> _family("Mobile Safari 17.4"), _family("")
    ('Mobile Safari', None)
    """
    found = re.match(r"[A-Za-z][A-Za-z ]{0,30}", agent)
    return found[0].strip() if found else None


def _told(checks: Sequence[Mapping[str, Any]], identifying: bool) -> str | None:
    """Checks as JSON."""
    if not checks:
        return None
    told = [dict(one) if identifying else _without_texts(one) for one in checks]
    return json.dumps(told, sort_keys=True, separators=(",", ":"), ensure_ascii=False)


def _without_texts(value: Mapping[str, Any]) -> dict[str, Any]:
    """A check without what somebody may have written, at any depth."""
    kept = {}
    for key, one in value.items():
        if key == "at" or key in _WORDS:
            kept[key] = one
        elif isinstance(one, Mapping):
            kept[key] = _without_texts(one)
        elif isinstance(one, list):
            kept[key] = [part for part in one if isinstance(part, int | float)]
        elif not isinstance(one, str):
            kept[key] = one
    return kept
