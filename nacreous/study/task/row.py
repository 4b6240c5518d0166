"""Rows of the store: an answer with what is known of who gave it, and equal answers counted."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypedDict

__all__ = ["Row", "Tallied", "person_of"]


class Row(TypedDict):
    """An answer as `Store.answers` gives it.

    Beside these keys stand the columns of its task, which that task alone reads.

    seq: order of arrival. trial: None of an erased person, as number is. groups, flags: JSON.
    excluded: why it does not count, or None. erased_as: an erased person's random name, or None.
    """

    seq: int
    study: str
    trial: int | None
    kind: str
    question: str
    response_ms: float | None
    shown_at: str | None
    answered_at: str | None
    received_at: str
    flags: str
    simulated: bool
    number: int | None
    language: str | None
    groups: str | None
    excluded: str | None
    erased_as: str | None


class Tallied(TypedDict):
    """How many answers are the same, as `Store.tally` gives it, beside the columns of a task."""

    question: str
    kind: str
    simulated: bool
    excluded: str | None
    count: int


def person_of(row: Mapping[str, Any]) -> str:
    """A label for who gave an answer: the number in the study, or an erased person's random name.

    >>> person_of({"number": 4, "erased_as": None})
    '4'
    """
    return str(row["erased_as"] if row["number"] is None else row["number"])
