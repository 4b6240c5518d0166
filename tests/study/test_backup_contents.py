"""A backup holds what a store can hold, or is refused by table, row and column."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from nacreous.problem import InputError
from nacreous.study.store import Store, backup, restore
from tests.support.gathering import by_scale, frozen_study, opened, take_part
from tests.support.pairs import pair_answer

STUDY = "5e" * 32


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A backup with a row in every table that it holds."""
    folder = tmp_path_factory.mktemp("contents")
    with Store.open(folder) as store:
        store.add_study({"design_hash": STUDY})
        store.set_registration(STUDY, "open", "lab")
        session, _ = store.enter(STUDY, "ja", {"性別": "f"})
        store.consent(session.id)
        store.screen(session.id, {"mm": 0.25})
        store.answer(session.id, pair_answer(0, "q", "真珠", "b", "left", 100.5, flags={"away": 1}))
        trial = {"number": 0, "question": "q", "block": 1, "break_before": False}
        store.settle(session.id, {"性別": "f"}, [trial])
        store.invite(STUDY, 1, "seat", "lab")
        store.set_password("lab", "nacre, layer on layer", "me")
    backup(folder, folder / "whole.sqlite")
    return folder / "whole.sqlite"


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ("answers SET response_ms = 'fast'", "answers, row 1: response_ms is 'fast'; allowed: 0"),
        ("answers SET response_ms = 9e999", "answers, row 1: response_ms is inf; allowed: 0 to"),
        ("answers SET response_ms = -1.0", r"answers, row 1: response_ms is -1\.0; allowed: 0 to"),
        ("answers SET seq = -5", "answers, row -5: seq is -5; allowed: a whole number, 0 to"),
        ("answers SET simulated = 2", "answers, row 1: simulated is 2; allowed: 0 or 1"),
        ("answers SET kind = 'rest'", "answers, row 1: kind is 'rest'; allowed: training, pair"),
        ("answers SET chosen = 'up'", "answers, row 1: chosen is 'up'; allowed: left, right, tie"),
        ("answers SET flags = x'ff00fe'", "answers, row 1: flags is .*; allowed: a JSON object"),
        ('answers SET flags = \'{"away":1,"away":2}\'', "flags is .*; allowed: a JSON object"),
        ("answers SET flags = '[]'", r"answers, row 1: flags is '\[\]'; allowed: a JSON object"),
        ("answers SET left = cast(x'ff41' AS text)", "row 1: left is .*, which is no text; allow"),
        ("answers SET trial = 2147483648", "answers, row 1: trial is 2147483648; allowed: a whole"),
        ("answers SET received_at = '2026-02-31'", "row 1: received_at is '2026-02-31'; allowed"),
        ("sessions SET started_at = 'yesterday'", "sessions, row 1: started_at is 'yesterday'"),
        ("sessions SET started_at = '2026-03-01T09:30:00.000000+'", "row 1: started_at is '2026"),
        ("sessions SET number = 'abc'", "sessions, row 1: number is 'abc'; allowed: a whole"),
        ("sessions SET plan = '{}'", "sessions, row 1: plan is '{}'; allowed: a JSON list of tri"),
        ("sessions SET plan = '[['", r"sessions, row 1: plan is '\[\['; allowed: a JSON list of"),
        ('sessions SET plan = \'[{"number":"a"}]\'', "sessions, row 1: plan is .*; allowed: a J"),
        ("sessions SET groups = '[1,2]'", r"sessions, row 1: groups is '\[1,2\]'; allowed: a JSON"),
        ("sessions SET groups = '{\"a\":1}'", "sessions, row 1: groups is .*; allowed: a JSON obj"),
        ("sessions SET parameters = 'soup'", "sessions, row 1: parameters is 'soup'; allowed: a"),
        ("sessions SET excluded_reason = cast(x'ff41' AS text)", "row 1: excluded_reason is .*no"),
        ("sessions SET completion_code = hex(zeroblob(99))", "row 1: completion_code is '0000"),
        ("studies SET state = 'shut'", "studies, row 1: state is 'shut'; allowed: open, paused, c"),
        ("studies SET registration = 'all'", "studies, row 1: registration is 'all'; allowed: op"),
        ("screens SET content = '3'", "screens, row 1: content is '3'; allowed: a JSON object"),
        ("audit SET detail = 'null'", "audit, row 1: detail is 'null'; allowed: a JSON object"),
        ("audit SET at = 7", "audit, row 1: at is 7|audit, row 1: at is '7'; allowed: a time"),
        ("invitations SET made_at = ''", "invitations, row 1: made_at is ''; allowed: a time"),
        ("accounts SET password = 'nacre'", "accounts, row 1: password is 'nacre'; allowed: a ha"),
        ("accounts SET password = replace(password, 'm=19456', 'm=19456000')", "row 1: password"),
    ],
)
def test_a_value_that_no_store_holds_is_refused_by_table_row_and_column(
    whole: Path, tmp_path: Path, change: str, said: str
) -> None:
    copy, place = tmp_path / "copy.sqlite", tmp_path / "new.sqlite"
    copy.write_bytes(whole.read_bytes())
    with closing(sqlite3.connect(copy)) as connection:
        connection.execute(f"UPDATE {change}")
        connection.commit()
    with pytest.raises(InputError, match=said) as caught:
        restore(copy, place)
    assert str(caught.value).startswith(f"{copy}: ")
    assert "\n" not in str(caught.value)
    assert not place.exists()


def test_what_a_store_holds_is_restored_whole(whole: Path, tmp_path: Path) -> None:
    with Store.open(tmp_path / "erased.sqlite") as store:
        store.add_study({"design_hash": STUDY})
        store.set_registration(STUDY, "open", "lab")
        session, _ = store.enter(STUDY, "en", {"sex": "f"})
        store.consent(session.id)
        store.answer(session.id, pair_answer(0, "q", "a", "b", "right"))
        store.erase(session.id, "lab")
    backup(tmp_path / "erased.sqlite", tmp_path / "copy.sqlite")
    for given, people in ((whole, 1), (tmp_path / "copy.sqlite", 1)):
        found = restore(given, tmp_path / f"new-{given.stem}.sqlite")
        assert (found.sessions, found.answers) == (people, 1)


def test_answers_with_far_numbers_are_exported_at_once(whole: Path, tmp_path: Path) -> None:
    copy = tmp_path / "far.sqlite"
    copy.write_bytes(whole.read_bytes())
    with closing(sqlite3.connect(copy)) as far:
        far.execute(
            "INSERT INTO answers SELECT 9007199254740991, study, session, 1, kind, question, "
            "left, right, chosen, response_ms, shown_at, answered_at, received_at, flags, "
            "simulated, digest, erased_as, excluded_reason FROM answers"
        )
        far.commit()
    restore(copy, tmp_path / "new.sqlite")
    with Store.open(tmp_path / "new.sqlite") as store:
        found = [seq for part in store.parts(STUDY, ("seq",)) for seq in part["seq"]]
    assert found == [1, 9007199254740991]


@pytest.fixture(scope="module")
def gathered(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A backup of a whole study's answers."""
    folder = tmp_path_factory.mktemp("gathered")
    asked = {"en": "Sex?", "ja": "性別"}
    sex = {"name": "sex", "how": "recorded", "question": asked, "values": ["f", "m"]}
    frozen = frozen_study(folder, "abc", groups=[sex])
    with Store.open(frozen.folder) as store:
        running = opened(store, frozen)
        scale = {"a": 0.5, "b": 0.0, "c": -0.5}
        for _ in range(2):
            take_part(running, by_scale(scale, np.random.default_rng(1)), {"sex": "f"})
    backup(frozen.folder, folder / "whole.sqlite")
    restore(folder / "whole.sqlite", folder / "same.sqlite")
    return folder / "whole.sqlite"


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ("answers SET left = 'z' WHERE seq = 3", 'answers, row 3: left is "z"; allowed: a stim'),
        (
            "answers SET right = char(27) || 'c' WHERE seq = 2",
            r'row 2: right is "\\u001bc"; allowe',
        ),
        ("answers SET question = 'nope'", 'answers, row 1: question is "nope"; allowed: a questi'),
        ('sessions SET groups = \'{"sex":"x"}\'', 'of person 0: group "sex" is "x"; allowed: a'),
        ('sessions SET groups = \'{"dog":"f"}\'', 'of person 0: group "dog" is "f"; allowed: a'),
        (
            "answers SET chosen = 'tie' WHERE seq = 2",
            "row 2: chosen is 'tie'; allowed in this study",
        ),
        ("answers SET kind = 'pair' WHERE seq = 1", 'row 1: kind is "pair"; allowed: "training"'),
        ("answers SET left = right, right = left WHERE seq = 4", "row 4: left is .*as in trial 3"),
        ("answers SET trial = 99 WHERE seq = 3", "row 3: trial is 99; allowed: 0 to 5, for the pl"),
        ("answers SET trial = NULL WHERE seq = 3", "row 3: trial is empty; allowed: 0 to 5, for"),
        ("answers SET session = NULL WHERE seq = 3", "row 3: session, trial and erased_as are not"),
        (
            "sessions SET plan = '[]'",
            "row 1: trial is 0; allowed: none, for the plan of person 0 h",
        ),
        ("sessions SET plan = '[{}]'", "sessions, plan of person 0, trial 0: has no question; wan"),
        (
            "sessions SET plan = replace(plan, '\"number\":2', '\"number\":7')",
            "plan of person 0, trial 2: number is 7; allowed: 2, its place",
        ),
        (
            "sessions SET plan = replace(plan, '\"a\"', '\"z\"')",
            r'plan of person 0, trial \d: \w+ is "z"; allowed: a stimulus of the study',
        ),
        ("sessions SET language = 'xx'", 'of person 0: language is "xx"; allowed: a language of'),
        ('sessions SET parameters = \'{"PID":"5"}\'', 'person 0: parameters name "PID"; allowed'),
        ("studies SET next_number = 1", "next_number is 1; allowed: 2 or more, for there is a per"),
    ],
)
def test_what_no_study_of_the_backup_has_is_refused(
    gathered: Path, tmp_path: Path, change: str, said: str
) -> None:
    copy = tmp_path / "copy.sqlite"
    copy.write_bytes(gathered.read_bytes())
    with closing(sqlite3.connect(copy)) as connection:
        connection.execute(f"UPDATE {change}")
        connection.commit()
    with pytest.raises(InputError, match=said):
        restore(copy, tmp_path / "new.sqlite")
    assert not (tmp_path / "new.sqlite").exists()


def test_a_backup_replaces_an_earlier_one_and_no_other_store(
    whole: Path, gathered: Path, tmp_path: Path
) -> None:
    store, other = tmp_path / "store.sqlite", tmp_path / "other.sqlite"
    restore(whole, store)
    restore(gathered, other)
    backup(store, tmp_path / "copy.sqlite")
    backup(store, tmp_path / "copy.sqlite")
    with pytest.raises(InputError, match="which is not in this store; wanted: a new file, or an"):
        backup(store, other)
    frozen = gathered.parent / "study"
    with pytest.raises(InputError, match="is the store of a frozen study; wanted: another place"):
        backup(store, frozen / "answers.sqlite")
    with closing(sqlite3.connect(other)) as connection:
        assert connection.execute("SELECT count(*) FROM answers").fetchone()[0] > 2
