"""Answers that do not count, and why each does not."""

from __future__ import annotations

from collections.abc import Iterable

from nacreous.study.task.counting import is_data
from nacreous.study.task.row import Row

__all__ = ["uncounted"]


def uncounted(rows: Iterable[Row], *, simulated: bool) -> str:
    """How many of these answers do not count for which reason, in words; the first one counts.

    simulated: those of simulated observers are wanted instead of people's.

    >>> row = {"kind": "pair", "excluded": "yes", "simulated": False}
    >>> uncounted([row, row, {**row, "kind": "training"}], simulated=False)
    '2 of excluded people, 1 of practice'
    """
    found: dict[str, int] = {}
    for row in rows:
        why = _why(row, simulated)
        if why is not None:
            found[why] = found.get(why, 0) + 1
    return ", ".join(f"{count} {why}" for why, count in found.items())


def _why(row: Row, simulated: bool) -> str | None:
    if not is_data(row):
        return "of practice" if row["kind"] == "training" else "of catch trials"
    if bool(row["simulated"]) != simulated:
        return "of people" if simulated else "of simulated observers"
    return None if row["excluded"] is None else "of excluded people"


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__
