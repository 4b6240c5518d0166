"""`nacreous study backup | restore | export | exclude | erase`."""

import argparse
from pathlib import Path

import polars as pl
import pytest

from nacreous.commands import study_store
from nacreous.problem import InputError
from nacreous.study.store import Store
from tests.support.pairs import pair_answer

STUDY = "5e" * 32


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A study's folder with three people of two answers each."""
    made = tmp_path / "my-study"
    made.mkdir()
    with Store.open(made) as store:
        store.add_study({"design_hash": STUDY})
        store.set_registration(STUDY, "open", "lab")
        for _ in range(3):
            session, _ = store.enter(STUDY, "en", {})
            store.consent(session.id)
            for n in range(2):
                store.answer(session.id, pair_answer(n, "q", "a", "b", "left"))
    return made


def call(*arguments: object) -> int:
    parser = argparse.ArgumentParser()
    study_store.add_actions(parser.add_subparsers())
    args = parser.parse_args([str(argument) for argument in arguments])
    return int(args.run(args))


def test_a_backup_goes_and_comes(folder: Path, tmp_path: Path, capsys) -> None:
    copy = tmp_path / "copy.sqlite"
    assert call("backup", folder, "-o", copy) == 0
    assert capsys.readouterr().out == f"{copy}: written, 1 studies, 3 people, 6 answers\n"
    assert call("restore", copy, tmp_path / "new.sqlite") == 0
    with Store.open(tmp_path / "new.sqlite") as store:
        assert store.progress(STUDY).answers == 6


def test_exclude_erase_and_export_tell_how_many(folder: Path, tmp_path: Path, capsys) -> None:
    output = tmp_path / "answers.csv"
    call("exclude", folder, 0, "--reason", "slept")
    call("erase", folder, 2)
    capsys.readouterr()
    call("export", folder, "-o", output, "--study", "5e5e")
    told = "6 answers of 3 people; among them, marked: 1 people excluded, 1 erased, 0 answers"
    assert told in capsys.readouterr().out
    rows = pl.read_csv(output)
    assert rows["excluded"].to_list().count("slept") == 2
    assert rows["erased"].sum() == 2
    with Store.open(folder) as store:
        assert [event.what for event in store.events()][-2:] == ["excluded", "erased"]


def test_the_variable_serves_where_no_place_is_given(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("NACREOUS_STORE", str(folder))
    call("export", "-o", tmp_path / "psych")
    assert (tmp_path / "psych" / "dataset_description.json").exists()


def test_mistakes_are_one_line_and_make_nothing(folder: Path, tmp_path: Path) -> None:
    empty = tmp_path / "empty"
    empty.mkdir()
    for arguments, told in (
        (("export", empty), "does not exist; wanted: a store"),
        (("export", folder, "--study", "ff"), "has 0 studies of 'ff'"),
        (("erase", folder, 3), "person is 3; allowed: 0 to 2"),
        (("backup", empty, "-o", tmp_path / "a.sqlite"), "does not exist; wanted: a store"),
        (("restore", tmp_path / "a.sqlite", empty), "does not exist"),
    ):
        with pytest.raises(InputError, match=told) as caught:
            call(*arguments)
        assert "\n" not in str(caught.value)
    assert list(empty.iterdir()) == []
    assert not (tmp_path / "a.sqlite").exists()
