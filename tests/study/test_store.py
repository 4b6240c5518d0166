"""What a store keeps, on SQLite and on PostgreSQL."""

import asyncio
import threading
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta

import numpy as np
import pytest
import sqlalchemy as sa

from nacreous.problem import InputError
from nacreous.study.store import Answer, Receipt, Session, Store
from tests.support.pairs import pair_answer

MANIFEST = {"nacreous_study": 1, "design_hash": "5e" * 32, "design": {"name": "Perlen 真珠"}}
STUDY = MANIFEST["design_hash"]


@pytest.fixture
def store(place: str) -> Iterator[Store]:
    with Store.open(place) as made:
        made.add_study(MANIFEST)
        made.set_registration(STUDY, "open", "lab")
        yield made


def entered(store: Store, **groups: str) -> Session:
    session, _ = store.enter(STUDY, "ja", groups)
    store.consent(session.id)
    return session


def answer(trial: int = 0, chosen: str = "left", **more) -> Answer:
    return pair_answer(trial, "deeper", "a", "b", chosen, **more)


def test_what_is_stored_is_what_was_given(store: Store) -> None:
    session = entered(store, seen="real", 性別="女")
    at = datetime(2026, 3, 1, 9, 30, 0, 123456, tzinfo=UTC)
    given = answer(3, "tie", response_ms=812.25, shown_at=at, flags={"tab": "hidden", "n": 2})
    store.answer(session.id, given)
    [row] = store.answers(STUDY)
    assert {name: row[name] for name in given.row} == given.row
    assert row["shown_at"] == "2026-03-01T09:30:00.123456Z"
    assert (row["number"], row["language"], row["session"]) == (0, "ja", session.id)
    assert store.session(session.id).groups == {"seen": "real", "性別": "女"}
    assert store.manifest(STUDY) == MANIFEST


def test_the_same_answer_again_is_acknowledged_and_not_stored_again(store: Store) -> None:
    session = entered(store)
    first = store.answer(session.id, answer(flags={"a": 1, "b": 2}))
    again = store.answer(session.id, answer(flags={"b": 2, "a": 1}))
    assert (first.again, again.again) == (False, True)
    assert again.received_at == first.received_at
    assert len(store.answers(STUDY)) == 1


def test_another_answer_to_the_same_trial_is_refused_and_kept_in_the_log(store: Store) -> None:
    session = entered(store)
    store.answer(session.id, answer(chosen="left"))
    with pytest.raises(InputError, match=r"trial 0 of session .* is answered already"):
        store.answer(session.id, answer(chosen="right"))
    [row] = store.answers(STUDY)
    assert row["chosen"] == "left"
    [refused] = [event for event in store.events(STUDY) if event.what == "answer refused"]
    assert refused.session == session.id
    assert refused.detail["answer"]["chosen"] == "right"


def test_one_that_is_refused_spoils_none_beside_it(store: Store) -> None:
    session = entered(store)
    store.answer(session.id, answer(7))
    futures = [store.hand_in(session.id, answer(n, "right")) for n in range(20)]
    failed = [n for n, future in enumerate(futures) if future.exception() is not None]
    assert failed == [7]
    assert sorted(row["trial"] for row in store.answers(STUDY)) == list(range(20))


def test_answers_that_wait_go_to_the_disk_together(store: Store) -> None:
    session = entered(store)
    commits = []
    sa.event.listen(store.engine, "commit", commits.append)
    futures = [store.hand_in(session.id, answer(n)) for n in range(400)]
    assert not any(future.result().again for future in futures)
    assert 1 <= len(commits) < 100


def test_an_event_loop_waits_without_a_thread(store: Store) -> None:
    session = entered(store)

    async def give() -> list[Receipt]:
        given = (asyncio.wrap_future(store.hand_in(session.id, answer(n))) for n in range(50))
        return await asyncio.gather(*given)

    assert [receipt.trial for receipt in asyncio.run(give())] == list(range(50))


def test_numbers_are_given_once_each_from_many_threads(store: Store) -> None:
    numbers: list[int] = []

    def enter() -> None:
        for _ in range(10):
            numbers.append(store.enter(STUDY, "en", {})[0].number)

    threads = [threading.Thread(target=enter) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(numbers) == list(range(80))


def test_a_token_opens_its_own_session_until_it_is_revoked(store: Store) -> None:
    session, token = store.enter(STUDY, "en", {})
    other, other_token = store.enter(STUDY, "en", {})
    assert len(token) >= 43
    assert store.session_of(token).id == session.id
    assert store.session_of(other_token).id == other.id
    store.revoke(session.id, "lab")
    for unknown in (token, "", "x" * 500, "é", "' OR 1=1 --", None):
        with pytest.raises(InputError, match="token is unknown"):
            store.session_of(unknown)


def test_a_token_itself_is_kept_nowhere(tmp_path) -> None:
    with Store.open(tmp_path) as store:
        store.add_study(MANIFEST)
        store.set_registration(STUDY, "open", "lab")
        _, token = store.enter(STUDY, "en", {})
    kept = b"".join(path.read_bytes() for path in tmp_path.iterdir())
    assert token.encode() not in kept


def test_a_clock_that_jumps_is_believed_and_orders_nothing(place: str) -> None:
    start = datetime(2026, 3, 1, tzinfo=UTC)
    told = [start] * 4 + [start + timedelta(hours=1), start - timedelta(days=400), start]
    hours = iter(told)
    with Store.open(place, clock=lambda: next(hours)) as store:
        store.add_study(MANIFEST)
        store.set_registration(STUDY, "open", "lab")
        session = entered(store)
        receipts = [store.answer(session.id, answer(n)) for n in range(3)]
        rows = store.answers(STUDY)
    assert [receipt.received_at for receipt in receipts] == told[4:]
    assert [row["trial"] for row in rows] == [0, 1, 2]
    assert [row["received_at"][:4] for row in rows] == ["2026", "2025", "2026"]


def test_no_answer_without_consent(store: Store) -> None:
    session, _ = store.enter(STUDY, "en", {})
    with pytest.raises(InputError, match="has not consented"):
        store.answer(session.id, answer())


def test_a_paused_or_closed_study_takes_late_answers_and_no_people(store: Store) -> None:
    session = entered(store)
    for stop, word in ((store.pause, "paused"), (store.close_study, "closed")):
        stop(STUDY, "lab")
        with pytest.raises(InputError, match=f"is {word}; wanted: open"):
            store.enter(STUDY, "en", {})
        assert store.studies() == {STUDY: word}
    store.answer(session.id, answer())
    store.reopen(STUDY, "lab")
    assert entered(store).number == 1


def test_an_excluded_person_stays_with_the_reason(store: Store) -> None:
    session = entered(store)
    store.answer(session.id, answer())
    store.exclude(session.id, "slept", "lab")
    [row] = store.answers(STUDY)
    assert row["excluded"] == "slept"
    assert store.progress(STUDY).excluded == 1
    store.readmit(session.id, "lab")
    assert store.answers(STUDY)[0]["excluded"] is None
    told = [(event.what, event.who) for event in store.events(STUDY)][-2:]
    assert told == [("excluded", "lab"), ("readmitted", "lab")]


def test_a_reason_of_blanks_is_none(store: Store) -> None:
    session = entered(store)
    with pytest.raises(InputError, match=r"reason is ' '; allowed: text"):
        store.exclude(session.id, " ", "lab")
    assert store.sessions(STUDY)[0].excluded_reason is None


def test_numpys_whole_numbers_are_numbers_of_answers_and_invitations(store: Store) -> None:
    session = entered(store)
    store.answer(session.id, answer(np.int64(0)))
    assert len(store.invite(STUDY, np.int64(2), "Monday", "lab")) == 2


def test_progress_counts_who_and_how_far(place: str) -> None:
    start = datetime(2026, 3, 1, tzinfo=UTC)
    seconds = iter(range(1000))
    with Store.open(place, clock=lambda: start + timedelta(seconds=next(seconds))) as store:
        store.add_study(MANIFEST)
        store.set_registration(STUDY, "open", "lab")
        one, two = entered(store), entered(store)
        store.enter(STUDY, "en", {})
        for n in range(4):
            store.answer(one.id, answer(n))
        store.answer(two.id, answer(simulated=True))
        store.finish(one.id)
        found = store.progress(STUDY)
    assert (found.entered, found.consented, found.finished) == (3, 2, 1)
    assert (found.answers, found.simulated, found.state) == (5, 1, "open")
    assert [person.answers for person in found.people] == [4, 1, 0]
    assert found.median_s == 10 - 1 + 1


def test_screen_checks_are_all_kept_and_the_last_one_counts(store: Store) -> None:
    session = entered(store)
    store.screen(session.id, {"mm": 1.0})
    store.screen(session.id, {"mm": 0.25, "gamut": "p3"})
    assert store.session(session.id).screen == {"mm": 0.25, "gamut": "p3"}


@pytest.mark.parametrize(
    ("fields", "told"),
    [
        ({"chosen": "neither"}, "chosen is 7 characters long; allowed: 1 to 5"),
        ({"chosen": ["left"]}, "allowed: text"),
        ({"trial": -1}, "trial is -1; allowed: a whole number"),
        ({"trial": True}, "trial is True"),
        ({"left": ""}, "left is 0 characters long"),
        ({"left": "a\0b"}, "allowed: text without NUL"),
        ({"question": "\ud800"}, "allowed: text without NUL"),
        ({"right": "x" * 2000}, "right is 2000 characters long"),
        ({"response_ms": float("nan")}, "response_ms is nan"),
        ({"response_ms": -1.0}, "response_ms is -1.0"),
        ({"response_ms": 10**400}, "response_ms is 1000"),
        ({"shown_at": datetime(2026, 1, 1)}, "shown_at is .* allowed: a time with its zone"),
        ({"shown_at": datetime.min.replace(tzinfo=UTC) + timedelta(0)}, None),
        ({"flags": {"a": float("inf")}}, "flags is no JSON"),
        ({"flags": {"a": "x" * 70_000}}, "flags is 70008 bytes"),
        ({"flags": [1]}, "flags is .* allowed: a mapping"),
        ({"kind": "trap"}, "kind is 'trap'"),
        ({"simulated": "no"}, "simulated is 'no'; allowed: True, False"),
        ({"simulated": 1}, "simulated is 1; allowed: True, False"),
        ({"simulated": None}, "simulated is None; allowed: True, False"),
        ({"response_ms": "900"}, "response_ms is '900'; allowed: 0 to"),
        ({"response_ms": np.float32("nan")}, "response_ms is "),
        ({"flags": {"a": np.float64("nan")}}, "flags is no JSON"),
        ({"flags": {"a": np.arange(3)}}, "flags is no JSON"),
        ({"flags": {"a": object()}}, "flags is no JSON"),
    ],
)
def test_a_bad_answer_is_one_line(fields: dict, told: str | None) -> None:
    good = {"trial": 0, "question": "q", "left": "a", "right": "b", "chosen": "left"}
    if told is None:
        pair_answer(**{**good, **fields})
        return
    with pytest.raises(InputError, match=told) as caught:
        pair_answer(**{**good, **fields})
    assert "\n" not in str(caught.value)


def test_numbers_and_truth_values_of_numpy_are_stored_as_pythons() -> None:
    plain = pair_answer(
        3, "q", "a", "b", "left", 812.0, flags={"away": 2, "ok": True, "x": 0.5}, simulated=True
    )
    numpy = pair_answer(
        np.int64(3),
        *("q", "a", "b", "left", np.float32(812.0)),
        flags={"away": np.int64(2), "ok": np.bool_(True), "x": np.float32(0.5)},
        simulated=np.bool_(True),
    )
    assert numpy.digest == plain.digest
    assert pair_answer(3, "q", "a", "b", "left", np.int32(812)).row["response_ms"] == 812.0


def test_hostile_text_is_text(store: Store) -> None:
    evil = "'; DROP TABLE answers; -- <script>alert(1)</script> %s :name 😀"
    session, _ = store.enter(STUDY, "en", {evil: evil})
    store.consent(session.id)
    store.answer(session.id, pair_answer(0, evil, evil, evil, "left", flags={evil: evil + "\0"}))
    [row] = store.answers(STUDY)
    assert row["left"] == evil
    assert store.session(session.id).groups == {evil: evil}


def test_what_is_unknown_is_refused(store: Store) -> None:
    for attempt in (
        lambda: store.enter("00" * 32, "en", {}),
        lambda: store.answer("nobody", answer()),
        lambda: store.exclude("nobody", "why", "lab"),
        lambda: store.erase("nobody", "lab"),
        lambda: store.progress("x"),
        lambda: store.manifest("x"),
        lambda: store.add_study({"design_hash": "../etc"}),
        lambda: store.add_study({**MANIFEST, "stimuli": ["others"]}),
        lambda: store.pause("x", "lab"),
    ):
        with pytest.raises(InputError) as caught:
            attempt()
        assert "\n" not in str(caught.value)
    assert store.add_study(MANIFEST) == STUDY


def test_a_study_is_known_by_the_hash_of_all_that_is_frozen(store: Store) -> None:
    sealed = {**MANIFEST, "study_hash": "7a" * 32, "stimuli": [{"label": "真珠", "recipe": None}]}
    assert store.add_study(sealed) == "7a" * 32
    assert store.manifest("7a" * 32) == sealed
    assert store.study("7a") == "7a" * 32
    with pytest.raises(InputError, match=r"has 2 studies; wanted: one of its studies \(5e5e"):
        store.study()


def test_who_reads_sees_one_state_throughout(store: Store) -> None:
    session = entered(store)
    store.answer(session.id, answer(0))
    count = sa.text("SELECT count(*) FROM answers")
    with store.reading() as connection:
        before = connection.execute(count).scalar_one()
        store.answer(session.id, answer(1))
        assert connection.execute(count).scalar_one() == before == 1
    assert len(store.answers(STUDY)) == 2


def test_two_stores_open_the_same_place(place: str) -> None:
    with Store.open(place) as one, Store.open(place) as two:
        one.add_study(MANIFEST)
        one.set_registration(STUDY, "open", "lab")
        session = entered(two)
        one.answer(session.id, answer())
        assert two.answer(session.id, answer()).again


def test_a_closed_store_says_so(place: str) -> None:
    store = Store.open(place)
    store.close()
    with pytest.raises(OSError, match="the store is closed"):
        store.add_study(MANIFEST)
