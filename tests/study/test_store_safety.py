"""A store is its owner's alone, and a file that was handed on does nothing but hold answers."""

import os
import shutil
import sqlite3
import stat
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest

from nacreous.problem import InputError
from nacreous.study.store import Store, backup, restore
from tests.support.pairs import pair_answer

STUDY = "5e" * 32


@pytest.fixture(autouse=True)
def generous_umask() -> Iterator[None]:
    """A machine on which every new file is for everybody."""
    before = os.umask(0o000)
    yield
    os.umask(before)


def fill(store: Store) -> None:
    store.add_study({"design_hash": STUDY})
    store.set_registration(STUDY, "open", "lab")
    session, _ = store.enter(STUDY, "en", {})
    store.consent(session.id)
    store.answer(session.id, pair_answer(0, "q", "a", "b", "left"))


def modes(folder: Path) -> dict[str, int]:
    return {path.name: stat.S_IMODE(path.stat().st_mode) for path in folder.rglob("*.sqlite*")}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    made = tmp_path / "study"
    made.mkdir()
    with Store.open(made) as store:
        fill(store)
    return made


def test_a_store_and_all_files_beside_it_are_their_owners_alone(tmp_path: Path) -> None:
    with Store.open(tmp_path) as store:
        fill(store)
        found = modes(tmp_path)
    assert set(found) == {"answers.sqlite", "answers.sqlite-wal", "answers.sqlite-shm"}
    assert set(found.values()) == {0o600}


def test_a_store_that_others_could_read_is_closed_to_them_when_it_is_opened(folder: Path) -> None:
    file = folder / "answers.sqlite"
    with Store.open(folder):
        kept = {path: path.read_bytes() for path in folder.glob("answers.sqlite*")}
    for path, content in kept.items():  # as a killed program of an older version leaves them
        path.write_bytes(content)
        path.chmod(0o644)
    with Store.open(file) as store:
        assert store.progress(STUDY).answers == 1
        assert set(modes(folder).values()) == {0o600}


def test_backups_and_restored_stores_are_their_owners_alone(folder: Path, tmp_path: Path) -> None:
    (tmp_path / "copies").mkdir()
    monday = tmp_path / "copies" / "monday.sqlite"
    monday.touch(0o644)  # what is replaced was open to others
    backup(folder, monday)
    restore(monday, tmp_path / "copies" / "again.sqlite")
    assert modes(tmp_path / "copies") == {"monday.sqlite": 0o600, "again.sqlite": 0o600}


STRANGE = (
    "CREATE TRIGGER spy AFTER INSERT ON answers BEGIN DELETE FROM audit; END",
    "CREATE VIEW people AS SELECT * FROM sessions",
    "CREATE TABLE soup (salt)",
    "CREATE VIRTUAL TABLE soup USING fts5(salt)",
    "ALTER TABLE answers ADD COLUMN salt TEXT",
    "ALTER TABLE answers ADD COLUMN salt TEXT AS (upper(flags)) VIRTUAL",
    "CREATE INDEX spice ON answers (upper(flags))",
    "DROP TABLE logins; CREATE VIEW logins AS SELECT 1",
    "DROP TABLE logins; CREATE VIRTUAL TABLE logins USING fts5(token_hash)",
)


@pytest.mark.parametrize("strange", STRANGE)
def test_what_no_store_has_is_refused_by_restore_and_by_opening(
    folder: Path, tmp_path: Path, strange: str
) -> None:
    copy = tmp_path / "copy.sqlite"
    backup(folder, copy)
    with closing(sqlite3.connect(copy)) as connection:
        connection.executescript(strange)
    before = copy.read_bytes()
    new = tmp_path / "new.sqlite"
    with pytest.raises(InputError, match=r"holds the .*, which no store has") as caught:
        restore(copy, new)
    assert "\n" not in str(caught.value)
    assert not new.exists()
    with pytest.raises(InputError, match="which no store has"):
        Store.open(copy)
    assert copy.read_bytes() == before


def test_an_index_that_a_lab_added_for_speed_is_none_of_these(folder: Path) -> None:
    with closing(sqlite3.connect(folder / "answers.sqlite")) as connection:
        connection.executescript("CREATE INDEX quick ON answers (received_at); ANALYZE")
    with Store.open(folder) as store:
        assert store.progress(STUDY).answers == 1


def test_a_folders_store_that_is_a_link_is_refused_by_the_name_of_what_it_leads_to(
    folder: Path, tmp_path: Path
) -> None:
    elsewhere = tmp_path / "elsewhere.sqlite"
    shutil.move(folder / "answers.sqlite", elsewhere)
    (folder / "answers.sqlite").symlink_to(elsewhere)
    with pytest.raises(InputError, match=f"is a link to {elsewhere}; wanted: a file in the folder"):
        Store.open(folder)
    with Store.open(elsewhere) as store:
        assert store.progress(STUDY).answers == 1
