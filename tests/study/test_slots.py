"""Slots of the plan: those who finish fill them without a hole, whoever drops out."""

import random
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from datetime import UTC, datetime, timedelta

import pytest

from nacreous.server.service import Service
from nacreous.study.design import Design
from nacreous.study.plan import drawn_groups
from nacreous.study.running import Running
from nacreous.study.store import Response, Session, Store
from nacreous.study.store.tokens import draw
from tests.support.pairs import pair_answer

STUDY = "5e" * 32


class Clock:
    """The server's clock, put forward by hand."""

    def __init__(self) -> None:
        self.now = datetime(2026, 3, 1, 9, tzinfo=UTC)

    def __call__(self) -> datetime:
        return self.now

    def pass_hours(self, hours: float) -> None:
        self.now += timedelta(hours=hours)


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def store(place: str, clock: Clock):
    with Store.open(place, clock=clock) as made:
        made.add_study({"design_hash": STUDY})
        made.set_registration(STUDY, "open", "lab")
        yield made


def enter(store: Store) -> Session:
    session, _ = store.enter(STUDY, "en", {})
    store.consent(session.id)
    return session


def answer(store: Store, session: Session, trial: int, simulated: bool = False) -> None:
    store.answer(session.id, pair_answer(trial, "q", "a", "b", "left", simulated=simulated))


def test_drop_outs_leave_no_hole_among_those_who_finish(store: Store, clock: Clock) -> None:
    design = Design.load("paper")
    lots = random.Random(1)
    finished = []
    while len(finished) < 40:
        session = enter(store)
        clock.pass_hours(0.7)
        # Whoever holds a real pearl leaves more often: balance over entering would be lost.
        leaves = drawn_groups(design, session.slot)["real-pearl"] == "shown"
        if lots.random() < (0.7 if leaves else 0.1):
            continue
        store.finish(session.id)
        finished.append(session.slot)
    clock.pass_hours(2)
    while (session := enter(store)).slot < max(finished):  # whoever is missing at the end
        store.finish(session.id)
        finished.append(session.slot)
    assert sorted(finished) == list(range(len(finished)))
    groups = Counter(drawn_groups(design, slot)["real-pearl"] for slot in finished)
    assert abs(groups["shown"] - groups["not-shown"]) <= 2


def test_a_slot_is_kept_while_somebody_goes_on_and_given_again_after(
    store: Store, clock: Clock
) -> None:
    first, second = enter(store), enter(store)
    assert (first.slot, second.slot) == (0, 1)
    clock.pass_hours(0.9)
    answer(store, first, 0)
    clock.pass_hours(0.9)
    assert enter(store).slot == 1  # `second` is away for 1.8 h, `first` for 0.9
    assert store.session(second.id).slot == 1  # and keeps what was given
    answer(store, second, 0)
    clock.pass_hours(0.2)
    assert enter(store).slot == 0
    store.finish(first.id)
    clock.pass_hours(100)
    assert enter(store).slot == 1


def test_how_long_a_slot_is_kept_is_what_the_study_says(store: Store, clock: Clock) -> None:
    enter(store)
    clock.pass_hours(5)
    assert store.enter(STUDY, "en", {}, idle_hours=6)[0].slot == 1
    assert store.enter(STUDY, "en", {}, idle_hours=4)[0].slot == 0


def test_the_slots_of_who_is_left_out_are_given_again(store: Store) -> None:
    excluded, withdrawn, erased, _ = (enter(store) for _ in range(4))
    for session in (excluded, withdrawn, erased):
        store.finish(session.id)
    store.exclude(excluded.id, "slept", "lab")
    store.withdraw(withdrawn.id)
    store.erase(erased.id, "lab")
    assert [enter(store).slot for _ in range(4)] == [0, 1, 2, 4]
    store.readmit(excluded.id, "lab")
    assert store.session(excluded.id).slot == 0
    assert store.session(erased.id).slot is None


def test_a_slot_is_given_once_however_many_enter_at_the_same_moment(
    place: str, store: Store, clock: Clock
) -> None:
    first = [enter(store) for _ in range(6)]
    for session in first[::2]:
        store.exclude(session.id, "slept", "lab")
    with Store.open(place, clock=clock) as another, ThreadPoolExecutor(12) as pool:
        stores = [store, another] * 6
        given = list(pool.map(lambda one: one.enter(STUDY, "en", {})[0].slot, stores))
    assert sorted(given) == [0, 2, 4, *range(6, 15)]


def test_the_same_token_keeps_its_slot(store: Store) -> None:
    token = draw()
    first, _ = store.enter(STUDY, "en", {}, token)
    store.exclude(enter(store).id, "slept", "lab")
    again, _ = store.enter(STUDY, "ja", {}, token)
    assert (again.id, again.slot) == (first.id, first.slot)


def test_simulated_observers_fill_slots_until_people_answer(store: Store) -> None:
    rehearsed = [enter(store) for _ in range(3)]
    for session in rehearsed:
        answer(store, session, 0, simulated=True)
    person = enter(store)
    assert [one.slot for one in (*rehearsed, person)] == [0, 1, 2, 3]
    answer(store, person, 0)
    assert [enter(store).slot for _ in range(4)] == [0, 1, 2, 4]


def go_through(running: Running, token: str) -> Session:
    """Consent and answer all, and close the page without a farewell."""
    running.store.consent(running.session_of(token).id)
    session = running.session_of(token)
    for trial in running.plan(session):
        assert session.finished_at is None
        running.hand_in(session, trial.number, Response("left")).result()
        session = running.session_of(token)
    return session


def test_whoever_comes_for_a_drop_out_sees_what_the_drop_out_would_have(service: Service) -> None:
    running = service.running
    gone = running.enter(draw(), "en", {"trade": "yes"})
    gone_plan = running.plan(gone)
    running.store.exclude(gone.id, "left", "lab")
    come = running.enter(draw(), "en", {"trade": "yes"})
    assert (come.number, come.slot) == (1, gone.slot)
    assert running.plan(come) == gone_plan
    assert come.groups == gone.groups


def test_who_has_answered_all_has_finished_though_the_page_closes(service: Service) -> None:
    running, token = service.running, draw()
    running.enter(token, "en", {"trade": "yes"})
    session = go_through(running, token)
    last = running.store.answers(running.study)[-1]
    assert session.finished_at == datetime.fromisoformat(last["received_at"])
    running.finish(session)  # the farewell, late, changes nothing
    assert running.session_of(token).finished_at == session.finished_at
    told = [event.what for event in running.store.events(running.study)]
    assert told.count("finished") == 1
