"""What goes into a store and comes out: answers, receipts, sessions, events."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from functools import cached_property
from typing import Any

from nacreous.number import truth_of
from nacreous.problem import InputError
from nacreous.study.store import check
from nacreous.study.store.schema import LONGEST_GIVEN
from nacreous.study.task.counting import KINDS
from nacreous.study.task.response import Response

#: The places of a trial for which there are columns.
PLACES = ("left", "right")


@dataclass(frozen=True)
class Answer:
    """One answer to one trial, checked as far as it is stored; what was answered is not looked at.

    - `trial`: number in the session's plan, from 0; session and trial are the key of an answer
    - `question`: its id
    - `shown`: the label of the stimulus at each place of the trial; of a pair left and right
    - `response`: text that fits its column, which the task of the trial has checked
    - `kind`: "training", "pair", "repeat" or "catch"

    Raises `InputError` for anything else.

    >>> Answer(0, "deeper", {"left": "a", "middle": "b"}, Response("left"))
    Traceback (most recent call last):
    nacreous.problem.InputError: shown has left, middle; allowed: left, right
    """

    trial: int
    question: str
    shown: Mapping[str, str]
    response: Response
    kind: str = "pair"

    def __post_init__(self) -> None:
        """Check, by making what is stored."""
        _ = self.row

    @cached_property
    def row(self) -> dict[str, Any]:
        """As the columns of a table."""
        if set(self.shown) != set(PLACES):
            raise InputError(f"shown has {', '.join(self.shown)}; allowed: {', '.join(PLACES)}")
        response = self.response
        shown, answered = response.shown_at, response.answered_at
        return {
            "trial": check.whole("trial", self.trial),
            "question": check.text("question", self.question),
            **{place: check.text(place, label) for place, label in self.shown.items()},
            "chosen": check.text("chosen", response.given, LONGEST_GIVEN),
            "response_ms": check.duration_ms("response_ms", response.response_ms),
            "shown_at": None if shown is None else check.written("shown_at", shown),
            "answered_at": None if answered is None else check.written("answered_at", answered),
            "flags": check.canonical("flags", response.flags),
            "simulated": truth_of("simulated", response.simulated),
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
    """One participant in one study; `number` counts from 0 in order of entry.

    - `slot`: what the plan follows from; two people may have the same one, where one dropped out
    - `parameters`: of the address by which the person came, as the study declares them
    - `completion_code`: of the person's own, to be told at the end

    Of an erased person these are empty.
    """

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
    slot: int | None
    parameters: Mapping[str, str]
    completion_code: str | None


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
