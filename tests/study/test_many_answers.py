"""Counting is the database's work: the same counts as row by row, in bounded memory."""

import tracemalloc
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest
import sqlalchemy as sa

from nacreous.study.store import Store, StoreError, answers_of, export
from nacreous.study.store.answers import ROWS
from nacreous.study.store.schema import answers
from nacreous.study.task.counting import counts
from nacreous.study.task.row import person_of
from tests.study.test_export import STUDY, fill
from tests.support.pairs import pair_answer


@pytest.fixture
def store(place: str) -> Iterator[Store]:
    with Store.open(place) as made:
        fill(made)
        yield made


def test_progress_counts_by_the_database_what_counts_row_by_row(store: Store) -> None:
    rows, found = store.answers(STUDY), store.progress(STUDY)
    assert found.answers == len(rows)
    assert found.simulated == sum(row["simulated"] for row in rows)
    assert found.erased_answers == sum(row["erased_as"] is not None for row in rows)
    by_person = Counter(row["number"] for row in rows)
    assert {one.session.number: one.answers for one in found.people} == {
        number: by_person[number] for number in range(5)
    }


@pytest.mark.parametrize("simulated", [False, True])
def test_the_database_finds_the_answers_that_count_row_by_row(
    store: Store, simulated: bool
) -> None:
    rows = [row for row in store.answers(STUDY) if counts(row, simulated=simulated)]
    found = answers_of(store, STUDY, "q", simulated=simulated)
    assert len(found) == len(rows)
    persons = [found.people[person] for person in found.person]
    assert persons == [person_of(row) for row in rows]
    assert found.outcome.tolist() == [{"left": 1, "tie": 0}[row["chosen"]] for row in rows]


def test_parts_are_the_rows_column_by_column(store: Store) -> None:
    rows = store.answers(STUDY)
    names = ("seq", "number", "trial", "simulated", "excluded", "groups", "flags", "response_ms")
    for part in store.parts(STUDY, names):
        for name in names:
            wanted = [row[name] for row in rows[: len(part[name])]]
            assert list(part[name]) == wanted
            assert [type(value) for value in part[name]] == [type(value) for value in wanted]
        del rows[: len(part["seq"])]
    assert not rows


def test_what_the_database_joins_is_what_its_rows_hold(store: Store) -> None:
    odd = {"left": 'a, "b"\n', "right": "'真珠';", "response_ms": 0.1 + 0.2, "flags": '{"x":"\\""}'}
    row = {**pair_answer(0, "q", "a", "b", "left").row, "study": STUDY, "erased_as": "e", **odd}
    blank = {**row, "response_ms": None, "left": "", "right": "NULL"}
    with store.engine.begin() as connection:
        for trial, one in enumerate((row, blank)):
            values = {**one, "trial": trial, "received_at": "2026-03-01T09:30:00.000001Z"}
            connection.execute(sa.insert(answers), values)
        wanted = connection.execute(sa.select(answers).order_by(answers.c.seq)).mappings().all()
    found = [row for part in store.watched(STUDY) for row in part.to_pylist()]
    assert found == [{name: one[name] for name in found[0]} for one in wanted]


def test_a_database_that_fails_while_parts_are_read_is_told_as_any_other(tmp_path: Path) -> None:
    with Store.open(tmp_path / "answers.sqlite") as store:
        with store.engine.begin() as connection:
            connection.execute(sa.text("DROP TABLE answers"))
        with pytest.raises(StoreError, match="the database refuses: no such table"):
            list(store.parts(STUDY, ("seq",)))


def test_progress_looks_at_no_text_of_an_answer(store: Store) -> None:
    asked: list[str] = []
    sa.event.listen(
        store.engine, "before_cursor_execute", lambda _c, _u, statement, *_: asked.append(statement)
    )
    store.progress(STUDY)
    assert any("answers" in statement for statement in asked)
    for name in ("flags", "response_ms", "chosen", "question"):
        assert not any(f"answers.{name}" in statement for statement in asked)


def test_an_export_of_more_answers_takes_no_more_memory(tmp_path: Path) -> None:
    peaks = []
    with Store.open(tmp_path / "answers.sqlite") as store:
        store.add_study({"design_hash": STUDY})
        store.set_registration(STUDY, "open", "lab")
        session = store.enter(STUDY, "en", {})[0].id
        row = {**pair_answer(0, "q", "a", "b", "left").row, "study": STUDY, "session": session}
        for part in range(4):
            trials = range(part * ROWS, (part + 1) * ROWS)
            rows = [
                {**row, "trial": trial, "received_at": f"2026-03-01T09:30:00.{trial:06d}Z"}
                for trial in trials
            ]
            with store.engine.begin() as connection:
                connection.execute(sa.insert(answers), rows)
            del rows
            export(store, STUDY, tmp_path / "warm.csv")
            tracemalloc.start()
            assert export(store, STUDY, tmp_path / f"{part}.csv") == (part + 1) * ROWS
            peaks.append(tracemalloc.get_traced_memory()[1])
            tracemalloc.stop()
    assert peaks[3] < 1.2 * peaks[1]  # one part is read while another is written
