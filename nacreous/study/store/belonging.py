"""Whether what a backup holds belongs to its studies: questions, stimuli, responses, groups.

Each column may be right by itself (`contents.py`) and yet name what no study has.
"""

from __future__ import annotations

import json
from collections.abc import Collection, Iterator, Mapping

import sqlalchemy as sa

from nacreous.problem import InputError
from nacreous.scaling.data.fault import quoted
from nacreous.scaling.data.label import label_of
from nacreous.study.design.design import Design
from nacreous.study.design.manifest import design_of
from nacreous.study.store.planned import check_plans
from nacreous.study.store.schema import answers, sessions, studies
from nacreous.study.task.tasks import TASKS

__all__ = ["check_belonging"]


def check_belonging(connection: sa.Connection, place: str) -> None:
    """Refuse the first answer or person of what their study has not, by table and row.

    A study without a design, of which nothing is known, is passed over. Raises `InputError`.
    """
    found = connection.execute(sa.select(studies.c.hash, studies.c.manifest, studies.c.next_number))
    there = {column["name"] for column in sa.inspect(connection).get_columns("sessions")}
    for study, text, next_number in found.all():
        _check_number(connection, place, study, next_number)
        manifest = json.loads(text)
        made = manifest.get("design")
        if isinstance(made, Mapping) and made.get("questions") and manifest.get("stimuli"):
            design = design_of(manifest, f"{place}: studies, manifest of {study[:12]}")
            _check_answers(connection, place, study, design)
            _check_people(connection, place, study, design, there)
            if "plan" in there:
                check_plans(connection, place, study, design)
    _check_owners(connection, place)


def _check_answers(connection: sa.Connection, place: str, study: str, design: Design) -> None:
    """Questions, stimuli, and what may be answered: each different one is looked at once."""
    task, asked = TASKS[design.task], design.asked
    labels = {label_of(label) for label in design.labels}
    known = {"question": set(asked.questions), **dict.fromkeys(task.places, labels)}
    for name, allowed in known.items():
        for value, row in _different(connection, study, name):
            if (value if name == "question" else label_of(value)) not in allowed:
                what = "question" if name == "question" else "stimulus"
                raise _refused(place, "answers", row, f"{name} is {quoted(value)}", what)
    for value, row in _different(connection, study, "chosen"):
        try:
            task.check(asked, value)
        except InputError as problem:
            raise InputError(f"{place}: answers, row {row}: {problem}") from None


def _different(connection: sa.Connection, study: str, name: str) -> Iterator[tuple[str, int]]:
    """The different values of a column of answers, each with its first row."""
    column = answers.c[name]
    first = sa.select(column, sa.func.min(answers.c.seq)).where(answers.c.study == study)
    yield from connection.execute(first.group_by(column))


def _check_people(
    connection: sa.Connection, place: str, study: str, design: Design, there: Collection[str]
) -> None:
    """Groups, languages and parameters of the address; there: columns of the backup's version."""
    levels = {one.name: set(one.values) for one in design.groups}
    names = ("number", "groups", "language", *({"parameters"} & set(there)))
    query = sa.select(*(sessions.c[name] for name in names)).where(sessions.c.study == study)
    for row in connection.execute(query).mappings():
        where = f"of person {row['number']}"
        for name, level in json.loads(row["groups"] or "{}").items():
            if level not in levels.get(name, ()):
                said = f"group {quoted(name)} is {quoted(level)}"
                raise _refused(place, "sessions", where, said, "group's value")
        language = row["language"]
        if language is not None and language not in design.languages:
            said = f"language is {quoted(language)}"
            raise _refused(place, "sessions", where, said, "language")
        for name in json.loads(row.get("parameters") or "{}"):
            if name not in design.entry.parameters:
                said = f"parameters name {quoted(name)}"
                raise _refused(place, "sessions", where, said, "parameter")


def _check_owners(connection: sa.Connection, place: str) -> None:
    """An answer is one trial of a person, or of an erased one whom a random name stands for."""
    has_session, has_trial, has_name = (
        answers.c[name].is_not(None) for name in ("session", "trial", "erased_as")
    )
    odd = sa.or_(has_session != has_trial, has_session == has_name)
    row = connection.execute(sa.select(answers.c.seq).where(odd).limit(1)).scalar_one_or_none()
    if row is not None:
        raise InputError(
            f"{place}: answers, row {row}: session, trial and erased_as are not of one person; "
            "allowed: session and trial, or erased_as alone"
        )


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
