"""What goes into a store and comes out: answers, receipts, sessions, events."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from functools import cached_property
from types import MappingProxyType
from typing import Any

from nacreous.study.store import check

CHOICES = ("left", "right", "tie")
KINDS = ("training", "pair", "repeat", "catch")
#: The kinds of trials that are data for a scale.
COUNTED = ("pair", "repeat")
NOTHING: Mapping[str, Any] = MappingProxyType({})


@dataclass(frozen=True)
class Answer:
    """One answer to one trial, checked.

    - `trial`: number in the session's plan, from 0; session and trial are the key of an answer
    - `question`: its id; `left`, `right`: labels of stimuli
    - `chosen`: "left", "right" or "tie"
    - `response_ms`: from showing to choosing, 0 to a day; None where unknown
    - `shown_at`, `answered_at`: by the participant's clock, with zone; believed for nothing
    - `flags`: anything noticed, as JSON
    - `simulated`: nobody gave it
    - `kind`: "training", "pair", "repeat" or "catch"

    Raises `InputError` for anything else.

    >>> Answer(0, "deeper", "a", "b", "middle")
    Traceback (most recent call last):
    nacreous.problem.InputError: chosen is 'middle'; allowed: left, right, tie
    """

    trial: int
    question: str
    left: str
    right: str
    chosen: str
    response_ms: float | None = None
    shown_at: datetime | None = None
    answered_at: datetime | None = None
    flags: Mapping[str, Any] = field(default_factory=lambda: NOTHING)
    simulated: bool = False
    kind: str = "pair"

    def __post_init__(self) -> None:
        """Check, by making what is stored."""
        _ = self.row

    @cached_property
    def row(self) -> dict[str, Any]:
        """As the columns of a table."""
        shown, answered = self.shown_at, self.answered_at
        return {
            "trial": check.whole("trial", self.trial),
            "question": check.text("question", self.question),
            "left": check.text("left", self.left),
            "right": check.text("right", self.right),
            "chosen": check.one_of("chosen", self.chosen, CHOICES),
            "response_ms": check.duration_ms("response_ms", self.response_ms),
            "shown_at": None if shown is None else check.written("shown_at", shown),
            "answered_at": None if answered is None else check.written("answered_at", answered),
            "flags": check.canonical("flags", self.flags),
            "simulated": bool(self.simulated),
            "kind": check.one_of("kind", self.kind, KINDS),
        }

    @cached_property
    def digest(self) -> str:
        """SHA-256 of the whole content: equal for the same answer given again."""
        content = json.dumps(self.row, sort_keys=True, separators=(",", ":"))
        return hashlib.sha256(content.encode()).hexdigest()


@dataclass(frozen=True)
class Receipt:
    """That an answer is on the disk. `again`: it already was, and was not stored twice."""

    session: str
    trial: int
    received_at: datetime
    again: bool


@dataclass(frozen=True)
class Session:
    """One participant in one study; `number` counts from 0 in order of entry and seeds the plan."""

    id: str
    study: str
    number: int
    language: str | None
    groups: Mapping[str, str]
    screen: Mapping[str, Any] | None
    consented_at: datetime | None
    started_at: datetime
    finished_at: datetime | None
    excluded_reason: str | None
    erased_at: datetime | None


@dataclass(frozen=True)
class Invitation:
    """A link that lets one person in; `number`: of the person who used it.

    label: whom or what it is for, as the experimenter calls it; "(erased)" with its person.
    """

    id: int
    label: str
    made_at: datetime
    made_by: str
    number: int | None
    revoked_at: datetime | None


@dataclass(frozen=True)
class Event:
    """A line of the audit log: when, who, what, about which study and session, and details."""

    at: datetime
    who: str
    what: str
    study: str | None
    session: str | None
    detail: Mapping[str, Any]
