"""Who may enter, by invitation or without, on SQLite and on PostgreSQL."""

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from datetime import UTC, datetime
from pathlib import Path

import pytest

from nacreous.problem import InputError
from nacreous.study.store import Answer, Conflict, NotAllowed, OutOfTurn, Store, UnknownToken
from nacreous.study.store.tokens import draw
from tests.support.pairs import pair_answer

STUDY = "5e" * 32
AT = datetime(2026, 3, 1, 9, 30, 17, tzinfo=UTC)


@pytest.fixture
def store(place: str) -> Iterator[Store]:
    with Store.open(place, clock=lambda: AT) as made:
        made.add_study({"design_hash": STUDY})
        yield made


def answer(trial: int, chosen: str = "left") -> Answer:
    return pair_answer(trial, "q", "a", "b", chosen)


def test_at_first_only_who_is_invited_may_enter(store: Store) -> None:
    assert store.registration(STUDY) == "invited"
    for token in (None, draw()):
        with pytest.raises(NotAllowed, match="is for invited people only; wanted: an invitation"):
            store.enter(STUDY, "en", {}, token)
    [invited] = store.invite(STUDY, 1, "seat 3", "lab")
    session, token = store.enter(STUDY, "en", {}, invited)
    assert (session.number, token) == (0, invited)
    assert store.session_of(invited).id == session.id


def test_registration_opens_and_closes(store: Store) -> None:
    store.set_registration(STUDY, "open", "lab")
    store.set_registration(STUDY, "open", "lab")
    assert store.registration(STUDY) == "open"
    assert store.enter(STUDY, "en", {})[0].number == 0
    store.set_registration(STUDY, "invited", "lab")
    with pytest.raises(NotAllowed):
        store.enter(STUDY, "en", {})
    told = [event.what for event in store.events(STUDY)]
    assert told == ["study added", "registration open", "entered", "registration invited"]
    with pytest.raises(InputError, match="registration is 'all'; allowed: open, invited"):
        store.set_registration(STUDY, "all", "lab")
    with pytest.raises(InputError, match="is not in this store"):
        store.registration("00" * 32)


def test_the_same_token_again_gives_the_same_session_whatever_happened(store: Store) -> None:
    [token] = store.invite(STUDY, 1, "seat 3", "lab")
    first, _ = store.enter(STUDY, "en", {"sex": "f"}, token)
    store.close_study(STUDY, "lab")
    store.consent(first.id)
    again, _ = store.enter(STUDY, "ja", {"sex": "m"}, token)
    assert (again.id, again.number, again.language) == (first.id, 0, "en")
    assert again.groups == {"sex": "f"}
    assert len(store.sessions(STUDY)) == 1


def test_a_token_given_many_times_at_once_enters_once(place: str) -> None:
    with Store.open(place) as one, Store.open(place) as two:
        one.add_study({"design_hash": STUDY})
        one.set_registration(STUDY, "open", "lab")
        drawn = [draw() for _ in range(10)]

        def enter(place: int) -> tuple[str, str]:
            store = (one, two)[place // 10 % 2]
            session, token = store.enter(STUDY, "en", {}, drawn[place % 10])
            return token, session.id

        with ThreadPoolExecutor(16) as pool:
            entered = set(pool.map(enter, range(80)))
        assert len(entered) == 10
        assert sorted(session.number for session in one.sessions(STUDY)) == list(range(10))


def test_a_weak_token_is_nobodys(store: Store) -> None:
    store.set_registration(STUDY, "open", "lab")
    for weak in ("", "1", "x" * 42, "x" * 44, "é" * 43, "x" * 42 + "\n", 7):
        with pytest.raises(UnknownToken):
            store.enter(STUDY, "en", {}, weak)
    assert store.sessions(STUDY) == []


def test_invitations_say_who_used_them_and_never_their_tokens(store: Store) -> None:
    tokens = store.invite(STUDY, 3, "真珠 class", "lab")
    assert len(set(tokens)) == 3
    store.enter(STUDY, "en", {}, tokens[1])
    found = store.invitations(STUDY)
    assert [(one.label, one.number, one.made_by) for one in found] == [
        ("真珠 class", None, "lab"),
        ("真珠 class", 0, "lab"),
        ("真珠 class", None, "lab"),
    ]
    assert {one.made_at for one in found} == {AT}
    told = [(event.what, event.who, event.detail) for event in store.events(STUDY)]
    assert ("invited", "lab", {"count": 3}) in told


def test_an_invitation_lets_nobody_in_once_it_is_revoked(store: Store) -> None:
    used, unused = store.invite(STUDY, 2, "seat", "lab")
    session, _ = store.enter(STUDY, "en", {}, used)
    one, two = store.invitations(STUDY)
    store.revoke_invitation(two.id, "lab")
    store.revoke_invitation(two.id, "lab")
    store.set_registration(STUDY, "open", "lab")
    with pytest.raises(NotAllowed, match="the invitation was revoked"):
        store.enter(STUDY, "en", {}, unused)
    with pytest.raises(InputError, match=r"invitation \d+ was used by person 0; wanted: one that"):
        store.revoke_invitation(one.id, "lab")
    store.revoke(session.id, "lab")
    with pytest.raises(NotAllowed, match="the invitation was revoked"):
        store.enter(STUDY, "en", {}, used)
    assert store.invitations(STUDY)[1].revoked_at == AT
    assert [event.what for event in store.events(STUDY)].count("invitation revoked") == 1


def test_an_invitation_to_another_study_is_none(store: Store) -> None:
    store.add_study({"design_hash": "7a" * 32})
    [token] = store.invite("7a" * 32, 1, "seat", "lab")
    with pytest.raises(NotAllowed, match="invited people only"):
        store.enter(STUDY, "en", {}, token)
    store.enter("7a" * 32, "en", {}, token)
    with pytest.raises(UnknownToken):
        store.enter(STUDY, "en", {}, token)


def test_what_cannot_be_invited_is_one_line(store: Store) -> None:
    for attempt, told in (
        (
            lambda: store.invite(STUDY, 0, "x", "lab"),
            "count is 0; allowed: a whole number, 1",
        ),
        (
            lambda: store.invite(STUDY, 1001, "x", "lab"),
            "count is 1001; allowed: a whole",
        ),
        (lambda: store.invite(STUDY, 1, "", "lab"), "label is 0 characters long"),
        (lambda: store.invite("00" * 32, 1, "x", "lab"), "is not in this store"),
        (lambda: store.revoke_invitation(99, "lab"), "invitation 99 is not in this store"),
        (lambda: store.revoke_invitation(-1, "lab"), "invitation is -1; allowed"),
    ):
        with pytest.raises(InputError) as caught:
            attempt()
        assert told in str(caught.value)


def test_neither_token_nor_label_is_in_the_file_once_the_person_is_erased(tmp_path: Path) -> None:
    with Store.open(tmp_path) as store:
        store.add_study({"design_hash": STUDY})
        [token] = store.invite(STUDY, 1, "unmistakable", "lab")
        session, _ = store.enter(STUDY, "en", {}, token)
        store.settle(session.id, {}, [{"left": "distinctive"}])
        assert token.encode() not in b"".join(path.read_bytes() for path in tmp_path.iterdir())
        store.erase(session.id, "lab")
        [invitation] = store.invitations(STUDY)
        assert (invitation.label, invitation.number) == ("(erased)", None)
        kept = b"".join(path.read_bytes() for path in tmp_path.iterdir())
    for word in (b"unmistakable", b"distinctive"):
        assert word not in kept


def test_an_erased_persons_invitation_lets_nobody_in(store: Store) -> None:
    [token] = store.invite(STUDY, 1, "seat", "lab")
    session, _ = store.enter(STUDY, "en", {}, token)
    store.settle(session.id, {}, [])
    store.erase(session.id, "lab")
    with pytest.raises(NotAllowed, match="invited people only"):
        store.enter(STUDY, "en", {}, token)
    assert store.plan(session.id) is None
    with pytest.raises(NotAllowed, match="was erased"):
        store.settle(session.id, {}, [])


def test_a_plan_is_settled_once(store: Store) -> None:
    [token] = store.invite(STUDY, 1, "seat", "lab")
    session, _ = store.enter(STUDY, "en", {"sex": "f"}, token)
    assert store.plan(session.id) is None
    plan = [{"number": 0, "left": "真珠", "break_before": False}]
    store.settle(session.id, {"sex": "f", "real-pearl": "shown"}, plan)
    store.settle(session.id, {"sex": "m"}, [])
    assert store.plan(session.id) == plan
    assert store.session(session.id).groups == {"sex": "f", "real-pearl": "shown"}
    for groups, bad in (({}, "text"), ({}, [{1: float("nan")}]), ({"sex": ""}, [])):
        with pytest.raises(InputError):
            store.settle(session.id, groups, bad)
    with pytest.raises(InputError, match="is not in this store"):
        store.plan("nobody")


def test_an_answer_before_its_turn_is_refused(store: Store) -> None:
    [token] = store.invite(STUDY, 1, "seat", "lab")
    session, _ = store.enter(STUDY, "en", {}, token)
    with pytest.raises(NotAllowed, match="has not consented"):
        store.hand_in(session.id, answer(0), in_turn=True).result()
    store.consent(session.id)
    with pytest.raises(OutOfTurn, match="trial is 1 while 0 trials before it are answered"):
        store.hand_in(session.id, answer(1), in_turn=True).result()
    futures = [store.hand_in(session.id, answer(n), in_turn=True) for n in range(20)]
    assert [future.result().trial for future in futures] == list(range(20))
    assert store.hand_in(session.id, answer(7), in_turn=True).result().again
    with pytest.raises(Conflict):
        store.hand_in(session.id, answer(7, "right"), in_turn=True).result()
    assert store.answered(session.id) == 20


def test_who_withdraws_is_left_out_for_good(store: Store) -> None:
    [token] = store.invite(STUDY, 1, "seat", "lab")
    session, _ = store.enter(STUDY, "en", {}, token)
    store.consent(session.id)
    store.answer(session.id, answer(0))
    store.exclude(session.id, "too fast", "lab")
    store.withdraw(session.id)
    store.withdraw(session.id)
    assert store.session(session.id).excluded_reason == "withdrew"
    assert [row["excluded"] for row in store.answers(STUDY)] == ["withdrew"]
    with pytest.raises(NotAllowed, match="the person withdrew"):
        store.readmit(session.id, "lab")
    told = [(event.who, event.what) for event in store.events(STUDY)]
    assert told.count(("participant", "withdrew")) == 1


def test_nobody_writes_over_a_withdrawal_or_makes_one_up(store: Store) -> None:
    [token] = store.invite(STUDY, 1, "seat", "lab")
    session, _ = store.enter(STUDY, "en", {}, token)
    with pytest.raises(InputError, match="reason is 'withdrew'; wanted: another"):
        store.exclude(session.id, "withdrew", "lab")
    store.withdraw(session.id)
    with pytest.raises(NotAllowed, match="the person withdrew"):
        store.exclude(session.id, "too fast", "lab")
    assert store.session(session.id).excluded_reason == "withdrew"
    with pytest.raises(NotAllowed, match="the person withdrew"):
        store.readmit(session.id, "lab")


def test_who_is_revoked_or_withdrew_meanwhile_answers_no_more(store: Store) -> None:
    store.set_registration(STUDY, "open", "lab")
    revoked, _ = store.enter(STUDY, "en", {})
    withdrawn, _ = store.enter(STUDY, "en", {})
    for session in (revoked, withdrawn):
        store.consent(session.id)
        store.hand_in(session.id, answer(0), in_turn=True).result()
    store.revoke(revoked.id, "lab")
    store.withdraw(withdrawn.id)
    with pytest.raises(UnknownToken, match="not revoked"):
        store.hand_in(revoked.id, answer(1), in_turn=True).result()
    with pytest.raises(NotAllowed, match="withdrew"):
        store.hand_in(withdrawn.id, answer(1), in_turn=True).result()
    assert store.progress(STUDY).answers == 2
