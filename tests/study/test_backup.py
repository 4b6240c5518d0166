"""Backups: whole or absent, checked, and good for either database."""

import shutil
import sqlite3
import threading
from pathlib import Path

import pytest
import sqlalchemy as sa

from nacreous.problem import InputError
from nacreous.study.store import Copied, Store, UnknownToken, backup, restore
from nacreous.study.store.schema import metadata
from tests.support.database import Server
from tests.support.pairs import pair_answer

STUDY = "5e" * 32


def fill(place: str, people: int = 3, trials: int = 5) -> str:
    """A store with all that can be in one; the last session."""
    with Store.open(place) as store:
        store.add_study({"design_hash": STUDY, "design": {"name": "真珠"}})
        store.set_registration(STUDY, "open", "lab")
        for _ in range(people):
            session, _ = store.enter(STUDY, "ja", {"sex": "f"})
            store.consent(session.id)
            store.screen(session.id, {"mm": 0.25})
            for n in range(trials):
                store.answer(
                    session.id, pair_answer(n, "q", "a", "b", "left", 100.5, flags={"n": n})
                )
            store.settle(session.id, {"sex": "f"}, [{"left": "a"}])
        [token, _] = store.invite(STUDY, 2, "seat", "lab")
        store.enter(STUDY, "ja", {"sex": "m"}, token)
        store.set_password("lab", "nacre, layer on layer", "me")
        store.login("lab", "nacre, layer on layer")
    return session.id


def content(place: str) -> dict[str, list[tuple]]:
    with Store.open(place) as store, store.engine.connect() as connection:
        return {
            table.name: sorted(
                (tuple(row) for row in connection.execute(sa.select(table))), key=repr
            )
            for table in metadata.sorted_tables
            if table.name != "logins"
        }


def test_a_restored_store_is_the_same_store_and_goes_on(place: str, tmp_path: Path) -> None:
    last = fill(place)
    before = content(place)
    assert backup(place, tmp_path / "copy.sqlite") == Copied(1, 4, 15)
    restored = tmp_path / "new" / "answers.sqlite"
    restored.parent.mkdir()
    assert restore(tmp_path / "copy.sqlite", restored) == Copied(1, 4, 15)
    assert content(str(restored)) == before
    with Store.open(restored) as store:
        assert store.enter(STUDY, "ja", {})[0].number == 4
        assert [one.number for one in store.invitations(STUDY)] == [3, None]
        assert not store.answer(last, pair_answer(5, "q", "a", "b", "left")).again
        assert [row["trial"] for row in store.answers(STUDY)][-1] == 5


def test_a_backup_has_accounts_and_no_logins(place: str, tmp_path: Path) -> None:
    fill(place)
    with Store.open(place) as store:
        token = store.login("lab", "nacre, layer on layer")
        backup(place, tmp_path / "copy.sqlite")
        assert store.login_of(token) == "lab"
    with Store.open(tmp_path / "copy.sqlite") as copy:
        with pytest.raises(UnknownToken):
            copy.login_of(token)
        assert copy.login_of(copy.login("lab", "nacre, layer on layer")) == "lab"


def test_a_laptops_backup_goes_into_postgresql(postgresql: Server, tmp_path: Path) -> None:
    laptop = str(tmp_path / "answers.sqlite")
    last = fill(laptop)
    backup(laptop, tmp_path / "copy.sqlite")
    place = postgresql.create("restored")
    restore(tmp_path / "copy.sqlite", place)
    assert content(place) == content(laptop)
    with Store.open(place) as store:
        store.answer(last, pair_answer(5, "q", "a", "b", "left"))
        assert [row["trial"] for row in store.answers(STUDY)][-1] == 5
    with pytest.raises(InputError, match="holds studies already"):
        restore(tmp_path / "copy.sqlite", place)


def test_a_backup_while_answers_come_holds_an_unbroken_beginning(
    place: str, tmp_path: Path
) -> None:
    session = fill(place, people=1, trials=0)
    stop = threading.Event()
    with Store.open(place) as store:

        def answer() -> None:
            n = 0
            while not stop.is_set():
                store.answer(session, pair_answer(n, "q", "a", "b", "left"))
                n += 1

        thread = threading.Thread(target=answer)
        thread.start()
        try:
            for n in range(5):
                backup(place, tmp_path / f"{n}.sqlite")
        finally:
            stop.set()
            thread.join()
        given = len(store.answers(STUDY))
    for n in range(5):
        with Store.open(tmp_path / f"{n}.sqlite") as copy:
            trials = [row["trial"] for row in copy.answers(STUDY)]
        assert trials == list(range(len(trials)))
        assert len(trials) <= given


def test_a_backup_is_one_file(tmp_path: Path) -> None:
    fill(str(tmp_path / "answers.sqlite"))
    folder = tmp_path / "backups"
    folder.mkdir()
    backup(tmp_path / "answers.sqlite", folder / "copy.sqlite")
    assert [path.name for path in folder.iterdir()] == ["copy.sqlite"]
    assert (folder / "copy.sqlite").read_bytes()[18:20] == b"\x01\x01", "no log belongs to it"


def test_what_cannot_be_backed_up_or_restored_is_one_line(tmp_path: Path) -> None:
    place = tmp_path / "answers.sqlite"
    fill(str(place))
    good = tmp_path / "good.sqlite"
    backup(place, good)
    (tmp_path / "text.sqlite").write_text("pearls " * 1000)
    (tmp_path / "empty.sqlite").touch()
    with sqlite3.connect(tmp_path / "other.sqlite") as other:
        other.execute("CREATE TABLE soup (salt)")
    other.close()
    damaged = bytearray(good.read_bytes())
    damaged[4096 * 3 : 4096 * 5] = b"\xff" * 8192
    (tmp_path / "damaged.sqlite").write_bytes(damaged)
    shutil.copy(good, tmp_path / "newer.sqlite")
    with sqlite3.connect(tmp_path / "newer.sqlite") as newer:
        newer.execute("UPDATE alembic_version SET version_num = '9999'")
    newer.close()
    new = tmp_path / "new.sqlite"
    for source, target, told in (
        ("no.sqlite", new, "does not exist"),
        ("text.sqlite", new, "is no whole store"),
        ("empty.sqlite", new, "is empty"),
        ("other.sqlite", new, "holds other tables"),
        ("damaged.sqlite", new, "is damaged|is no whole store"),
        ("newer.sqlite", new, "has schema '9999'"),
        ("good.sqlite", place, "is there already"),
        ("good.sqlite", tmp_path / "no" / "a.sqlite", "does not exist"),
    ):
        with pytest.raises(InputError, match=told) as caught:
            restore(tmp_path / source, target)
        assert "\n" not in str(caught.value)
        assert not new.exists()
    for output, told in (
        (place, "is the same file as the input"),
        (tmp_path / "a.txt", "the ending is"),
    ):
        with pytest.raises(InputError, match=told):
            backup(place, output)
    with pytest.raises(InputError, match="does not exist; wanted: a store"):
        backup(new, tmp_path / "b.sqlite")
    assert not new.exists()
    assert not (tmp_path / "b.sqlite").exists()


def test_a_link_that_leads_nowhere_becomes_a_folder_as_any_name_without_an_ending(
    tmp_path: Path,
) -> None:
    fill(str(tmp_path / "answers.sqlite"), people=1)
    backup(tmp_path / "answers.sqlite", tmp_path / "copy.sqlite")
    (tmp_path / "link").symlink_to("nowhere")
    restore(tmp_path / "copy.sqlite", tmp_path / "link")
    assert (tmp_path / "nowhere" / "answers.sqlite").is_file()
    (tmp_path / "named").symlink_to("named.sqlite")
    restore(tmp_path / "copy.sqlite", tmp_path / "named")
    assert (tmp_path / "named.sqlite").is_file()


def test_a_backup_in_utf_16_is_refused_for_its_encoding(tmp_path: Path) -> None:
    fill(str(tmp_path / "answers.sqlite"), people=1)
    with sqlite3.connect(tmp_path / "answers.sqlite") as store:
        words = list(store.iterdump())
    store.close()
    with sqlite3.connect(tmp_path / "copy.sqlite") as copy:
        copy.execute("PRAGMA encoding = 'UTF-16'")
        copy.executescript("\n".join(words))
    copy.close()
    with pytest.raises(InputError, match=r"copy\.sqlite: is in UTF-16(le|be); wanted: UTF-8"):
        restore(tmp_path / "copy.sqlite", tmp_path / "new.sqlite")


def test_what_an_interrupted_program_left_beside_a_backup_is_named(tmp_path: Path) -> None:
    fill(str(tmp_path / "answers.sqlite"), people=1)
    backup(tmp_path / "answers.sqlite", tmp_path / "copy.sqlite")
    left = tmp_path / "copy.sqlite-journal"
    left.write_bytes(b"\xd9\xd5\x05\xf9\x20\xa1\x63\xd7" + b"x" * 5000)
    with pytest.raises(InputError, match=r"copy\.sqlite-journal: lies beside .*: remove it"):
        restore(tmp_path / "copy.sqlite", tmp_path / "new.sqlite")
    left.unlink()
    restore(tmp_path / "copy.sqlite", tmp_path / "new.sqlite")
