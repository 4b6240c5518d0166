"""The schema and the steps that lead to it."""

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
import sqlalchemy as sa
from alembic.autogenerate import compare_metadata
from alembic.runtime.migration import MigrationContext

from nacreous.problem import InputError
from nacreous.study.store import Store
from nacreous.study.store.engine import engine_of
from nacreous.study.store.schema import metadata


def test_the_steps_lead_to_the_schema(place: str) -> None:
    with Store.open(place) as store, store.engine.connect() as connection:
        context = MigrationContext.configure(connection, opts={"compare_type": True})
        assert compare_metadata(context, metadata) == []


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
            return store.add_study({"design_hash": "5e" * 32})

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
