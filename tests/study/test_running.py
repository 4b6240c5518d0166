"""A study that runs: nothing but a choice is taken from a client, and a crash changes nothing."""

import shutil
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path

import pytest

from nacreous.problem import InputError
from nacreous.study.design import Frozen, freeze, open_frozen
from nacreous.study.plan import drawn_groups, trials
from nacreous.study.running import Running
from nacreous.study.running.screen_check import ScreenCheck, Window
from nacreous.study.store import (
    Conflict,
    NotAllowed,
    OutOfTurn,
    Response,
    Session,
    Store,
    UnknownToken,
)
from nacreous.study.store.tokens import draw

FILE = """
purpose = "demo"
languages = ["en", "ja"]
display = { size_px = 32, samples = 1 }
questions = [{ id = "deeper", text = { en = "Which looks deeper?", ja = "どちらが深い?" } }]
pairs = { kind = "incomplete", number = 3, repeats = 1 }
sitting = { training = 1, ties = true }
screen = { least_width_px = 800, if_smaller = "refuse" }

[[stimuli]]
label = "a"
pearl = "akoya-r"
[[stimuli]]
label = "b"
pearl = "akoya-g"
[[stimuli]]
label = "c"
pearl = "akoya-rg"
[[stimuli]]
label = "d"
pearl = "akoya-thin"

[[groups]]
name = "real-pearl"
values = ["shown", "not-shown"]
notes = [{ en = "Hold this pearl.", ja = "真珠をお持ちください。" }, {}]
[[groups]]
name = "trade"
values = ["yes", "no"]
how = "recorded"
question = { en = "Do you trade?", ja = "お仕事ですか。" }
"""
WINDOW = {"width_px": 1600, "height_px": 900, "device_pixel_ratio": 2}
GOOD = ScreenCheck(
    window=WINDOW,
    full_screen=True,
    card={"px_per_mm": 4.2},
    distance_mm=620,
    distance_by="blind-spot",
    gamma=2.2,
    darkest_step=5,
    gamut="srgb",
)
SMALL = GOOD.model_copy(update={"window": Window(width_px=700, height_px=900)})
HERE = {"trade": "yes"}


@pytest.fixture(scope="module")
def frozen(tmp_path_factory: pytest.TempPathFactory) -> Frozen:
    folder = tmp_path_factory.mktemp("study")
    (folder / "my.toml").write_text(FILE, encoding="utf-8")
    return freeze(folder / "my.toml", folder / "my-study")


@pytest.fixture
def running(place: str, frozen: Frozen) -> Iterator[Running]:
    with Store.open(place) as store:
        made = Running(store, frozen)
        store.set_registration(made.study, "open", "lab")
        yield made


def ready(running: Running, check: ScreenCheck = GOOD) -> tuple[Session, str]:
    """Somebody who entered, consented, and whose screen was checked."""
    token = draw()
    session = running.enter(token, "en", HERE)
    running.store.consent(session.id)
    running.screen(running.session_of(token), check)
    return running.session_of(token), token


def test_who_enters_gets_groups_and_a_plan_that_stay(running: Running, frozen: Frozen) -> None:
    sessions = [running.enter(draw(), "ja", HERE) for _ in range(4)]
    for session in sessions:
        drawn = drawn_groups(frozen.design, session.number)
        assert session.groups == {**HERE, **drawn}
        assert running.plan(session) == tuple(trials(frozen.design, session.number))
        note = [note.en for note in running.notes(session)]
        assert note == (["Hold this pearl."] if drawn["real-pearl"] == "shown" else [])
    restarted = Running(running.store, frozen)
    assert [restarted.plan(one) for one in sessions] == [running.plan(one) for one in sessions]


def test_a_session_that_a_crash_left_without_a_plan_is_settled(
    running: Running, frozen: Frozen
) -> None:
    tokens = [draw(), draw()]
    for token in tokens:  # the process dies before the plan is settled
        running.store.enter(running.study, "en", HERE, token)
    one = running.enter(tokens[0], "en", HERE)
    two = running.session_of(tokens[1])
    for session in (one, two):
        assert session.groups == {**HERE, **drawn_groups(frozen.design, session.number)}
        assert running.store.plan(session.id) is not None
    assert [one.number, two.number] == [0, 1]


def test_a_plan_that_was_settled_is_kept_whatever_would_be_planned_now(
    running: Running, monkeypatch: pytest.MonkeyPatch, frozen: Frozen
) -> None:
    session, token = ready(running)
    before = running.plan(session)
    monkeypatch.setattr("nacreous.study.running.running.trials", lambda *_: [])
    later = Running(running.store, frozen)
    assert later.plan(later.session_of(token)) == before


def test_what_is_asked_stands_in_the_plan_and_not_in_the_request(running: Running) -> None:
    session, _ = ready(running)
    plan = running.plan(session)
    at = datetime(2026, 3, 1, tzinfo=UTC)
    for trial in plan:
        chosen = ("left", "right", "tie")[trial.number % 3]
        response = Response(chosen, 812.5, at, at, {"tab": "hidden"})
        running.hand_in(session, trial.number, response).result()
    rows = running.store.answers(running.study)
    names = ("trial", "question", "left", "right", "kind")
    assert [tuple(row[name] for name in names) for row in rows] == [
        (one.number, one.question, *one.stimuli, one.kind) for one in plan
    ]
    assert rows[0]["response_ms"] == 812.5
    assert not rows[0]["simulated"]
    assert running.answered(session) == len(plan)


def test_answers_come_in_turn_and_once(running: Running) -> None:
    session, _ = ready(running)
    with pytest.raises(OutOfTurn):
        running.hand_in(session, 1, Response("left")).result()
    assert not running.hand_in(session, 0, Response("left")).result().again
    assert running.hand_in(session, 0, Response("left")).result().again
    with pytest.raises(Conflict):
        running.hand_in(session, 0, Response("right")).result()
    count = len(running.plan(session))
    for trial in (-1, count, True, "0", None, 1.0):
        with pytest.raises(
            InputError, match=f"trial is .*; allowed: a whole number, 0 to {count - 1}"
        ):
            running.hand_in(session, trial, Response("left"))
    for chosen in ("middle", None, ["left"]):
        with pytest.raises(InputError, match="chosen is"):
            running.hand_in(session, 1, Response(chosen))


def test_a_tie_only_where_the_study_has_it(
    running: Running, frozen: Frozen, monkeypatch: pytest.MonkeyPatch
) -> None:
    session, _ = ready(running)
    sitting = frozen.design.sitting.replace(ties=False)
    strict = frozen.design.replace(sitting=sitting)
    without = Frozen(frozen.folder, strict, "", frozen.study_hash, frozen.stimuli)
    with pytest.raises(InputError, match="chosen is 'tie'; allowed in this study: left, right"):
        Running(running.store, without).hand_in(session, 0, Response("tie"))
    running.hand_in(session, 0, Response("tie")).result()


def test_the_end_comes_after_the_last_answer(running: Running) -> None:
    session, token = ready(running)
    plan = running.plan(session)
    for trial in plan[:-1]:
        running.hand_in(session, trial.number, Response("left")).result()
    with pytest.raises(OutOfTurn, match=f"{len(plan) - 1} trials are answered; wanted: all"):
        running.finish(session)
    assert running.session_of(token).finished_at is None
    running.hand_in(session, len(plan) - 1, Response("left")).result()
    assert running.session_of(token).finished_at is not None
    running.finish(session)


def test_pictures_are_due_once_consented_and_never_to_others(
    running: Running, frozen: Frozen
) -> None:
    token = draw()
    session = running.enter(token, "en", HERE)
    assert running.due(session) == frozenset()
    running.store.consent(session.id)
    session = running.session_of(token)
    assert running.due(session) == frozenset(), "the study refuses screens, and none is checked"
    running.screen(session, GOOD)
    session = running.session_of(token)
    shown = {label for trial in running.plan(session) for label in trial.stimuli}
    assert running.due(session) == {one.sha256 for one in frozen.stimuli if one.label in shown}
    running.store.withdraw(session.id)
    assert running.due(running.session_of(token)) == frozenset()


def test_nothing_is_taken_without_consent_or_after_withdrawing(running: Running) -> None:
    token = draw()
    session = running.enter(token, "en", HERE)
    for act in (
        lambda: running.screen(session, GOOD),
        lambda: running.hand_in(session, 0, Response("left")),
    ):
        with pytest.raises(NotAllowed, match="consent is missing"):
            act()
    session, token = ready(running)
    running.store.withdraw(session.id)
    session = running.session_of(token)
    for act in (
        lambda: running.screen(session, GOOD),
        lambda: running.hand_in(session, 0, Response("left")),
    ):
        with pytest.raises(NotAllowed, match="withdrew"):
            act()


def test_a_screen_that_is_refused_may_be_mended_and_the_last_check_counts(running: Running) -> None:
    session, token = ready(running, SMALL)
    assert running.refused(session)
    assert running.screen_flags(session) == ("small-window",)
    with pytest.raises(NotAllowed, match=r"the screen is refused \(small-window\)"):
        running.hand_in(session, 0, Response("left"))
    assert running.screen(session, GOOD) == ()
    session = running.session_of(token)
    assert session.screen == {**GOOD.model_dump(exclude_unset=True), "flags": []}
    running.hand_in(session, 0, Response("left")).result()
    running.screen(session, SMALL)
    with pytest.raises(NotAllowed):
        running.hand_in(running.session_of(token), 1, Response("left"))


def test_a_study_that_refuses_screens_wants_a_check(running: Running) -> None:
    token = draw()
    session = running.enter(token, "en", HERE)
    running.store.consent(session.id)
    with pytest.raises(NotAllowed, match="the screen check is missing"):
        running.hand_in(running.session_of(token), 0, Response("left"))


@pytest.mark.parametrize(
    ("language", "recorded", "told"),
    [
        ("fr", HERE, "language is 'fr'; allowed: en, ja"),
        (None, HERE, "language is None; allowed"),
        ("en", {}, "group trade is missing; allowed: yes, no"),
        ("en", {"trade": "maybe"}, "group trade is 'maybe'; allowed: yes, no"),
        ("en", {"trade": None}, "group trade is None; allowed: yes, no"),
        ("en", {"trade": ["yes"]}, "group trade is .*; allowed: yes, no"),
        ("en", {**HERE, "real-pearl": "shown"}, "group 'real-pearl' is not asked for; allowed"),
        ("en", {**HERE, "x" * 999: "y"}, "is not asked for; allowed: trade"),
    ],
)
def test_who_says_something_else_does_not_enter(
    running: Running, language: str, recorded: dict[str, str], told: str
) -> None:
    with pytest.raises(InputError, match=told) as caught:
        running.enter(draw(), language, recorded)
    assert "\n" not in str(caught.value)
    assert running.store.sessions(running.study) == []


def test_a_token_of_another_study_is_none_here(
    running: Running, frozen: Frozen, tmp_path: Path
) -> None:
    other = running.store.add_study({"design_hash": "7a" * 32})
    running.store.set_registration(other, "open", "lab")
    _, token = running.store.enter(other, "en", {})
    with pytest.raises(UnknownToken):
        running.session_of(token)


def test_an_erased_person_has_no_plan_any_more(running: Running) -> None:
    session, token = ready(running)
    assert running.plan(session)
    running.store.erase(session.id, "lab")
    with pytest.raises(UnknownToken):
        running.session_of(token)
    erased = running.store.session(session.id)
    assert running.plan(erased) == ()
    assert running.due(erased) == frozenset()
    assert running.notes(erased) == ()


def test_the_folder_may_move(running: Running, frozen: Frozen, tmp_path: Path) -> None:
    shutil.copytree(frozen.folder, tmp_path / "moved")
    moved = Running(running.store, open_frozen(tmp_path / "moved"))
    assert moved.study == running.study == frozen.study_hash
