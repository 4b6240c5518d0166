"""Erasing a person: nothing leads to them any more, and the counts stay true."""

from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from concurrent.futures import TimeoutError as LateError
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path

import pytest
import sqlalchemy as sa

from nacreous.problem import InputError
from nacreous.study.store import NotAllowed, Store, answers, people
from nacreous.study.store.engine import writing
from tests.support.pairs import pair_answer

STUDY = "5e" * 32
AT = datetime(2026, 3, 1, 9, 30, 17, tzinfo=UTC)


def fill(store: Store) -> tuple[str, str, str]:
    """Two people with ten answers each; the first one's session and token, and the other's."""
    store.add_study({"design_hash": STUDY})
    store.set_registration(STUDY, "open", "lab")
    one, token = store.enter(STUDY, "ja", {"sex": "unmistakable"})
    two, _ = store.enter(STUDY, "en", {"sex": "f"})
    for session in (one, two):
        store.consent(session.id)
        store.screen(session.id, {"mm": 0.31415})
        for n in range(10):
            chosen = "left" if n < 7 else "right"
            store.answer(
                session.id,
                pair_answer(n, "q", f"s{n}", "z", chosen, 777.5, AT, AT, flags={"seen": "squint"}),
            )
    with pytest.raises(InputError):
        store.answer(one.id, pair_answer(0, "q", "s0", "z", "right"))
    return one.id, token, two.id


def test_choices_stay_and_nothing_else(place: str) -> None:
    with Store.open(place, clock=lambda: AT) as store:
        one, token, two = fill(store)
        before = {(row["left"], row["chosen"]) for row in store.answers(STUDY, one)}
        store.erase(one, "lab")
        rows = [row for row in store.answers(STUDY) if row["erased_as"]]
        others = store.answers(STUDY, two)
        assert {(row["left"], row["chosen"]) for row in rows} == before
        assert len({row["erased_as"] for row in rows}) == 1
        for row in rows:
            empty = ("session", "trial", "number", "language", "groups", "response_ms", "digest")
            assert [row[name] for name in empty] == [None] * len(empty)
            assert row["flags"] == "{}"
            assert {row[name] for name in ("shown_at", "received_at")} == {"2026-03-01"}
        assert [row["trial"] for row in others] == list(range(10))
        with pytest.raises(InputError, match="token is unknown"):
            store.session_of(token)
        with pytest.raises(InputError, match="was erased"):
            store.answer(one, pair_answer(11, "q", "a", "z", "left"))


def test_the_aggregate_says_how_many_were_erased(place: str) -> None:
    with Store.open(place) as store:
        one, _, _ = fill(store)
        store.exclude(one, "too fast", "lab")
        store.erase(one, "lab")
        store.erase(one, "lab")
        found = store.progress(STUDY)
        assert (found.entered, found.erased, found.answers, found.erased_answers) == (2, 1, 20, 10)
        excluded = [row["excluded"] for row in store.answers(STUDY) if row["erased_as"]]
        assert excluded == ["excluded before erasing"] * 10
        assert store.enter(STUDY, "en", {})[0].number == 2


def test_the_order_of_trials_is_gone(place: str) -> None:
    with Store.open(place) as store:
        orders = set()
        store.add_study({"design_hash": STUDY})
        store.set_registration(STUDY, "open", "lab")
        for _ in range(3):
            session, _ = store.enter(STUDY, "en", {})
            store.consent(session.id)
            for n in range(10):
                store.answer(session.id, pair_answer(n, "q", f"s{n}", "z", "left"))
            store.erase(session.id, "lab")
        rows = store.answers(STUDY)
        for start in (0, 10, 20):
            orders.add(tuple(row["left"] for row in rows[start : start + 10]))
        assert len(orders) > 1


def test_the_log_tells_that_and_not_whom(place: str) -> None:
    with Store.open(place, clock=lambda: AT) as store:
        one, _, _ = fill(store)
        store.exclude(one, "squinted", "lab")
        store.erase(one, "lab")
        about = [event for event in store.events(STUDY) if event.session == one]
        assert [event.what for event in about][-3:] == ["answer refused", "excluded", "erased"]
        assert all(event.detail == {} for event in about)
        assert {event.at for event in about} == {datetime(2026, 3, 1, tzinfo=UTC)}


def test_no_byte_of_it_is_left_in_the_file(tmp_path: Path) -> None:
    with Store.open(tmp_path) as store:
        one, _, two = fill(store)
        store.erase(one, "lab")
        store.erase(two, "lab")
        kept = b"".join(path.read_bytes() for path in tmp_path.iterdir())
    for word in (b"unmistakable", b"0.31415", b"squint"):
        assert word not in kept


@contextmanager
def by_another_program(store: Store) -> Iterator[sa.Connection]:
    """A transaction that is on its way to the disk while the block goes on."""
    with writing(store.engine).connect() as connection, connection.begin():
        yield connection


def waits(future: Future[object]) -> None:
    with pytest.raises(LateError):
        future.result(timeout=0.5)


def test_an_answer_on_its_way_by_another_server_is_unlinked_too(place: str) -> None:
    at = "2026-03-01T09:30:00.000000Z"
    with Store.open(place) as store, ThreadPoolExecutor(1) as elsewhere:
        one, _, _ = fill(store)
        with by_another_program(store) as connection:
            answers.put(connection, at, one, pair_answer(10, "q", "s10", "z", "left"), in_turn=True)
            erased = elsewhere.submit(store.erase, one, "lab")
            waits(erased)
        erased.result()
        assert store.answers(STUDY, one) == []
        assert sum(row["erased_as"] is not None for row in store.answers(STUDY)) == 11


def test_no_answer_comes_after_erasing_by_another_program(place: str) -> None:
    with Store.open(place) as store:
        one, _, _ = fill(store)
        with by_another_program(store) as connection:
            people.erase(connection, "2026-03-01T09:30:00.000000Z", one, "lab")
            late = store.hand_in(one, pair_answer(10, "q", "s10", "z", "left"), in_turn=True)
            waits(late)
        assert isinstance(late.exception(), NotAllowed)
        assert store.answers(STUDY, one) == []
