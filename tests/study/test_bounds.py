"""What one person can make a store keep has an end."""

from collections.abc import Iterator

import pytest

from nacreous.study.store import Answer, Conflict, NotAllowed, Session, Store
from nacreous.study.store.answers import MOST_REFUSED
from nacreous.study.store.people import MOST_SCREENS
from tests.support.pairs import pair_answer

STUDY = "5e" * 32


@pytest.fixture
def store(place: str) -> Iterator[Store]:
    with Store.open(place) as made:
        made.add_study({"nacreous_study": 1, "design_hash": STUDY})
        made.set_registration(STUDY, "open", "lab")
        yield made


def entered(store: Store) -> Session:
    session, _ = store.enter(STUDY, "ja", {})
    store.consent(session.id)
    return session


def answer(chosen: str, **more: float) -> Answer:
    return pair_answer(0, "deeper", "a", "b", chosen, **more)


def test_nobody_fills_the_disk_with_what_is_refused(store: Store) -> None:
    session = entered(store)
    store.answer(session.id, answer("left"))
    futures = [
        store.hand_in(session.id, answer("right", response_ms=n)) for n in range(MOST_REFUSED + 20)
    ]
    assert all(isinstance(future.exception(), Conflict) for future in futures)
    refused = [event for event in store.events(STUDY) if event.what == "answer refused"]
    assert len(refused) == MOST_REFUSED


def test_nobody_fills_the_disk_with_screen_checks(store: Store) -> None:
    session = entered(store)
    for n in range(MOST_SCREENS):
        store.screen(session.id, {"mm": n})
    with pytest.raises(NotAllowed, match=r"checked 100 times; allowed: 100"):
        store.screen(session.id, {"mm": 0.25})
    assert store.session(session.id).screen == {"mm": MOST_SCREENS - 1}


def test_the_end_of_the_log_is_read_without_the_rest(store: Store) -> None:
    for n in range(5):
        store.audit("lab", f"event {n}", STUDY)
    assert [event.what for event in store.events(STUDY, 2)] == ["event 3", "event 4"]
    assert store.events(STUDY, 2) == store.events(STUDY)[-2:]
