"""Answers that do not count, and why each does not."""

from __future__ import annotations

from collections.abc import Iterable

from nacreous.scaling.data.uncounted import REASONS, counted_by_reason
from nacreous.study.task.counting import is_data
from nacreous.study.task.row import Row

__all__ = ["uncounted", "why_not"]


def uncounted(rows: Iterable[Row], *, simulated: bool) -> str:
    """How many of these answers do not count for which reason, in words.

    simulated: those of simulated observers are wanted instead of people's.

    >>> row = {"kind": "pair", "excluded": "yes", "simulated": False}
    >>> uncounted([row, row, {**row, "kind": "training"}], simulated=False)
    '1 of practice, 2 of excluded people'
    """
    found = counted_by_reason(why_not(row, simulated=simulated) for row in rows)
    return ", ".join(f"{count} {REASONS[reason]}" for reason, count in found.items())


def why_not(row: Row, *, simulated: bool) -> str | None:
    """Why an answer does not count, by a key of `REASONS`; None: it does.

    >>> why_not({"kind": "catch", "excluded": None, "simulated": False}, simulated=False)
    'catch'
    """
    if not is_data(row):
        return "practice" if row["kind"] == "training" else "catch"
    if bool(row["simulated"]) != simulated:
        return "people" if simulated else "simulated"
    return None if row["excluded"] is None else "excluded"


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__
