"""Nothing is collected that cannot be had: every column of the store is in an export, or named."""

import json
from pathlib import Path

import polars as pl
import pytest

from nacreous.server.service import Service
from nacreous.study.results import people_flags
from nacreous.study.store import Response, Store, export
from nacreous.study.store.codebook import COLUMNS, LOG, LOG_IDENTIFYING, PEOPLE, PLAN
from nacreous.study.store.person_columns import IDENTIFYING, PERSON
from nacreous.study.store.schema import metadata
from nacreous.study.store.tokens import draw
from tests.support.pairs import pair_answer

STUDY = "5e" * 32

#: Where each column of the store is exported: its table and its column there.
EXPORTED = {
    "sessions.number": "people.person",
    "sessions.language": "people.language",
    "sessions.groups": "a column a group",
    "sessions.consented_at": "people.consented_at",
    "sessions.started_at": "people.entered_at",
    "sessions.finished_at": "people.finished_at",
    "sessions.excluded_reason": "people.excluded",
    "sessions.erased_at": "people.erased",
    "sessions.plan": "people.plan",
    "sessions.slot": "people.slot",
    "sessions.parameters": "people.parameters",
    "sessions.completion_code": "people.completion_code",
    "screens.session": "people.person",
    "screens.seq": "people.screen_checks",
    "screens.at": "people.screen_checks",
    "screens.content": "people.screen_checks",
    "answers.seq": "answers.sequence",
    "answers.session": "answers.person",
    "answers.erased_as": "answers.person",
    "answers.excluded_reason": "answers.excluded",
    **{
        f"answers.{name}": f"answers.{name}"
        for name in (
            *("trial", "kind", "question", "left", "right", "chosen", "response_ms", "shown_at"),
            *("answered_at", "received_at", "flags", "simulated"),
        )
    },
    "invitations.label": "people.invitation",
    "invitations.session": "people.invitation",
    "audit.at": "log.at",
    "audit.who": "log.who",
    "audit.what": "log.what",
    "audit.detail": "log.detail",
    "audit.session": "log.person",
}
#: What is not exported, and why.
LEFT_OUT = {
    "studies": "the study's own file, which its folder holds, and whether people may enter",
    "accounts": "experimenters' names and passwords",
    "logins": "experimenters' logins",
    "sessions.id": "lets nobody be found; the number stands for it",
    "sessions.study": "an export is of one study",
    "sessions.token_hash": "a secret of the person's",
    "answers.study": "an export is of one study",
    "answers.digest": "follows from the answer",
    "audit.seq": "the order of rows",
    "audit.study": "an export is of one study",
    "invitations.seq": "of the link alone, and on the laboratory's page",
    "invitations.study": "an export is of one study",
    "invitations.token_hash": "a secret of the person's",
    "invitations.made_at": "of the link alone, and on the laboratory's page",
    "invitations.made_by": "of the link alone, and on the laboratory's page",
    "invitations.revoked_at": "of the link alone, and on the laboratory's page",
}


def test_every_column_of_the_store_is_exported_or_named_with_the_reason() -> None:
    columns = {
        f"{table.name}.{column.name}" for table in metadata.sorted_tables for column in table.c
    }
    named = {name for name in columns if name.partition(".")[0] in LEFT_OUT}
    assert columns - named == set(EXPORTED) | {name for name in LEFT_OUT if "." in name}
    assert not set(EXPORTED) & set(LEFT_OUT)
    person = [*PERSON, *IDENTIFYING]
    there = {
        f"{table}.{column.name}"
        for table, columns in (
            ("answers", [*COLUMNS, *person]),
            ("people", [*PEOPLE, PLAN, *person]),
            ("log", [*LOG, *LOG_IDENTIFYING]),
        )
        for column in columns
    }
    assert {told for told in EXPORTED.values() if "." in told} <= there


@pytest.mark.parametrize("suffix", ["csv", "parquet"])
def test_who_entered_and_never_answered_is_among_the_people(
    place: str, tmp_path: Path, suffix: str
) -> None:
    with Store.open(place) as store:
        store.add_study({"design_hash": STUDY})
        [token] = store.invite(STUDY, 1, "Mr Mikimoto", "lab")
        store.enter(STUDY, "ja", {"sex": "f"}, token, parameters={"SONA": "4711"})
        store.set_registration(STUDY, "open", "lab")
        gone, _ = store.enter(STUDY, "en", {}, completion_code="K7Q")
        store.erase(gone.id, "lab")
        session, _ = store.enter(STUDY, "en", {}, completion_code="ZEBRA42")
        store.consent(session.id)
        store.answer(session.id, pair_answer(0, "q", "a", "b", "left", simulated=True))
        store.exclude(session.id, "slept", "lab")
        plain, whole = tmp_path / f"plain.{suffix}", tmp_path / f"whole.{suffix}"
        assert export(store, STUDY, plain, table="people") == 3
        assert export(store, STUDY, whole, table="people", identifying=True) == 3
        log = tmp_path / f"log.{suffix}"
        assert export(store, STUDY, log, table="log") == len(store.events(STUDY))
    read = pl.read_parquet if suffix == "parquet" else pl.read_csv
    rows = read(plain).to_dicts()
    assert [row["answers"] for row in rows] == [0, 0, 1]
    assert [row["erased"] for row in rows] == [False, True, False]
    assert [row["simulated"] for row in rows] == [False, False, True]
    assert [row["excluded"] for row in rows] == [None, None, "slept"]
    assert [row["slot"] for row in rows] == [0, None, 1]
    assert (rows[0]["language"], rows[0]["sex"]) == ("ja", "f")
    assert rows[0]["entered_at"] is not None
    assert rows[1]["entered_at"] is None
    first, _, last = read(whole).to_dicts()
    assert (first["invitation"], json.loads(first["parameters"])) == (
        "Mr Mikimoto",
        {"SONA": "4711"},
    )
    assert last["completion_code"] == "ZEBRA42"
    for path in (plain, log):
        for secret in ("Mikimoto", "4711", "ZEBRA42", "K7Q"):
            assert secret not in str(read(path).to_dicts())
    assert whole.stat().st_mode & 0o077 == 0


def test_flags_are_in_every_export_as_the_laboratorys_page_shows_them(
    service: Service, tmp_path: Path
) -> None:
    running, store = service.running, service.store
    session = running.enter(draw(), "en", {"trade": "yes"})
    store.consent(session.id)
    session = store.session(session.id)
    for trial in running.plan(session):
        hasty = Response("left", response_ms=1.0, flags={"away": 1})
        running.hand_in(session, trial.number, hasty).result()
    quiet = running.enter(draw(), "en", {"trade": "no"})
    store.consent(quiet.id)
    store.screen(quiet.id, {"flags": ["gamma"]})  # and never answered
    known = people_flags(running)
    assert {"fast", "answer-away"} <= {flag.kind for flag in known[0]}
    assert [flag.kind for flag in known[1]] == ["screen-gamma"]
    told = {}
    for table in ("people", "answers"):
        export(store, running.study, tmp_path / f"{table}.csv", table=table)
        for row in pl.read_csv(tmp_path / f"{table}.csv", infer_schema=False).to_dicts():
            told[table, int(row["person"])] = json.loads(row["person_flags"])
    assert set(told) == {("people", 0), ("people", 1), ("answers", 0)}
    for (_, number), found in told.items():
        assert [(one["flag"], one["detail"]) for one in found] == [
            (flag.kind, flag.detail) for flag in known[number]
        ]
