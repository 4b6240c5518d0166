"""Adaptive pairs: chosen at entry from the answers so far, and then as good a plan as any."""

from collections import Counter
from typing import Any

import numpy as np
import pytest

import nacreous as nc
from nacreous.scaling import Comparisons
from nacreous.study.design import Design, Frozen, freeze
from nacreous.study.plan import Trial, repetitions, trials
from nacreous.study.running import Running
from nacreous.study.store import Response, Session, Store
from nacreous.study.store.tokens import draw

WORDS = {"en": "Which looks more like a pearl?", "ja": "どちらがより真珠らしく見えますか。"}
PEOPLE = range(12)
KINDS = ("incomplete", "adaptive")


def study(count: int, kind: str = "adaptive", number: int = 20, **keys: Any) -> Design:
    return Design(
        purpose="demo",
        stimuli=[{"label": f"s{k}", "pearl": "paper"} for k in range(count)],
        questions=[{"id": "q0", "text": WORDS}, {"id": "q1", "text": WORDS}],
        pairs={"kind": kind, "number": number, "repeats": 3},
        **keys,
    )


def line(count: int, seed: int, people: int = 4) -> Comparisons:
    """Counts of stimuli 0.5 z apart, each pair asked so often."""
    chance = np.random.default_rng(seed)
    wins = np.zeros((count, count))
    for i, j in zip(*np.triu_indices(count, 1), strict=True):
        felt = 0.5 * (i - j) + chance.standard_normal(people)
        wins[i, j], wins[j, i] = (felt > 0).sum(), (felt <= 0).sum()
    return Comparisons.of_counts(wins, None, [f"s{k}" for k in range(count)])


def under(shown: list[Trial], question: str, *kinds: str) -> list[Trial]:
    return [trial for trial in shown if trial.question == question and trial.kind in kinds]


def pair_of(trial: Trial) -> frozenset[str]:
    return frozenset(trial.stimuli)


@pytest.fixture(params=["none so far", "one question answered", "both"])
def so_far(request: pytest.FixtureRequest) -> dict[str, Comparisons]:
    made = {"q0": line(12, 1), "q1": line(12, 2)}
    return dict(list(made.items())[: ["none", "one", "both"].index(request.param.split()[0])])


def test_the_plan_keeps_every_promise_that_others_keep(so_far: dict[str, Comparisons]) -> None:
    design = study(12, catches=[{"expected": "s11", "against": "s0"}])
    for number in PEOPLE:
        shown = trials(design, number, so_far)
        assert repetitions(shown) == 0
        for question in ("q0", "q1"):
            pairs, repeats = (under(shown, question, kind) for kind in ("pair", "repeat"))
            assert len(pairs) == len({pair_of(trial) for trial in pairs}) == 20
            assert len(repeats) == 3
            place = {(trial.stimuli[1], trial.stimuli[0]): trial.number for trial in pairs}
            assert all(
                place[trial.stimuli[0], trial.stimuli[1]] < trial.number for trial in repeats
            )
            lean = Counter(trial.stimuli[0] for trial in pairs + repeats)
            lean.subtract(trial.stimuli[1] for trial in pairs + repeats)
            assert max(map(abs, lean.values())) <= 1
        assert len(under(shown, "q0", "catch")) == 1


def test_without_answers_all_stimuli_are_joined() -> None:
    for number in PEOPLE:
        pairs = {pair_of(trial) for trial in under(trials(study(12), number), "q0", "pair")}
        joined = set(next(iter(pairs)))
        for _ in range(12):
            joined |= {label for pair in pairs if pair & joined for label in pair}
        assert len(joined) == 12


def test_neighbours_are_asked_about_once_the_order_shows() -> None:
    so_far = {"q0": line(12, 1, people=30)}
    apart = {"q0": [], "q1": []}
    for number in PEOPLE:
        shown = trials(study(12), number, so_far)
        for question, found in apart.items():
            for trial in under(shown, question, "pair"):
                found.append(abs(int(trial.stimuli[0][1:]) - int(trial.stimuli[1][1:])))
    assert np.mean(apart["q0"]) < 2 < 3 < np.mean(apart["q1"])


def test_same_answers_same_plan() -> None:
    so_far = {"q0": line(12, 1)}
    assert trials(study(12), 3, so_far) == trials(study(12), 3, so_far)
    assert trials(study(12), 3, so_far) != trials(study(12), 3, {"q0": line(12, 9)})
    assert trials(study(12), 3, so_far) != trials(study(12), 4, so_far)


def test_other_studies_do_not_look_at_answers() -> None:
    design = study(12, kind="incomplete")
    assert trials(design, 3, {"q0": line(12, 1)}) == trials(design, 3)


def test_all_pairs_may_be_asked_for() -> None:
    shown = trials(study(5, number=10), 0, {"q0": line(5, 1)})
    assert len({pair_of(trial) for trial in under(shown, "q0", "pair")}) == 10


# --- in a study that runs -------------------------------------------------------------------------

FILE = """
purpose = "demo"
questions = [{ id = "q0", text = { en = "Which?", ja = "どちら?" } }]
pairs = { kind = "adaptive", number = 6 }
display = { size_px = 32, samples = 1 }
sitting = { training = 2, ties = true }
stimuli = [{ label = "s", pearl = "paper", cut = "seven-crops" }]
"""


@pytest.fixture(scope="module")
def frozen(tmp_path_factory: pytest.TempPathFactory) -> Frozen:
    folder = tmp_path_factory.mktemp("study")
    text = FILE.replace("size_px = 32", "size_px = 256")
    (folder / "my.toml").write_text(text, encoding="utf-8")
    return freeze(folder / "my.toml", folder / "my-study")


@pytest.fixture
def running(place: str, frozen: Frozen) -> Any:
    with Store.open(place) as store:
        made = Running(store, frozen)
        store.set_registration(made.study, "open", "lab")
        yield made


def entered(running: Running) -> Session:
    token = draw()
    session = running.enter(token, "en", {})
    running.store.consent(session.id)
    return running.session_of(token)


def gone_through(running: Running, *, simulated: bool = False, chosen: str = "") -> Session:
    """Somebody who prefers whatever has the larger number."""
    session = entered(running)
    for trial in running.plan(session):
        right = trial.stimuli[0] < trial.stimuli[1]
        choice = chosen or ("right" if right else "left")
        response = Response(choice, simulated=simulated)
        running.hand_in(session, trial.number, response).result()
    return session


def planned(running: Running) -> dict[str, Any]:
    """What the next plan hangs on, as counts."""
    found = running._so_far() or {}
    return {question: counts.total for question, counts in found.items()}


def test_a_plan_is_made_from_what_is_answered_and_then_stays(
    running: Running, frozen: Frozen
) -> None:
    first = entered(running)
    before = running.plan(first)
    assert list(before) == trials(frozen.design, 0)
    gone_through(running)
    counts = running._so_far()
    later = entered(running)
    assert list(running.plan(later)) == trials(frozen.design, 2, counts)
    assert list(running.plan(later)) != trials(frozen.design, 2)
    restarted = Running(running.store, frozen)
    assert restarted.plan(first) == before
    assert restarted.plan(later) == running.plan(later)


def test_who_is_excluded_does_not_count_and_training_does_not_either(running: Running) -> None:
    session = gone_through(running)
    assert planned(running) == {"q0": 6}
    running.store.exclude(session.id, "slept", "lab")
    assert planned(running) == {}
    running.store.readmit(session.id, "lab")
    running.store.erase(session.id, "lab")
    assert planned(running) == {"q0": 6}


def test_simulated_answers_count_until_there_is_a_persons(running: Running) -> None:
    gone_through(running, simulated=True)
    gone_through(running, simulated=True)
    assert planned(running) == {"q0": 12}
    gone_through(running, chosen="tie")
    assert planned(running) == {"q0": 6}


def test_ties_and_one_sided_answers_are_no_hindrance(running: Running) -> None:
    gone_through(running, chosen="tie")
    gone_through(running, chosen="left")
    assert len(running.plan(entered(running))) == 8


def test_the_tally_agrees_with_the_counts_of_the_export(running: Running) -> None:
    from nacreous.study.store import counts

    for _ in range(5):
        gone_through(running)
    so_far = (running._so_far() or {})["q0"]
    exported = counts(running.store, running.study, "q0")
    place = [so_far.stimuli.index(label) for label in exported.stimuli]
    assert (so_far.matrix[np.ix_(place, place)] == exported.matrix).all()


# --- simulated observers, no data of people -------------------------------------------------------


def simulated(
    kind: str, value: np.ndarray, seed: int, together: int = 1
) -> tuple[np.ndarray, np.ndarray]:
    """Standard errors and true errors of the steps between neighbours; 40 observers, 20 pairs each.

    So many observers enter `together`; they have gone through before the next ones enter.
    """
    design = Design(
        **study(len(value), kind).model_dump(exclude={"seed", "pairs", "questions", "sitting"}),
        questions=[{"id": "q", "text": WORDS}],
        pairs={"kind": kind, "number": 20},
        sitting={"training": 0},
        seed=seed,
    )
    place = {label: index for index, label in enumerate(design.labels)}
    chance = np.random.default_rng([seed, 7])
    wins = np.zeros((len(value), len(value)))
    so_far: dict[str, Comparisons] = {}
    for number in range(40):
        if number % together == 0 and number:
            so_far = {"q": Comparisons.of_counts(wins, None, design.labels)}
        for trial in trials(design, number, so_far):
            left, right = place[trial.stimuli[0]], place[trial.stimuli[1]]
            won = value[left] - value[right] + chance.standard_normal() > 0
            wins[(left, right) if won else (right, left)] += 1
    prior = "hierarchical" if kind == "adaptive" else None
    fit = nc.scaling.thurstone(Comparisons.of_counts(wins, None, design.labels), prior=prior)
    covariance = fit.parameter_covariance("expected")[: len(value), : len(value)]
    step = np.eye(len(value))[1:] - np.eye(len(value))[:-1]
    return np.sqrt(np.diag(step @ covariance @ step.T)), np.diff(fit.scale) - np.diff(value)


def test_adaptive_pairs_tell_close_stimuli_apart_with_fewer_answers() -> None:
    # Variance falls as one over the answers, so its ratio is that of the answers needed.
    value = np.linspace(0, 3, 12)
    found = {kind: [simulated(kind, value, seed) for seed in range(8)] for kind in KINDS}
    se, error = (
        [np.mean(np.square([study[part] for study in found[kind]])) for kind in KINDS]
        for part in (0, 1)
    )
    print(f"\nfor the same standard error {se[0] / se[1]:.2f} times the answers")
    assert 1.35 < se[0] / se[1] < 1.75
    assert error[0] / error[1] > 1
    inside = [np.abs(error) < 1.96 * se for se, error in found["adaptive"]]
    assert np.mean(inside) > 0.85
