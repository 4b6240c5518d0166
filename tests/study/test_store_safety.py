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
from nacreous.study.design.manifest import hash_of
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
    "CREATE UNIQUE INDEX one ON answers (study)",
    "CREATE INDEX some ON answers (seq) WHERE length(zeroblob(9e8)) > 1",
    "DROP INDEX ix_answers_study; CREATE UNIQUE INDEX ix_answers_study ON answers (study)",
    "DROP INDEX ix_answers_study; CREATE INDEX ix_answers_study ON answers (study) WHERE seq > 1",
    "DROP INDEX ix_answers_study; CREATE INDEX ix_answers_study ON answers (study COLLATE NOCASE)",
    "DROP INDEX ix_answers_study; CREATE INDEX ix_answers_study ON sessions (study)",
)
#: What a table of ours could be changed to, by the words that are replaced.
CHANGED = (
    ("flags TEXT NOT NULL", "flags TEXT NOT NULL CHECK (chosen <> 'left')"),
    ("flags TEXT NOT NULL", "flags TEXT NOT NULL ON CONFLICT REPLACE DEFAULT (hex(zeroblob(9)))"),
    ("erased_as VARCHAR(24)", "erased_as VARCHAR(24) DEFAULT 'nobody'"),
    ("erased_as VARCHAR(24)", "erased_as VARCHAR(24) UNIQUE"),
    ("kind VARCHAR(8) NOT NULL", "kind VARCHAR(8) NOT NULL COLLATE NOCASE"),
    ("UNIQUE (session, trial)", "UNIQUE (session, trial) ON CONFLICT REPLACE"),
    ("UNIQUE (session, trial)", "UNIQUE (session)"),
    ("REFERENCES sessions (id)", "REFERENCES sessions (id) ON DELETE CASCADE"),
    (" AUTOINCREMENT", ""),
    ("question TEXT", "question BLOB"),
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


@pytest.mark.parametrize(("own", "foreign"), CHANGED)
def test_a_table_of_ours_with_other_rules_is_refused(
    folder: Path, tmp_path: Path, own: str, foreign: str
) -> None:
    copy = tmp_path / "copy.sqlite"
    backup(folder, copy)
    rewrite(copy, own, foreign)
    with pytest.raises(InputError, match=r"holds the table answers, changed at .*, which no store"):
        restore(copy, tmp_path / "new.sqlite")
    with pytest.raises(InputError, match="changed at"):
        Store.open(copy)


def rewrite(file: Path, own: str, foreign: str) -> None:
    """Change the rules of the table of answers."""
    with closing(sqlite3.connect(file)) as connection:
        sql, made = connection.execute(
            "SELECT sql, replace(sql, ?, ?) FROM sqlite_master WHERE name = 'answers'",
            (own, foreign),
        ).fetchone()
        assert made != sql
        indexes = connection.execute(
            "SELECT sql FROM sqlite_master WHERE type = 'index' AND tbl_name = 'answers' "
            "AND sql IS NOT NULL"
        ).fetchall()
        connection.executescript(
            "ALTER TABLE answers RENAME TO former; "
            + f"{made}; DROP TABLE former; "
            + "; ".join(sql for (sql,) in indexes)
        )


def test_a_virtual_table_under_one_of_sqlites_own_names_is_refused(
    folder: Path, tmp_path: Path
) -> None:
    copy = tmp_path / "copy.sqlite"
    backup(folder, copy)
    with closing(sqlite3.connect(copy)) as connection:
        connection.executescript(
            "PRAGMA writable_schema = ON; INSERT INTO sqlite_master VALUES ('table', "
            "'sqlite_stat4', 'sqlite_stat4', 0, 'CREATE VIRTUAL TABLE sqlite_stat4 USING fts5(x)')"
        )
    with pytest.raises(InputError, match="the table sqlite_stat4, which no store has"):
        restore(copy, tmp_path / "new.sqlite")


def test_a_trigger_under_one_of_sqlites_own_names_is_refused(folder: Path, tmp_path: Path) -> None:
    copy = tmp_path / "copy.sqlite"
    backup(folder, copy)
    with closing(sqlite3.connect(copy)) as connection:
        connection.executescript(
            "CREATE TRIGGER spy AFTER INSERT ON answers BEGIN DELETE FROM audit; END; "
            "PRAGMA writable_schema = ON; "
            "UPDATE sqlite_master SET name = 'sqlite_spy', sql = replace(sql, 'spy', 'sqlite_spy') "
            "WHERE name = 'spy'"
        )
    with pytest.raises(InputError, match="the trigger sqlite_spy, which no store has"):
        restore(copy, tmp_path / "new.sqlite")


@pytest.mark.parametrize(
    ("strange", "said"),
    [
        ("DROP TABLE logins", "lacks the index ix_logins_account|lacks the table logins"),
        ("DROP INDEX ix_answers_study", "lacks the index ix_answers_study"),
        ("UPDATE sqlite_sequence SET seq = 9223372036854775807", "highest number in sqlite_seq"),
        ("UPDATE sqlite_sequence SET seq = 'many'", "highest number in sqlite_sequence is many"),
        ("UPDATE answers SET seq = 9223372036854775807", "highest number in answers is 9223"),
        ("INSERT INTO alembic_version VALUES ('0002')", "names 2 schemas"),
    ],
)
def test_what_lacks_a_part_or_could_count_no_further_is_refused(
    folder: Path, tmp_path: Path, strange: str, said: str
) -> None:
    copy = tmp_path / "copy.sqlite"
    backup(folder, copy)
    with closing(sqlite3.connect(copy)) as connection:
        connection.executescript(strange)
    for use in (lambda: restore(copy, tmp_path / "new.sqlite"), lambda: Store.open(copy)):
        with pytest.raises(InputError, match=said):
            use()


def test_a_pipe_or_a_folder_is_no_store_and_no_backup(tmp_path: Path) -> None:
    pipe, inside, other = tmp_path / "pipe.sqlite", tmp_path / "study", tmp_path / "other.sqlite"
    os.mkfifo(pipe)
    inside.mkdir()
    os.mkfifo(inside / "answers.sqlite")
    other.mkdir()
    for place in (pipe, inside):
        for use in (Store.open, lambda place: backup(place, tmp_path / "copy.sqlite")):
            with pytest.raises(InputError, match=r"sqlite: is no ordinary file; wanted: a store"):
                use(place)
    with pytest.raises(InputError, match=r"pipe.sqlite: is no ordinary file; wanted: one"):
        restore(pipe, tmp_path / "new.sqlite")
    with pytest.raises(InputError, match=r"other.sqlite: is a folder; wanted: a file"):
        restore(other, tmp_path / "new.sqlite")


def test_views_alone_make_no_empty_database(tmp_path: Path) -> None:
    file = tmp_path / "views.sqlite"
    with closing(sqlite3.connect(file)) as connection:
        connection.execute("CREATE VIEW people AS SELECT 1")
    with pytest.raises(InputError, match="holds other tables"):
        Store.open(file)


@pytest.mark.parametrize(
    "change",
    [
        "UPDATE studies SET manifest = replace(manifest, 'deeper', 'duller')",
        "UPDATE studies SET manifest = '{}'",
        "UPDATE studies SET manifest = 'soup'",
        "UPDATE studies SET manifest = '[1]'",
        "UPDATE studies SET manifest = x'00'",
    ],
)
def test_a_backup_whose_study_was_changed_since_it_was_frozen_is_refused(
    tmp_path: Path, change: str
) -> None:
    place, copy = tmp_path / "answers.sqlite", tmp_path / "copy.sqlite"
    sealed = {"design": {"name": "deeper"}}
    with Store.open(place) as store:
        store.add_study({**sealed, "study_hash": hash_of(sealed)})
    backup(place, copy)
    restore(copy, tmp_path / "intact.sqlite")
    with closing(sqlite3.connect(copy)) as connection:
        connection.execute(change)
        connection.commit()
    with pytest.raises(
        InputError, match=r"manifest (of study .* has been changed since|is .*; allowed: text)"
    ):
        restore(copy, tmp_path / "new.sqlite")


def test_a_name_without_ending_is_restored_as_a_folder(folder: Path, tmp_path: Path) -> None:
    copy = tmp_path / "copy.sqlite"
    backup(folder, copy)
    restore(copy, tmp_path / "again")
    assert [path.name for path in (tmp_path / "again").iterdir()] == ["answers.sqlite"]
    rewrite(copy, " AUTOINCREMENT", "")
    with pytest.raises(InputError):
        restore(copy, tmp_path / "never")
    assert not (tmp_path / "never").exists()


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


@pytest.mark.parametrize("end", ["-wal", "-shm", "-journal"])
def test_a_link_beside_a_store_is_named(folder: Path, tmp_path: Path, end: str) -> None:
    link = folder / f"answers.sqlite{end}"
    link.unlink(missing_ok=True)
    link.symlink_to(tmp_path / "elsewhere")
    with pytest.raises(InputError, match=rf"answers.sqlite{end}: is a link to .*elsewhere; wanted"):
        Store.open(folder)
    assert not (tmp_path / "elsewhere").exists()
