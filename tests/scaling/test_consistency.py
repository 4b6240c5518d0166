"""Consistency: published numbers, brute force on small cases, truths planted in made-up data."""

from __future__ import annotations

import itertools
import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.stats import binomtest, chi2

import nacreous as nc
from nacreous.scaling import (
    Answers,
    Comparisons,
    Share,
    agreement,
    circular_triads,
    consistency,
    paper,
    response_time,
    retest,
    side_bias,
    transitivity,
    triads_by_person,
)
from nacreous.scaling.check.transitive import MOST_TRIADS
from nacreous.scaling.check.triads import _ways, chance, most_circular

GOLDEN = json.loads((Path(__file__).parent.parent / "golden/thurstone/reference.json").read_text())


def refusal(act: Any) -> str:
    with pytest.raises(nc.InputError) as caught:
        act()
    message = str(caught.value)
    assert "\n" not in message
    return message


def counts_of(size: int, most: int = 4) -> st.SearchStrategy[np.ndarray]:
    """Counts with an empty diagonal, of which at least one is not 0."""
    matrices = arrays(np.int64, (size, size), elements=st.integers(0, most))
    return matrices.map(lambda m: m * ~np.eye(size, dtype=bool)).filter(lambda m: m.any())


def tournament(bits: tuple[int, ...], count: int) -> np.ndarray:
    wins = np.zeros((count, count), int)
    wins[np.triu_indices(count, 1)] = bits
    return np.where(np.tri(count, k=-1, dtype=bool), 1 - wins.T, wins)


def circles(wins: np.ndarray) -> int:
    """Circular triads one by one."""
    return sum(
        (wins[a, b] and wins[b, c] and wins[c, a]) or (wins[b, a] and wins[c, b] and wins[a, c])
        for a, b, c in itertools.combinations(range(len(wins)), 3)
    )


# --- the paper's data


def test_kendalls_numbers_of_the_papers_data():
    golden = GOLDEN["kendall"]
    triads, found = circular_triads(paper()), agreement(paper())
    assert triads.circular == golden["circular_triads_of_the_group_tournament"]
    assert triads.named == (tuple(map(str, golden["triad"])),)
    assert triads.zeta == pytest.approx(golden["zeta"], abs=5e-5)
    assert triads.wins.tolist() == golden["wins"]
    assert found.u == pytest.approx(golden["agreement_u"], abs=5e-7)
    assert found.statistic == pytest.approx(golden["chi2_continuity_corrected"], abs=5e-3)
    assert found.df == pytest.approx(golden["df"], abs=5e-3)


def test_transitivity_violations_of_the_papers_data():
    found, golden = transitivity(paper()), GOLDEN["transitivity_violations_of_35"]
    counts = {"weak": found.weak, "moderate": found.moderate, "strong": found.strong}
    assert (counts, found.triads, found.sampled) == (golden, 35, False)
    assert found.worst[0].triad == ("1", "3", "4")
    assert [each.kind for each in found.worst].count("weak") == 1
    assert len(found.worst) == 13


# --- circular triads


@pytest.mark.parametrize("count", [3, 4, 5])
def test_triads_and_chance_agree_with_all_tournaments_counted(count):
    pairs = math.comb(count, 2)
    every = list(itertools.product((0, 1), repeat=pairs))
    found = [circular_triads(tournament(bits, count)) for bits in every]
    numbers = np.array([circles(tournament(bits, count)) for bits in every])
    assert [each.circular for each in found] == numbers.tolist()
    assert [len(each.named) for each in found] == numbers.tolist()
    assert [each.untied for each in found] == numbers.tolist()
    assert numbers.max() == most_circular(count)
    for each, number in zip(found, numbers, strict=True):
        assert each.p_value == pytest.approx(np.mean(numbers <= number))


@given(st.permutations(range(9)))
def test_a_transitive_tournament_has_zeta_1(order):
    rank = np.argsort(order)
    triads = circular_triads((rank[:, None] < rank[None, :]).astype(int))
    assert (triads.circular, triads.zeta, triads.named) == (0, 1, ())
    assert triads.p_value < 1e-3


@given(st.integers(1, 5).map(lambda half: 2 * half + 1))
def test_a_regular_tournament_has_zeta_0(count):
    ahead = (np.arange(count)[None, :] - np.arange(count)[:, None]) % count
    triads = circular_triads(((ahead > 0) & (ahead <= count // 2)).astype(int))
    assert triads.zeta == 0
    assert triads.circular == triads.most


def test_kendalls_table_of_seven():
    """Kendall and Babington Smith 1940, table III: of 2^21, how many have d or fewer."""
    assert [round(chance(7, d) * 2**21) for d in (0, 1, 2, 14)] == [5040, 13440, 35280, 2**21]


def test_the_chi_squared_of_many_stimuli_is_near_coin_tossing():
    random = np.random.default_rng(2)
    found = []
    for _ in range(2000):
        bits = tuple(random.integers(0, 2, 66).tolist())
        found.append(circular_triads(tournament(bits, 12)).p_value)
    for level in (0.1, 0.5, 0.9):
        assert np.mean(np.array(found) <= level) == pytest.approx(level, abs=0.05)


@pytest.mark.parametrize("count", [9, 10])
def test_chance_is_counted_out_to_ten_stimuli(count):
    ways, pairs = _ways(count), math.comb(count, 2)
    assert sum(ways.values()) == 2**pairs  # all tournaments
    assert ways[0] == math.factorial(count)  # the ones without a circle are the orders
    mean = sum(number * circular for circular, number in ways.items()) / 2**pairs
    assert mean == math.comb(count, 3) / 4  # each triad is circular in 2 of 8
    assert chance(count, 0) == math.factorial(count) / 2**pairs


@pytest.mark.parametrize("count", [8, 9, 10])
def test_the_chi_squared_is_near_the_exact_chance(count):
    ways, seen = _ways(count), 0
    for circular in sorted(ways):
        seen += ways[circular]
        exact = seen / 2 ** math.comb(count, 2)
        assert chance(count, circular, tied=1) == pytest.approx(exact, abs=0.025)


@given(counts_of(5, most=2))
def test_ties_count_as_coins_would_on_average(counts):
    share = counts + counts.T
    even = [
        (i, j) for i, j in zip(*np.triu_indices(5, 1), strict=True) if counts[i, j] == counts[j, i]
    ]
    met = [(i, j) for i, j in even if share[i, j]]
    found = circular_triads(counts)
    if len(met) > 6:
        return
    beats = (counts > counts.T).astype(int)
    total = []
    for coins in itertools.product((0, 1), repeat=len(met)):
        broken = beats.copy()
        for (i, j), coin in zip(met, coins, strict=True):
            broken[i, j], broken[j, i] = coin, 1 - coin
        total.append(circles(broken))
    assert found.circular == pytest.approx(np.mean(total), abs=1e-5)
    assert found.tied == len(met)


def test_zeta_needs_every_pair():
    triads = circular_triads([("a", "b"), ("b", "c"), ("c", "a"), ("c", "d")])
    assert (triads.circular, triads.complete, triads.zeta, triads.p_value) == (1, 1, None, None)


def test_two_stimuli_have_no_triads():
    for act in (circular_triads, transitivity):
        assert refusal(lambda act=act: act([("a", "b")])).startswith(
            "2 stimuli; allowed: 3 or more"
        )


# --- agreement


def test_u_is_1_where_all_agree_and_least_where_halves_oppose():
    assert agreement([[0, 6, 6], [0, 0, 6], [0, 0, 0]]).u == 1
    halved = agreement([[0, 3, 3], [3, 0, 3], [3, 3, 0]])
    assert halved.u == halved.least == pytest.approx(-1 / 5)
    assert halved.p_value > 0.9


def test_agreement_of_coin_tossers_is_no_finding():
    random = np.random.default_rng(3)
    for people in (np.full(15, 12), random.integers(2, 20, 15)):
        p_values = []
        for _ in range(1000):
            counts = np.zeros((6, 6), int)
            wins = random.binomial(people, 0.5)
            counts[np.triu_indices(6, 1)] = wins
            counts.T[np.triu_indices(6, 1)] = people - wins
            p_values.append(agreement(counts).p_value)
        assert np.mean(np.array(p_values) < 0.05) == pytest.approx(0.05, abs=0.03)


def test_agreement_needs_a_pair_answered_twice():
    assert refusal(lambda: agreement([("a", "b"), ("b", "c")])).startswith(
        "no pair has two answers"
    )


# --- transitivity


def slow_levels(share: np.ndarray) -> list[int]:
    """The kind of violation of each triad, straight from the definition."""
    levels = []
    for triad in itertools.combinations(range(len(share)), 3):
        if any(np.isnan(share[i, j]) for i, j in itertools.combinations(triad, 2)):
            continue
        orders = []
        for a, b, c in itertools.permutations(triad):
            if share[a, b] >= 0.5 and share[b, c] >= 0.5:
                bounds = (0.5, min(share[a, b], share[b, c]), max(share[a, b], share[b, c]))
                orders.append(sum(share[a, c] < bound - 1e-9 for bound in bounds))
        levels.append(min(orders))
    return levels


@given(counts_of(5))
def test_violations_agree_with_the_definition(counts):
    total = counts + counts.T
    with np.errstate(invalid="ignore"):
        levels = slow_levels(counts / total)
    found = transitivity(counts)
    assert found.triads == len(levels)
    assert found.weak == sum(level >= 3 for level in levels)
    assert found.moderate == sum(level >= 2 for level in levels)
    assert found.strong == sum(level >= 1 for level in levels)


def test_shares_of_a_scale_violate_nothing():
    values = np.linspace(-1, 1, 8)
    share = 1 / (1 + np.exp(values[None, :] - values[:, None]))
    found = transitivity(Comparisons.of_proportions(share, answers=1000))
    assert (found.weak, found.moderate, found.strong) == (0, 0, 0)


def test_many_stimuli_are_sampled_and_the_sample_says_so():
    random = np.random.default_rng(4)
    counts = random.integers(1, 9, (260, 260)) * ~np.eye(260, dtype=bool)
    found = transitivity(counts)
    assert found.sampled
    assert 0.9 * MOST_TRIADS < found.triads <= MOST_TRIADS
    every = transitivity(counts[:200, :200])
    assert not every.sampled
    assert found.weak / found.triads == pytest.approx(every.weak / every.triads, abs=0.01)
    assert transitivity(counts, seed=1).weak == found.weak


# --- people


def table_of(rows: list[tuple[str, str, str, str]]) -> dict[str, list[str]]:
    return dict(zip(("person", "left", "right", "chosen"), np.array(rows).T.tolist(), strict=True))


def test_each_person_is_judged_by_own_answers():
    rows = [
        ("mika", "a", "b", "a"), ("mika", "b", "c", "b"), ("mika", "c", "a", "c"),
        ("ren", "a", "b", "a"), ("ren", "b", "c", "b"), ("ren", "c", "a", "a"),
        ("yui", "a", "b", "b"),
    ]  # fmt: skip
    found = triads_by_person(Answers.of_table(table_of(rows)))
    assert [(each.person, each.answers, each.triads.zeta) for each in found] == [
        ("mika", 3, 0.0),
        ("ren", 3, 1.0),
    ]


# --- test and retest


def test_retest_counts_second_answers_that_agree():
    rows = [
        ("mika", "a", "b", "a"), ("mika", "b", "a", "a"),  # reversed, the same
        ("mika", "a", "c", "a"), ("mika", "a", "c", "c"),  # as before, another
        ("ren", "a", "b", "tie"), ("ren", "a", "b", "tie"),
        ("ren", "b", "c", "b"),
    ]  # fmt: skip
    found = retest(Answers.of_table(table_of(rows), repeats=True))
    assert (found.agreement.count, found.agreement.total) == (2, 3)
    assert (found.reversed.count, found.reversed.total) == (1, 1)
    assert (found.same_sides.count, found.same_sides.total) == (1, 2)
    assert {who: share.share for who, share in found.by_person.items()} == {"mika": 0.5, "ren": 1.0}
    by_chance = 1 / 3 * 1 / 3 + 2 / 3 * 2 / 3 / 2
    assert found.kappa == pytest.approx((2 / 3 - by_chance) / (1 - by_chance))


def test_first_and_second_go_by_time():
    table = table_of([("mika", "a", "b", "a"), ("mika", "a", "b", "b"), ("mika", "a", "b", "a")])
    in_time = Answers.of_table(table | {"time": [3.0, 1.0, 2.0]})
    by_row = Answers.of_table(table, repeats=True)
    assert retest(in_time).agreement.share == 0
    assert retest(by_row).agreement.share == 0
    assert retest(Answers.of_table(table | {"time": [1.0, 3.0, 2.0]})).agreement.share == 1


def test_kappa_is_twice_the_agreement_less_one_without_ties():
    random = np.random.default_rng(5)
    rows = [("x", "a", "b", random.choice(["a", "b"])) for _ in range(2)]
    rows += [(f"p{i}", "a", "b", random.choice(["a", "b"])) for i in range(50) for _ in range(2)]
    found = retest(Answers.of_table(table_of(rows), repeats=True))
    assert found.kappa == pytest.approx(2 * found.agreement.share - 1)
    assert found.kappa_low <= found.kappa <= found.kappa_high


def test_nobody_asked_twice_gives_none_and_unknown_people_are_refused():
    assert retest(Answers.of_table(table_of([("mika", "a", "b", "a")]))) is None
    message = refusal(lambda: retest(Answers.of_pairs([("a", "b"), ("a", "b")])))
    assert message == "the answers do not say who gave them; wanted: a column person"


# --- sides


def test_side_bias_is_the_exact_test_and_finds_who_has_it():
    random = np.random.default_rng(6)
    people = np.repeat([f"p{i}" for i in range(10)], 60)
    chosen = np.where(random.random(600) < 0.5, "left", "right")
    chosen[people == "p3"] = "left"
    table = {"person": people, "left": ["a", "b"] * 300, "right": ["b", "a"] * 300}
    found = side_bias(Answers.of_table(table | {"chosen": chosen}, repeats=True))
    lefts = int((chosen == "left").sum())
    assert found.left.share == lefts / 600
    assert found.p_value == pytest.approx(binomtest(lefts, 600).pvalue)
    assert found.biased == ("p3",)
    assert found.balanced == 1


def one_way(random: np.random.Generator, other_way: float, pull: float = 0.0) -> Answers:
    """Simulated: 20 people, five stimuli 0.6 z apart; the better one left but for a share."""
    rows = []
    for person in range(20):
        for first, second in itertools.combinations(range(5), 2):
            turned = random.random() < other_way
            left, right = (second, first) if turned else (first, second)
            lead = 0.6 * (right - left) + pull
            rows.append((f"p{person}", left, right, left if lead > random.normal() else right))
    person, left, right, chosen = zip(*rows, strict=True)
    return Answers.of_table({"person": person, "left": left, "right": right, "chosen": chosen})


def test_stimuli_that_never_change_sides_tell_nothing_of_the_side():
    found = side_bias(one_way(np.random.default_rng(1), 0))
    assert found.left.low > 0.7
    assert (found.p_value, found.exchanged, found.decides, found.biased) == (None, False, False, ())


def test_sides_that_are_seldom_exchanged_are_tested_within_pairs():
    def refused(pull: float) -> float:
        random = np.random.default_rng(2)
        found = [side_bias(one_way(random, 0.2, pull)) for _ in range(60)]
        assert not any(each.exchanged for each in found)
        return float(np.mean([each.p_value < 0.05 for each in found]))

    assert refused(0.0) < 0.12
    assert refused(1.0) > 0.8


def test_within_pairs_it_is_mantel_and_haenszels_test():
    """One pair: a two by two table, by hand."""
    shown = [("a", "b", "a")] * 30 + [("a", "b", "b")] * 10
    shown += [("b", "a", "b")] * 6 + [("b", "a", "a")] * 4
    left, right, chosen = zip(*shown, strict=True)
    found = side_bias(Answers.of_table({"left": left, "right": right, "chosen": chosen}))
    spread = 40 * 10 * 34 * 16 / (50**2 * 49)
    by_hand = chi2.sf((30 - 40 * 34 / 50 - 0.5) ** 2 / spread, 1)
    assert found.p_value == pytest.approx(by_hand)


def test_coins_tossed_for_sides_exchange_them():
    found = [side_bias(one_way(np.random.default_rng(seed), 0.5)) for seed in range(30)]
    assert np.mean([each.exchanged for each in found]) > 0.9
    assert not any(each.decides or each.biased for each in found)


def test_answers_without_sides_have_no_side_bias():
    message = refusal(lambda: side_bias(Answers.of_pairs([("a", "b")])))
    assert message.startswith("the answers have no sides")
    ties = {"left": ["a"], "right": ["b"], "chosen": ["tie"]}
    assert refusal(lambda: side_bias(Answers.of_table(ties))).startswith("all answers are ties")


@given(st.integers(0, 40), st.integers(1, 40), st.sampled_from([0.8, 0.95, 0.99]))
def test_shares_lie_in_their_interval_which_is_wilsons(count, total, level):
    count = min(count, total)
    share = Share.of(count, total, level)
    assert 0 <= share.low <= share.share <= share.high <= 1
    wilson = binomtest(count, total).proportion_ci(level, "wilson")
    assert (share.low, share.high) == pytest.approx((wilson.low, wilson.high), abs=1e-12)


# --- response times


def timed(seconds: list[float | None], **columns: Any) -> Answers:
    count = len(seconds)
    table = {"left": ["a"] * count, "right": ["b"] * count, "chosen": ["a"] * count}
    return Answers.of_table(table | {"response_s": seconds} | columns, repeats=True)


def test_medians_and_hasty_people():
    answers = timed([1.0, 2.0, 9.0, 0.1, 0.15, None], person=["a"] * 3 + ["b"] * 3)
    found = response_time(answers)
    assert found.by_person == {"a": 2.0, "b": 0.125}
    assert found.hasty == ("b",)
    assert found.too_fast.tolist() == [3, 4]
    assert (found.median_s, found.answers) == (1.0, 5)


def test_near_pairs_that_take_longer_correlate_below_0():
    random = np.random.default_rng(7)
    pairs = np.array([random.permutation(5)[:2] for _ in range(400)])
    seconds = np.exp(-0.5 * np.abs(pairs[:, 0] - pairs[:, 1]) + 0.2 * random.normal(size=400))
    left, right = pairs.T.astype(str)
    table = {"left": left, "right": right, "chosen": left, "response_ms": 1000 * seconds}
    answers = Answers.of_table(table)
    found = response_time(answers, scale=np.arange(5.0))
    assert found.correlation < -0.7
    assert found.p_value < 1e-10
    assert found.median_s == pytest.approx(np.median(seconds))
    assert refusal(lambda: response_time(answers, scale=[1.0])).startswith("scale has 1 values")


def test_no_times_no_finding():
    assert response_time(Answers.of_pairs([("a", "b")])) is None
    assert response_time(timed([None, None])) is None


# --- all together


def test_consistency_says_what_the_answers_allow():
    counts = consistency(paper())
    assert counts.people == ()
    assert counts.retest is counts.side is counts.response is None
    rows = [(f"p{i}", a, b, a) for i in range(4) for a, b in itertools.combinations("abcd", 2)]
    whole = consistency(Answers.of_table(table_of(rows)))
    assert whole.agreement.u == 1
    assert len(whole.people) == 4
    assert whole.side.left.share == 1
    assert whole.retest is None


@pytest.mark.parametrize(
    "data", [[("a", "b")], [("a", "b")] * 3, [[0, 0, 3], [0, 0, 1], [0, 2, 0]]]
)
def test_small_data_give_numbers_or_none(data):
    found = consistency(data)
    for part in (found.triads, found.agreement):
        values = vars(part).values() if part else ()
        assert all(np.isfinite(v) for v in values if isinstance(v, float))
