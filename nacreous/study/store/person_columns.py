"""What is known of whoever gave an answer, as columns of an export: times, browser, screen checks.

What may identify a person is left out unless it is asked for: the browser's full name, texts that a
screen check holds beside its own words, and whom an invitation was for.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from nacreous.study.store import check
from nacreous.study.task.column import Column

if TYPE_CHECKING:
    from nacreous.study.store.store import Store

__all__ = ["IDENTIFYING", "PERSON", "person_columns"]

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


def person_columns(
    store: Store, study: str, numbers: Sequence[int | None], *, identifying: bool
) -> dict[Column, Any]:
    """Each column for answers of the people of these numbers, as dictionary-encoded Arrow text.

    None stands for an erased person, of whom nothing is told.
    """
    import pyarrow as pa

    people = [one for one in store.sessions(study) if one.erased_at is None]
    checks = store.screen_checks(study)
    labels = {one.number: one.label for one in store.invitations(study) if one.number is not None}
    place = {one.number: row for row, one in enumerate(people)}
    agents = [str((one.screen or {}).get(_AGENT) or "") for one in people]
    values: dict[str, list[str | None]] = {
        "entered_at": [check.written("entered_at", one.started_at) for one in people],
        "consented_at": [_written(one.consented_at) for one in people],
        "finished_at": [_written(one.finished_at) for one in people],
        "browser": [_family(agent) for agent in agents],
        "screen_checks": [_told(checks.get(one.number, []), identifying) for one in people],
        "browser_name": [agent or None for agent in agents],
        "invitation": [labels.get(one.number) for one in people],
    }
    rows = pa.array([None if n is None else place.get(n) for n in numbers], pa.int32())
    return {
        column: pa.DictionaryArray.from_arrays(rows, pa.array(values[column.name], pa.string()))
        for column in (*PERSON, *(IDENTIFYING if identifying else ()))
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
