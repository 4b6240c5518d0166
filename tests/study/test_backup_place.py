"""Backups lie wherever a file can lie, and reading one leaves its folder as it was."""

import shutil
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest

from nacreous.problem import InputError
from nacreous.study.store import Copied, backup, restore
from tests.study.test_backup import content, fill

#: What URLs give a meaning to, and what they may not hold.
NAMES = ("Pearls #2", "Why?", "50%25", "file:a&mode=rwc;b+c", "真珠 '")


@pytest.fixture(scope="module")
def store(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A store of two people, which nobody changes."""
    place = tmp_path_factory.mktemp("store") / "answers.sqlite"
    fill(str(place), people=1, trials=2)
    return place


@pytest.mark.parametrize("name", NAMES)
def test_a_backup_lies_under_any_name_and_leaves_no_other_file(
    name: str, store: Path, tmp_path: Path
) -> None:
    folder = tmp_path / name
    folder.mkdir()
    for copy in (folder / "b.sqlite", tmp_path / f"{name}.sqlite"):
        for _ in range(2):  # the second is written over an earlier backup, which is read first
            assert backup(store, copy) == Copied(1, 2, 2)
    restored = folder / name
    assert restore(folder / "b.sqlite", restored) == Copied(1, 2, 2)
    assert content(str(restored / "answers.sqlite")) == content(str(store))
    assert {path.name for path in tmp_path.iterdir()} == {name, f"{name}.sqlite"}
    assert {path.name for path in folder.iterdir()} == {"b.sqlite", name}


@pytest.mark.parametrize("name", NAMES)
def test_a_store_under_any_name_is_backed_up_and_kept_from_being_written_over(
    name: str, store: Path, tmp_path: Path
) -> None:
    folder = tmp_path / name
    folder.mkdir()
    own, other = folder / "own.sqlite", tmp_path / "other.sqlite"
    backup(store, own)  # a backup is a store
    assert backup(own, tmp_path / "copy.sqlite") == Copied(1, 2, 2)
    with closing(sqlite3.connect(other)) as empty:
        empty.execute("CREATE TABLE studies (hash TEXT)")
        empty.execute("INSERT INTO studies VALUES ('another')")
        empty.commit()
    shutil.copy(other, folder / "other.sqlite")
    with pytest.raises(InputError, match="holds study another"):
        backup(own, folder / "other.sqlite")


@pytest.mark.parametrize("kind", ["text", "database", "damaged"])
def test_a_backup_writes_over_nothing_but_an_earlier_backup(
    kind: str, store: Path, tmp_path: Path
) -> None:
    taken = tmp_path / "taken.sqlite"
    if kind == "text":
        taken.write_text("a diary")
    elif kind == "database":
        with closing(sqlite3.connect(taken)) as other:
            other.execute("CREATE TABLE songs (name)")
    else:
        backup(store, taken)
        taken.write_bytes(taken.read_bytes()[:5000])
    before = taken.read_bytes()
    with pytest.raises(InputError, match=r"taken.sqlite: is no backup that"):
        backup(store, taken)
    assert taken.read_bytes() == before


@pytest.mark.parametrize("there", [True, False])
def test_a_backup_goes_through_no_link(there: bool, store: Path, tmp_path: Path) -> None:
    target, link = tmp_path / "target.sqlite", tmp_path / "link.sqlite"
    if there:
        backup(store, target)
    link.symlink_to(target)
    before = target.read_bytes() if there else None
    with pytest.raises(InputError, match=r"link.sqlite: is a link to .*target.sqlite; wanted"):
        backup(store, link)
    assert (target.read_bytes() if target.exists() else None) == before


def test_a_restore_leaves_nothing_beside_a_copy_of_a_store_that_keeps_a_log(
    store: Path, tmp_path: Path
) -> None:
    kept = tmp_path / "kept"
    kept.mkdir()
    copy = kept / "copy.sqlite"
    shutil.copyfile(store, copy)
    assert copy.read_bytes()[18:20] == b"\2\2"  # with a log
    copy.chmod(0o400)
    before = copy.read_bytes()
    assert restore(copy, tmp_path / "new.sqlite") == Copied(1, 2, 2)
    assert [path.name for path in kept.iterdir()] == ["copy.sqlite"]
    assert copy.read_bytes() == before
    assert content(str(tmp_path / "new.sqlite")) == content(str(store))


def test_a_restore_takes_what_is_still_in_the_log_beside_a_copy(
    store: Path, tmp_path: Path
) -> None:
    own, kept = tmp_path / "answers.sqlite", tmp_path / "kept"
    kept.mkdir()
    backup(store, own)
    with closing(sqlite3.connect(own)) as writing:
        writing.execute("PRAGMA journal_mode = WAL")
        writing.execute("UPDATE answers SET response_ms = 777.0")
        writing.commit()
        for end in ("", "-wal"):
            shutil.copyfile(f"{own}{end}", f"{kept / 'copy.sqlite'}{end}")
    restore(kept / "copy.sqlite", tmp_path / "new.sqlite")
    with closing(sqlite3.connect(tmp_path / "new.sqlite")) as restored:
        assert restored.execute("SELECT DISTINCT response_ms FROM answers").fetchall() == [(777.0,)]
