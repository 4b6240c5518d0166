"""Whether what a backup holds belongs to its studies: their questions, stimuli, groups and numbers.

Each column may be right by itself (`contents.py`) and yet name what no study has.
"""

from __future__ import annotations

import json
from collections.abc import Collection, Mapping
from typing import Any

import sqlalchemy as sa

from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.scaling.data.label import label_of
from nacreous.study.store.schema import answers, sessions, studies
from nacreous.study.task.tasks import columns_of_tasks

__all__ = ["check_belonging"]


def check_belonging(connection: sa.Connection, place: str) -> None:
    """Refuse the first answer or person of what their study has not, by table and row.

    A study without a design, of which nothing is known, is passed over. Raises `InputError`.
    """
    found = connection.execute(sa.select(studies.c.hash, studies.c.manifest, studies.c.next_number))
    for study, text, next_number in found.all():
        _check_number(connection, place, study, next_number)
        manifest = json.loads(text)
        design = manifest.get("design")
        if isinstance(design, Mapping) and design.get("questions") and manifest.get("stimuli"):
            _check_answers(connection, place, study, _known(manifest, design))
            _check_groups(connection, place, study, design)


def _known(manifest: Mapping[str, Any], design: Mapping[str, Any]) -> dict[str, set[str]]:
    """What each column of an answer may name: questions, and stimuli where it has no words."""
    labels = {label_of(one["label"]) for one in manifest.get("stimuli", ())}
    known = {one.name: labels for one in columns_of_tasks() if not one.values}
    return {"question": {one["id"] for one in design.get("questions", ())}, **known}


def _check_answers(
    connection: sa.Connection, place: str, study: str, known: Mapping[str, Collection[str]]
) -> None:
    for name, allowed in known.items():
        column = answers.c[name]
        first = sa.select(column, sa.func.min(answers.c.seq)).where(answers.c.study == study)
        for value, row in connection.execute(first.group_by(column)):
            if label_of(value) not in allowed:
                what = "question" if name == "question" else "stimulus"
                raise _refused(place, "answers", row, f"{name} is {_shown(value)}", what)


def _check_groups(
    connection: sa.Connection, place: str, study: str, design: Mapping[str, Any]
) -> None:
    levels = {one["name"]: set(one["values"]) for one in design.get("groups", ())}
    given = sa.select(sessions.c.groups, sessions.c.number).where(sessions.c.study == study)
    for text, number in connection.execute(given):
        for name, level in json.loads(text or "{}").items():
            if level not in levels.get(name, ()):
                said = f"group {_shown(name)} is {_shown(level)}"
                raise _refused(place, "sessions", f"of person {number}", said, "group's value")


def _check_number(connection: sa.Connection, place: str, study: str, next_number: int) -> None:
    """The next person's number must be new, or nobody could enter."""
    last = connection.execute(
        sa.select(sa.func.max(sessions.c.number)).where(sessions.c.study == study)
    ).scalar_one()
    if last is not None and next_number <= last:
        raise InputError(
            f"{place}: studies: next_number is {next_number}; allowed: {last + 1} or more, for "
            f"there is a person {last}"
        )


def _refused(place: str, table: str, row: object, said: str, what: str) -> InputError:
    where = f"row {row}" if isinstance(row, int) else row
    return InputError(f"{place}: {table}, {where}: {said}; allowed: a {what} of the study")


def _shown(text: str) -> str:
    made = printable(text)
    return f'"{made}"' if len(made) <= 60 else f'"{made[:57]}..."'
