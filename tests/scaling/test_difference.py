"""Difference scales: as R's MLDS has them, and as a planted truth wants them."""

import json
import pickle
from pathlib import Path

import numpy as np
import pytest

import nacreous as nc
from nacreous.scaling import (
    Quadruples,
    difference_goodness,
    difference_scale,
    full_quadruples,
    random_quadruples,
    simulate_quadruples,
    six_points,
)
from nacreous.scaling.distribution import binom

GOLDEN = Path(__file__).parent.parent / "golden" / "mlds"
#: In the package's data the upper pair, S3 and S4, is the larger where resp is 1.
NAMES = {
    "first_a": "S3",
    "first_b": "S4",
    "second_a": "S1",
    "second_b": "S2",
    "larger": "resp",
    "first_word": "1",
    "second_word": "0",
}
EITHER = ("first", "second")
#: Neighbours that people's own values hardly ever exchange.
FAR = np.array([0.0, 0.9, 1.7, 2.8, 3.9, 5.2])
TRUTH = np.array([0.0, 0.3, 0.9, 1.8, 3.0, 4.5])


def rows_of(data: Quadruples) -> list[tuple[str, ...]]:
    shown = [tuple(data.stimuli[at] for at in row) for row in data.shown.tolist()]
    words = ["first" if one > 0 else "second" for one in data.outcome]
    people = [data.people[at] for at in (() if data.person is None else data.person.tolist())]
    columns = [*zip(*shown, strict=True), words, *([people] if people else [])]
    return list(zip(*columns, strict=True))


@pytest.mark.parametrize("name", ["kk1", "kk2", "kk3"])
def test_the_scale_is_that_of_the_r_package(name: str) -> None:
    reference = json.loads((GOLDEN / "reference.json").read_text())[name]
    fit = difference_scale(Quadruples.read(GOLDEN / f"{name}.csv", **NAMES))
    assert np.abs(fit.scale - reference["scale"]).max() < 1e-6
    assert fit.log_likelihood == pytest.approx(reference["log_likelihood"], abs=1e-6)
    assert fit.normalised[[0, -1]].tolist() == [0, 1]
    assert fit.noise == pytest.approx(1 / reference["scale"][-1])


def test_a_scale_says_where_it_falls() -> None:
    fit = difference_scale(Quadruples.read(GOLDEN / "kk3.csv", **NAMES))
    assert fit.falling == (("2", "3"), ("3", "4"))


@pytest.mark.parametrize("model", ["probit", "logit"])
def test_the_gradient_is_nothing_and_information_is_the_curvature(model: str) -> None:
    from nacreous.scaling.fit.difference_errors import information
    from nacreous.scaling.fit.difference_model import log_likelihood

    data = simulate_quadruples(TRUTH, people=20, model=model, seed=4)
    fit = difference_scale(data, model=model)  # type: ignore[arg-type]
    asked, step = fit.questions, 1e-4

    def height(moved: np.ndarray) -> float:
        lead = asked.design[:, 1:] @ (fit.scale[1:] + moved)
        return log_likelihood(lead, asked.counts(), fit.model)

    unit = np.eye(5) * step
    slope = [(height(one) - height(-one)) / (2 * step) for one in unit]
    assert np.abs(slope).max() < 1e-4
    bent = [
        [
            (height(a + b) - height(a - b) - height(b - a) + height(-a - b)) / (4 * step**2)
            for b in unit
        ]
        for a in unit
    ]
    assert np.allclose(-np.array(bent), information(fit, "observed"), rtol=1e-3, atol=0.02)


@pytest.mark.parametrize(("people", "spread"), [(1, 0.0), (12, 0.2)])
def test_95_of_100_intervals_hold_the_truth(people: int, spread: float) -> None:
    design = full_quadruples(6, repeats=30 if people == 1 else 5)
    kind = "expected" if people == 1 else "people"
    held = np.zeros(6, int)
    for seed in range(60):
        data = simulate_quadruples(
            FAR, people, design=design, person_spread=spread, seed=1000 + seed
        )
        low, high = difference_scale(data).intervals(kind=kind).T
        # Own values add the noise of four to that of the judgement: a probit of sums is one.
        truth = FAR / np.sqrt(1 + 4 * spread**2)
        held += (low < truth) & (truth < high)
    assert (binom.cdf(held[1:], 60, 0.95) > 0.005).all()


def test_errors_over_people_are_larger_where_people_differ() -> None:
    often = full_quadruples(6, repeats=8)
    data = simulate_quadruples(FAR, 20, design=often, person_spread=0.5, seed=5)
    fit = difference_scale(data)
    assert fit.se[-1] > 1.3 * np.sqrt(fit.covariance("expected")[-1, -1])
    alike = difference_scale(simulate_quadruples(TRUTH, 200, seed=5))
    ratio = alike.se[1:] / np.sqrt(np.diagonal(alike.covariance("expected")))[1:]
    assert np.abs(ratio - 1).max() < 0.25


def test_drawing_people_anew_gives_the_errors_over_people() -> None:
    fit = difference_scale(simulate_quadruples(TRUTH, 40, person_spread=0.4, seed=6))
    drawn = fit.bootstrap(200, seed=2)
    assert drawn.by == "people"
    assert drawn.without_maximum == 0
    assert np.abs(drawn.se[1:] / fit.se[1:] - 1).max() < 0.35
    assert fit.bootstrap(20, seed=2) == fit.bootstrap(20, seed=2)
    one = fit.bootstrap(200, by="answers").se[1:]
    assert np.abs(one / np.sqrt(np.diagonal(fit.covariance("expected")))[1:] - 1).max() < 0.25


def test_neither_names_nor_the_way_of_writing_a_pair_changes_the_scale() -> None:
    data = simulate_quadruples(TRUTH, 15, seed=7)
    fit = difference_scale(data)
    other = {"first": "second", "second": "first"}
    turned = [(d, c, a, b, other[word], who) for a, b, c, d, word, who in rows_of(data)]
    again = difference_scale(Quadruples.of_tuples(turned))
    assert np.allclose(again.scale, fit.scale, atol=1e-9)
    assert np.allclose(again.covariance(), fit.covariance(), atol=1e-9)
    named = [(*("abcdef"[int(x) - 1] for x in row[:4]), *row[4:]) for row in rows_of(data)]
    assert np.allclose(difference_scale(Quadruples.of_tuples(named)).scale, fit.scale, atol=1e-9)


def test_the_order_turned_round_turns_the_scale_round() -> None:
    data = simulate_quadruples(TRUTH, 15, seed=8)
    fit = difference_scale(data)
    back = Quadruples.of_tuples(rows_of(data), stimuli=data.stimuli[::-1])
    assert np.allclose(difference_scale(back).scale[::-1], fit.scale[-1] - fit.scale, atol=1e-8)


def test_a_triad_is_a_quadruple_with_a_common_stimulus() -> None:
    rows = [("1", "2", "4", "second", "x"), ("4", "3", "1", "first", "y")]
    triads = Quadruples.of_triads(rows)
    wide = [("2", "1", "2", "4", "second", "x"), ("3", "4", "3", "1", "first", "y")]
    assert triads == Quadruples.of_tuples(wide)
    random, truth = np.random.default_rng(3), [0.0, 0.4, 1.2, 2.4]
    many = []
    for _ in range(6000):
        a, b, c = sorted(random.choice(4, 3, replace=False).tolist())
        lead = (truth[b] - truth[a]) - (truth[c] - truth[b]) + random.standard_normal()
        many.append((str(a), str(b), str(c), "first" if lead > 0 else "second"))
    fit = difference_scale(Quadruples.of_triads(many))
    assert np.abs((fit.scale - truth)[1:] / fit.se[1:]).max() < 3


def test_judgements_that_follow_the_scale_pass_and_those_of_a_scale_that_turns_fail() -> None:
    data = simulate_quadruples(TRUTH, 8, design=full_quadruples(6, repeats=2), seed=9)
    good = difference_goodness(difference_scale(data), samples=99)
    assert good.deviance_p > 0.02
    assert good.runs_p > 0.02
    fit = difference_scale(data)
    assert good.deviance == pytest.approx(-2 * fit.log_likelihood)
    up_and_down = [0.0, 2.5, 5.0, 2.5, 0.0, 2.5, 5.0]
    often = full_quadruples(7, repeats=4)
    bad = difference_scale(simulate_quadruples(up_and_down, 5, design=often, seed=1))
    assert difference_goodness(bad, samples=99).runs_p < 0.02


def test_differences_that_add_up_keep_the_six_point_property() -> None:
    truth = np.array([0.0, 0.3, 0.9, 1.8, 3.0, 4.5, 6.3, 8.0])
    fit = difference_scale(simulate_quadruples(truth, 30, seed=2))
    found = six_points(fit, samples=50)
    assert 0 < found.tested <= 28  # one six of eight each
    assert found.p > 0.02
    rows = [
        *[("a", "b", "d", "e", word) for word in ("first", "first", "second")],
        *[("b", "c", "e", "f", word) for word in ("first", "first", "second")],
        *[("a", "c", "d", "f", word) for word in ("second", "second", "first")],
        *[(*row, word) for row in full_quadruples(list("abcdef")).quadruples for word in EITHER],
    ]
    broken = six_points(difference_scale(Quadruples.of_tuples([row[:5] for row in rows])), 20)
    assert broken.failed == 1


def test_designs_hold_quadruples_that_lie_apart_and_place_all() -> None:
    design = full_quadruples(7, seed=2)
    assert len({frozenset(row) for row in design.quadruples}) == len(design) == 35
    pairs = np.sort(design.shown.reshape(-1, 2, 2), axis=2)
    assert (
        (pairs[:, 0].max(1) < pairs[:, 1].min(1)) | (pairs[:, 1].max(1) < pairs[:, 0].min(1))
    ).all()
    few = random_quadruples(40, 90, seed=3)
    assert len({frozenset(row) for row in few.quadruples}) == 90
    fit = difference_scale(simulate_quadruples(np.zeros(40), 30, design=few, seed=1))
    assert len(fit.scale) == 40


def test_judgements_never_change_and_simulated_ones_are_called_so() -> None:
    data = simulate_quadruples(TRUTH, 2, seed=1)
    assert data.people == ("simulated 1", "simulated 2")
    assert data == simulate_quadruples(TRUTH, 2, seed=1) != simulate_quadruples(TRUTH, 2, seed=2)
    with pytest.raises(ValueError, match="read-only"):
        data.outcome[0] = 1
    assert pickle.loads(pickle.dumps(data)) == data
    assert len(data.of_person("simulated 2")) == 15


@pytest.mark.parametrize(
    ("row", "message"),
    [
        (("1", "2", "3", "4", "tie"), 'row 1: larger is "tie", a tie, which a difference scale'),
        (("1", "2", "3", "4", "3"), 'row 1: larger is "3"; allowed: first, second'),
        (("1", "2", "3", "4", None), "row 1: larger is empty; allowed: first, second"),
        (("1", None, "3", "4", "first"), "row 1: first_b is empty; allowed: a label"),
        (("2", "2", "3", "4", "first"), 'row 1: the first pair is "2" twice; allowed: two'),
        (("1", "2", "2", "1", "first"), 'row 1: both pairs are "1", "2"; allowed: two pairs'),
        (("1", "2", "3", "first"), r"judgements\[1\] has 4 parts; allowed: 5"),
    ],
)
def test_a_bad_judgement_is_named_by_row_and_column(row: tuple[str, ...], message: str) -> None:
    with pytest.raises(nc.InputError, match=message):
        Quadruples.of_tuples([("1", "2", "3", "4", "first"), row])


def test_columns_and_stimuli_that_are_not_there_are_named() -> None:
    table = {"first_a": [1], "first_b": [2], "second_a": [3], "second_b": [4]}
    with pytest.raises(nc.InputError, match="has no column larger; did you mean largr"):
        Quadruples.of_table(table | {"largr": ["first"]})
    with pytest.raises(nc.InputError, match="column persn, which is not read"):
        Quadruples.of_table(table | {"larger": ["first"], "persn": ["x"]})
    with pytest.raises(nc.InputError, match='second_b is "4"; allowed: "1", "2", "3"'):
        Quadruples.of_table(table | {"larger": ["first"]}, stimuli=[1, 2, 3])
    with pytest.raises(nc.InputError, match='"thrid" is no role of a column'):
        Quadruples.of_table(table, thrid="x")  # type: ignore[call-arg]


def test_stimuli_that_no_judgement_places_are_named() -> None:
    both = [("1", "2", "3", "4"), ("1", "3", "2", "4"), ("1", "4", "2", "3")]
    rows: list[tuple[str, ...]] = [(*row, word) for row in both for word in EITHER]
    with pytest.raises(nc.InputError, match='no scale holds "5"'):
        difference_scale(Quadruples.of_tuples(rows, stimuli=list("12345")))
    rows += [tuple(str(int(x) + 4) for x in row[:4]) + row[4:] for row in rows]
    with pytest.raises(nc.InputError, match=r'how far apart "1".*"4" \| "5".*"8" are'):
        difference_scale(Quadruples.of_tuples(rows))


def test_distances_without_an_end_are_named() -> None:
    clear = simulate_quadruples([0, 1, 3, 7, 15], noise=0)
    with pytest.raises(nc.InputError, match="no judgement contradicts any other"):
        difference_scale(clear)
    rows = [row[:5] for row in rows_of(simulate_quadruples(TRUTH[:5], 40, seed=1))]
    rows += [("5", "6", "1", "2", "first"), ("5", "6", "3", "4", "first")]
    with pytest.raises(nc.InputError, match='no scale holds the distances "5" to "6": all'):
        difference_scale(Quadruples.of_tuples(rows))


def test_errors_that_cannot_be_known_are_refused() -> None:
    two = difference_scale(simulate_quadruples(TRUTH, 2, design=full_quadruples(6, repeats=10)))
    with pytest.raises(nc.InputError, match="those of 2 people, who cannot tell"):
        two.covariance()
    assert "of 2 people" in str(two)
    with pytest.raises(nc.InputError, match="too few to be drawn anew"):
        two.bootstrap(20)
    kk = difference_scale(Quadruples.read(GOLDEN / "kk1.csv", **NAMES))
    with pytest.raises(nc.InputError, match="it is not known who judged"):
        kk.covariance("people")
    with pytest.raises(nc.InputError, match="allowed for a normalised scale"):
        _ = difference_scale(
            Quadruples.read(GOLDEN / "kk1.csv", **NAMES | {"first_word": "0", "second_word": "1"})
        ).normalised
