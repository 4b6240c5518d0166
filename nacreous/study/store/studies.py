"""Studies in a store: the frozen design, and whether people may enter."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import Any

import sqlalchemy as sa
from sqlalchemy.dialects import postgresql, sqlite

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.study.design.manifest import hash_of as sealed_hash
from nacreous.study.store import check, journal
from nacreous.study.store.refusal import NotAllowed
from nacreous.study.store.schema import studies

STATES = ("open", "paused", "closed")
REGISTRATIONS = ("open", "invited")


def hash_of(manifest: Mapping[str, Any]) -> str:
    """The hash of a frozen study, looked at but not computed again.

    That is `study_hash`, of stimuli and all; `design_hash` where a manifest has no other.
    """
    given = manifest.get("study_hash", manifest.get("design_hash"))
    if not isinstance(given, str) or not re.fullmatch("[0-9a-f]{64}", given):
        raise InputError("manifest: study_hash is missing or no SHA-256; wanted: a frozen study")
    return given


def is_intact(study: str, manifest: Mapping[str, Any]) -> bool:
    """Whether a manifest is the one of a hash: computed again of what `nacreous study new` made.

    A manifest without `study_hash`, which programs may keep, is known by its name alone.
    """
    if not isinstance(manifest, Mapping) or hash_of(manifest) != study:
        return False
    sealed = {key: value for key, value in manifest.items() if key != "study_hash"}
    return "study_hash" not in manifest or sealed_hash(sealed) == study


def add(connection: sa.Connection, at: str, study: str, manifest: str) -> None:
    """Keep a design; nothing happens where it is there already."""
    insert = sqlite.insert if connection.dialect.name == "sqlite" else postgresql.insert
    row = {
        "hash": study,
        "manifest": manifest,
        "state": "open",
        "next_number": 0,
        "added_at": at,
    }
    added = connection.execute(
        insert(studies).values(row).on_conflict_do_nothing().returning(studies.c.hash)
    ).scalar_one_or_none()
    if added is not None:
        journal.note(connection, at, "store", "study added", study, None)
        return
    kept = connection.execute(
        sa.select(studies.c.manifest).where(studies.c.hash == study)
    ).scalar_one()
    if kept != manifest:
        raise InputError(
            f"study {study[:12]} is kept with another manifest; "
            "wanted: the same stimuli and versions for the same design"
        )


def manifest_of(connection: sa.Connection, study: str) -> dict[str, Any]:
    """The manifest as it was given."""
    text = connection.execute(
        sa.select(studies.c.manifest).where(studies.c.hash == study)
    ).scalar_one_or_none()
    if text is None:
        raise unknown(study)
    made: dict[str, Any] = json.loads(text)
    return made


def states(connection: sa.Connection) -> dict[str, str]:
    """Every study's hash and state, in the order in which they were added."""
    query = sa.select(studies.c.hash, studies.c.state).order_by(studies.c.added_at, studies.c.hash)
    return {row.hash: row.state for row in connection.execute(query)}


def set_state(connection: sa.Connection, at: str, study: str, state: str, who: str) -> bool:
    """Open, pause or close; False, and no line in the log, where it is so already."""
    check.one_of("state", state, STATES)
    mine = studies.c.hash == study
    before = connection.execute(
        sa.select(studies.c.state).where(mine).with_for_update()
    ).scalar_one_or_none()
    if before is None:
        raise unknown(study)
    if before != state:
        connection.execute(sa.update(studies).where(mine).values(state=state))
        journal.note(connection, at, who, f"study {state}", study, None)
    return bool(before != state)


def registration(connection: sa.Connection, study: str, *, hold: bool = False) -> str:
    """Who may enter: anybody ("open"), or who is "invited"; `hold`: until the transaction ends."""
    query = sa.select(studies.c.registration).where(studies.c.hash == study)
    if hold:
        query = query.with_for_update()
    kept = connection.execute(query).scalar_one_or_none()
    if kept is None:
        raise unknown(study)
    return str(kept)


def set_registration(connection: sa.Connection, at: str, study: str, value: str, who: str) -> None:
    """Say who may enter."""
    check.one_of("registration", value, REGISTRATIONS)
    if registration(connection, study, hold=True) != value:
        mine = studies.c.hash == study
        connection.execute(sa.update(studies).where(mine).values(registration=value))
        journal.note(connection, at, who, f"registration {value}", study, None)


def take_number(connection: sa.Connection, study: str) -> int:
    """The next participant's number, which nobody else gets."""
    taken = connection.execute(
        sa.update(studies)
        .where(studies.c.hash == study, studies.c.state == "open")
        .values(next_number=studies.c.next_number + 1)
        .returning(studies.c.next_number)
    ).scalar_one_or_none()
    if taken is not None:
        return int(taken) - 1
    state = states(connection).get(study)
    if state is None:
        raise unknown(study)
    raise NotAllowed(f"study {study[:12]} is {state}; wanted: open, for somebody to enter")


def unknown(study: object) -> InputError:
    """For a study that is not kept here."""
    shown = study[:12] if isinstance(study, str) else study
    return InputError(f"study {said(shown)} is not in this store; wanted: add_study first")
