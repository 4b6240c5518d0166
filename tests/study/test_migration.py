"""The schema and the steps that lead to it."""

import json
from concurrent.futures import ThreadPoolExecutor
from datetime import datetime
from pathlib import Path

import pytest
import sqlalchemy as sa
from alembic.autogenerate import compare_metadata
from alembic.runtime.migration import MigrationContext

from nacreous.problem import InputError
from nacreous.study.store import Copied, NotAllowed, Store, restore
from nacreous.study.store.engine import engine_of, writing
from nacreous.study.store.schema import metadata
from nacreous.study.store.steps import take
from tests.support.pairs import pair_answer

STUDY = "5e" * 32
AT = "2026-03-01T09:30:00.000000Z"
#: One person who gave one answer, in the first schema.
OLD = {
    "studies": {"hash": STUDY, "state": "open", "next_number": 1, "added_at": AT}
    | {"manifest": json.dumps({"design_hash": STUDY})},
    "sessions": {
        **{"id": "one", "study": STUDY, "number": 0, "token_hash": "7a" * 32, "language": "en"},
        **{"groups": "{}", "consented_at": AT, "started_at": AT},
    },
    "answers": {
        **{"study": STUDY, "session": "one", "trial": 0, "kind": "pair", "question": "q"},
        **{"left": "a", "right": "b", "chosen": "left", "received_at": AT, "flags": "{}"},
        **{"simulated": False, "digest": "0"},
    },
}


def make_old(place: str, newest: str = "0001", **session: str) -> None:
    """A store of an older schema, the first unless another is named; session: more of its row."""
    engine = writing(engine_of(place))
    with engine.begin() as connection:
        take(connection, newest)
        for table, row in {**OLD, "sessions": {**OLD["sessions"], **session}}.items():
            names = ", ".join(f'"{name}"' for name in row)
            values = ", ".join(f":{name}" for name in row)
            connection.execute(sa.text(f"INSERT INTO {table} ({names}) VALUES ({values})"), row)
    engine.dispose()


def test_the_steps_lead_to_the_schema(place: str) -> None:
    with Store.open(place) as store, store.engine.connect() as connection:
        context = MigrationContext.configure(connection, opts={"compare_type": True})
        assert compare_metadata(context, metadata) == []


def test_an_old_store_is_brought_up_to_date_and_keeps_all_it_had(place: str) -> None:
    make_old(place)
    with Store.open(place) as store:
        with store.engine.connect() as connection:
            context = MigrationContext.configure(connection, opts={"compare_type": True})
            assert compare_metadata(context, metadata) == []
        assert store.studies() == {STUDY: "open"}
        assert store.registration(STUDY) == "invited"
        assert [row["chosen"] for row in store.answers(STUDY)] == ["left"]
        store.answer("one", pair_answer(1, "q", "a", "b", "right"))
        assert store.plan("one") is None
        with pytest.raises(NotAllowed):
            store.enter(STUDY, "en", {})
        store.set_registration(STUDY, "open", "lab")
        assert store.enter(STUDY, "en", {})[0].number == 1


@pytest.mark.parametrize("trials", [1, 2])
def test_whoever_answered_all_before_the_server_told_the_end_has_finished(
    place: str, trials: int
) -> None:
    make_old(place, "0002", plan=str([{}] * trials))
    with Store.open(place) as store:
        [session] = store.sessions(STUDY)
    assert session.slot == session.number
    assert (session.finished_at is None) == (trials > 1)
    if session.finished_at is not None:
        assert session.finished_at == datetime.fromisoformat(AT)


def test_an_old_backup_is_brought_up_to_date(place: str, tmp_path: Path) -> None:
    old = tmp_path / "old.sqlite"
    make_old(str(old))
    before = old.read_bytes()
    assert restore(old, place) == Copied(1, 1, 1)
    assert old.read_bytes() == before
    with Store.open(place, make=False) as store:
        assert store.registration(STUDY) == "invited"
        assert store.session("one").number == 0


def test_sqlite_is_durable_and_checks_its_keys(tmp_path: Path) -> None:
    with Store.open(tmp_path) as store, store.engine.connect() as connection:
        told = {
            name: connection.exec_driver_sql(f"PRAGMA {name}").scalar_one()
            for name in ("journal_mode", "synchronous", "foreign_keys", "busy_timeout")
        }
    full = 2
    assert told == {
        "journal_mode": "wal",
        "synchronous": full,
        "foreign_keys": 1,
        "busy_timeout": 10_000,
    }


def test_a_newer_store_is_refused_and_left_alone(place: str) -> None:
    Store.open(place).close()
    engine = engine_of(place)
    with engine.begin() as connection:
        connection.execute(sa.text("UPDATE alembic_version SET version_num = '9999'"))
    with pytest.raises(InputError, match="has schema '9999'"):
        Store.open(place)
    with engine.begin() as connection:
        version = connection.execute(sa.text("SELECT version_num FROM alembic_version"))
        assert version.scalar_one() == "9999"
    engine.dispose()


def test_another_programs_database_is_refused(place: str) -> None:
    engine = engine_of(place)
    with engine.begin() as connection:
        connection.execute(sa.text("CREATE TABLE recipes (soup TEXT)"))
    engine.dispose()
    file = Path(place)
    before = file.read_bytes() if file.exists() else b""
    with pytest.raises(InputError, match="holds other tables"):
        Store.open(place)
    assert (file.read_bytes() if file.exists() else b"") == before


def test_many_may_make_the_same_store_at_once(place: str) -> None:
    def open_and_close(_: int) -> str:
        with Store.open(place) as store:
            return store.add_study({"design_hash": STUDY})

    with ThreadPoolExecutor(8) as pool:
        assert len(set(pool.map(open_and_close, range(16)))) == 1


def test_places_that_cannot_be_a_store(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = tmp_path / "notes.txt"
    text.write_text("pearls " * 1000)
    for place, told in (
        (text, "is no store"),
        (tmp_path / "no" / "a.sqlite", "does not exist"),
        ("mysql://lab/pearls", "allowed: a path, or postgresql"),
        ("postgresql://:::", "store is no URL"),
    ):
        with pytest.raises(InputError, match=told):
            Store.open(place)
    monkeypatch.delenv("NACREOUS_STORE", raising=False)
    with pytest.raises(InputError, match=r"store is empty; .* NACREOUS_STORE"):
        Store.open()
    monkeypatch.setenv("NACREOUS_STORE", str(tmp_path))
    with Store.open() as store:
        assert store.place == str(tmp_path / "answers.sqlite")


def test_a_server_that_is_not_there_is_one_line_without_the_password(tmp_path: Path) -> None:
    with pytest.raises(OSError, match="cannot be reached") as caught:
        Store.open(f"postgresql://lab:secret@/pearls?host={tmp_path}")
    assert "\n" not in str(caught.value)
    assert "secret" not in str(caught.value)
