"""What a participant answered to one trial: the same object from the server to the store."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from types import MappingProxyType
from typing import Any, TypeAlias

from pydantic import JsonValue

__all__ = ["Given", "Response"]

#: What was answered, plain JSON; what it may be, and what it means, its task alone knows.
Given: TypeAlias = JsonValue

_NOTHING: Mapping[str, Any] = MappingProxyType({})


@dataclass(frozen=True)
class Response:
    """An answer, without the trial that it answers.

    - `given`: what was answered; of a pair "left", "right" or "tie"
    - `response_ms`: from showing to answering, 0 to a day; None where unknown
    - `shown_at`, `answered_at`: by the participant's clock, with zone; believed for nothing
    - `flags`: anything noticed, as JSON
    - `simulated`: nobody gave it; True or False, NumPy's too, as its numbers do

    Nothing is checked here: `given` is checked by the task, the rest by the store.

    >>> Response("left", response_ms=1840.5).given
    'left'
    """

    given: Given
    response_ms: float | None = None
    shown_at: datetime | None = None
    answered_at: datetime | None = None
    flags: Mapping[str, Any] = field(default_factory=lambda: _NOTHING)
    simulated: bool = False
