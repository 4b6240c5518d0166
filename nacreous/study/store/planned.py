"""Whether the answers of a backup are answers to their persons' plans, and the plans the study's.

Person by person, so that millions of answers take no memory.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

import sqlalchemy as sa

from nacreous.problem import InputError
from nacreous.scaling.data.fault import quoted
from nacreous.scaling.data.label import label_of
from nacreous.study.design.design import Design
from nacreous.study.store.engine import in_parts
from nacreous.study.store.record import PLACES
from nacreous.study.store.schema import answers, sessions
from nacreous.study.task.counting import KINDS

__all__ = ["check_plans"]

#: What of a trial its answer repeats, as both tables call it.
_REPEATED = ("question", *PLACES, "kind")
_MORE = ("number", "block", "break_before")
#: Plans read at a time; one is some 10 kB.
_PLANS = 100


def check_plans(connection: sa.Connection, place: str, study: str, design: Design) -> None:
    """Refuse the first trial or answer that the study or the person's plan has not.

    A person without a plan is passed over: stores of the first version kept none. Raises
    `InputError`.
    """
    allowed = {
        "question": frozenset(design.asked.questions),
        **dict.fromkeys(PLACES, frozenset(map(label_of, design.labels))),
        "kind": frozenset(KINDS),
    }
    known: set[tuple[str, ...]] = set()
    planned = sa.select(sessions.c.id, sessions.c.number, sessions.c.plan).where(
        sessions.c.study == study, sessions.c.plan.is_not(None)
    )
    for part in in_parts(connection, planned, _PLANS):
        for session, number, text in part:
            plan = json.loads(text)
            for at, trial in enumerate(plan):
                if (said := _fault(trial, at, allowed, known)) is not None:
                    raise InputError(
                        f"{place}: sessions, plan of person {number}, trial {at}{said}"
                    )
            _check_answers(connection, place, study, session, number, plan)


def _fault(
    trial: Mapping[str, Any],
    at: int,
    allowed: Mapping[str, frozenset[str]],
    known: set[tuple[str, ...]],
) -> str | None:
    """What is wrong with a trial of a plan; known: what was found good before."""
    missing = [name for name in (*_REPEATED, *_MORE) if name not in trial]
    if missing:
        return f": has no {missing[0]}; wanted: {', '.join((*_REPEATED, *_MORE))}"
    if trial["number"] != at:
        return f": number is {trial['number']}; allowed: {at}, its place"
    repeated = tuple(trial[name] for name in _REPEATED)
    for name, value in zip(_REPEATED, repeated, strict=True):
        if not isinstance(value, str):
            return f": {name} is {quoted(str(value))}; allowed: text"
    if repeated in known:
        return None
    for name, value in zip(_REPEATED, repeated, strict=True):
        if (label_of(value) if name in PLACES else value) not in allowed[name]:
            what = "stimulus of the study" if name in PLACES else f"{name} of the study"
            return f": {name} is {quoted(value)}; allowed: a {what}"
    known.add(repeated)
    return None


_OF_PERSON = sa.select(*(answers.c[name] for name in ("seq", "study", "trial", *_REPEATED))).where(
    answers.c.session == sa.bindparam("of")
)


def _check_answers(
    connection: sa.Connection,
    place: str,
    study: str,
    session: str,
    number: int,
    plan: Sequence[Mapping[str, Any]],
) -> None:
    """Refuse the first answer of a person that answers no trial of the plan."""
    for seq, of, at, *repeated in connection.execute(_OF_PERSON, {"of": session}):
        where = f"{place}: answers, row {seq}: "
        if of != study:
            raise InputError(f"{where}study is {of[:12]}; allowed: {study[:12]}, as of its session")
        if at is None or at >= len(plan):
            last = f"0 to {len(plan) - 1}" if plan else "none"
            raise InputError(
                f"{where}trial is {'empty' if at is None else at}; allowed: {last}, for the plan "
                f"of person {number} has {len(plan)} trials"
            )
        for name, value in zip(_REPEATED, repeated, strict=True):
            wanted = plan[at][name]
            # Labels as they were compared by the version that wrote them.
            if value != wanted and (name not in PLACES or label_of(value) != label_of(wanted)):
                raise InputError(
                    f"{where}{name} is {quoted(value)}; allowed: {quoted(wanted)}, as in trial "
                    f"{at} of person {number}'s plan"
                )
