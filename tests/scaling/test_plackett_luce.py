"""Laws of scales of rankings: choix, Bradley and Terry, own derivations, and planted truths."""

from itertools import combinations, permutations
from math import exp, log

import choix
import numpy as np
import pytest
from scipy.optimize import approx_fprime
from scipy.stats import binom, friedmanchisquare

import nacreous as nc
from nacreous.scaling import Rankings, bradley_terry, concordance, plackett_luce, simulate_rankings
from nacreous.scaling.fit.ranking_model import RankingModel

TRUTH = [0.8, 0.3, 0.0, -0.4, -0.7]
LABELS = ["1", "2", "3", "4", "5"]


def refused(call):
    with pytest.raises(nc.InputError) as problem:
        call()
    return str(problem.value)


def table(**columns):
    return Rankings.of_table(columns)


# --- other programs


def as_numbers(rankings):
    return [[int(label) - 1 for label in each] for each in rankings.lists()]


def test_whole_rankings_have_the_scale_of_choix():
    rankings = simulate_rankings(TRUTH, people=40, seed=1)
    found = plackett_luce(rankings).scale
    for estimator in (choix.opt_rankings, choix.ilsr_rankings):
        other = estimator(5, as_numbers(rankings), tol=1e-12)
        assert np.allclose(found, other - np.mean(other), atol=1e-6)


def test_first_choices_have_the_scale_of_choix():
    trays = [*map(list, combinations(LABELS, 3)), LABELS]
    rankings = simulate_rankings(TRUTH, people=30, trays=trays, first=1, seed=2)
    data = [(best, others) for best, *others in as_numbers(rankings)]
    other = choix.opt_top1(5, data, tol=1e-12)
    assert np.allclose(plackett_luce(rankings).scale, other - np.mean(other), atol=1e-6)


def pairs_with_people(pairs, repeats):
    answers = nc.scaling.simulate(
        [0.3, 0.1, -0.4, 0.0], people=12, model="logit", pairs=pairs, repeats=repeats
    )
    kept = np.flatnonzero(np.arange(len(answers)) % 7)  # so that designs of people differ
    answers = answers.take(kept)
    winner = np.where(answers.outcome > 0, answers.left, answers.right)
    loser = np.where(answers.outcome > 0, answers.right, answers.left)
    labels = np.array(answers.stimuli)
    people = np.array(answers.people)[answers.person].tolist()
    return answers, labels[np.column_stack((winner, loser))].tolist(), people


@pytest.mark.parametrize("repeats", [1, 3])
def test_pairs_as_trays_of_two_are_bradley_and_terrys_scale_with_its_errors(repeats):
    answers, lists, people = pairs_with_people(None, repeats)
    fit, other = plackett_luce(Rankings.of_lists(lists, person=people)), bradley_terry(answers)
    assert np.allclose(fit.scale, other.scale, atol=1e-8)
    assert fit.log_likelihood == pytest.approx(other.log_likelihood, abs=1e-9)
    for kind in ("expected", "observed", "people"):
        assert np.allclose(fit.covariance(kind), other.covariance(kind), atol=1e-8)
        ours, theirs = (one.difference("1", "3", kind=kind) for one in (fit, other))
        assert (ours.low, ours.p_value) == pytest.approx((theirs.low, theirs.p_value), abs=1e-8)


def test_pairs_told_as_best_and_worst_are_half_of_it():
    _, lists, people = pairs_with_people(None, 3)
    pairs = [(pair, *pair) for pair in lists]
    half = plackett_luce(Rankings.of_best_worst(pairs, person=people))
    whole = plackett_luce(Rankings.of_lists(lists, person=people))
    assert np.allclose(2 * half.scale, whole.scale, atol=1e-8)
    assert np.allclose(4 * half.covariance(), whole.covariance(), atol=1e-8)


# --- own derivations

TRAY = ["1", "2", "3", "4"]
VALUES = np.array([0.7, -0.2, 0.1, -0.6])


def order_probability(order, chosen):
    found, left = 1.0, list(order)
    for item in order[:chosen]:
        found *= exp(VALUES[item]) / sum(exp(VALUES[other]) for other in left)
        left.remove(item)
    return found


@pytest.mark.parametrize("chosen", [1, 2, 4])
def test_the_likelihood_of_orders_is_luces_product_and_adds_up_to_one(chosen):
    heads = list(permutations(range(4), chosen))
    probability = []
    for head in heads:
        order = [*head, *(item for item in range(4) if item not in head)]
        one = Rankings.of_lists([[TRAY[item] for item in head]], shown=[TRAY], stimuli=TRAY)
        probability.append(exp(RankingModel(one).log_likelihood(VALUES)))
        assert probability[-1] == pytest.approx(order_probability(order, chosen), rel=1e-12)
    assert sum(probability) == pytest.approx(1, abs=1e-12)


def test_the_likelihood_of_best_and_worst_is_that_of_a_choice_among_all_pairs():
    pairs = list(permutations(range(4), 2))
    total = sum(exp(VALUES[best] - VALUES[worst]) for best, worst in pairs)
    for best, worst in pairs:
        one = Rankings.of_best_worst([(TRAY, TRAY[best], TRAY[worst])], stimuli=TRAY)
        found = RankingModel(one).log_likelihood(VALUES)
        assert found == pytest.approx(VALUES[best] - VALUES[worst] - log(total), abs=1e-12)


@pytest.mark.parametrize("task", [{}, {"first": 2}, {"best_worst": True}])
def test_slopes_and_information_are_the_derivatives_of_the_likelihood(task):
    trays = [TRAY, TRAY[:3], TRAY[1:], ["1", "4"]]
    model = RankingModel(
        simulate_rankings(dict(zip(TRAY, VALUES, strict=True)), 3, trays=trays, **task)
    )
    _, gradient, information = model.slopes(VALUES)
    assert np.allclose(gradient, approx_fprime(VALUES, model.log_likelihood, 1e-6), atol=1e-4)
    second = approx_fprime(VALUES, lambda at: model.slopes(at)[1], 1e-6)
    assert np.allclose(information, -second, atol=1e-4)
    owner = np.arange(model.trays) % 3
    assert np.allclose(model.scores(VALUES, owner, 3).sum(axis=0), gradient)
    assert np.allclose(model.information(VALUES, owner, 3).sum(axis=0), information)


@pytest.mark.parametrize("chosen", [1, 2, 4])
def test_the_expected_information_is_the_mean_over_all_orders(chosen):
    mean = np.zeros((4, 4))
    for order in permutations(range(4)):
        one = Rankings.of_lists([[TRAY[i] for i in order][:chosen]], shown=[TRAY], stimuli=TRAY)
        mean += order_probability(order, 4) * RankingModel(one).slopes(VALUES)[2]
    assert np.allclose(RankingModel(one).expected(VALUES), mean, atol=1e-12)


# --- planted truths


def designs():
    trays = [list(each) for each in combinations(LABELS, 3)]
    return [
        ({}, 25),
        ({"trays": trays, "first": 1}, 20),
        ({"trays": trays, "best_worst": True}, 20),
    ]


@pytest.mark.parametrize(("design", "people"), designs())
def test_intervals_of_95_of_100_cover_the_truth(design, people):
    """All ten differences of 60 studies; those of one study hang together."""
    studies, hits = 60, np.zeros(10)
    true = [TRUTH[i] - TRUTH[j] for i, j in combinations(range(5), 2)]
    for seed in range(studies):
        fit = plackett_luce(simulate_rankings(TRUTH, people, seed=seed, **design))
        found = fit.differences(simultaneous="none")
        hits += [one.low <= value <= one.high for one, value in zip(found, true, strict=True)]
    low, high = binom.interval(0.995, studies, 0.95)
    assert low <= hits.mean() <= high
    assert hits.min() >= binom.ppf(0.001, studies, 0.95)


def test_many_rankings_of_any_kind_find_the_truth():
    for task in ({}, {"first": 2}, {"best_worst": True}):
        fit = plackett_luce(simulate_rankings(TRUTH, 1500, seed=5, **task))
        assert np.abs((fit.scale - TRUTH) / fit.se).max() < 3.3


def test_people_with_scales_of_their_own_widen_the_errors_over_people_alone():
    trays = [list(each) for each in combinations(LABELS, 3)]
    fit = plackett_luce(simulate_rankings(TRUTH, 40, trays=trays, person_spread=1.0, seed=3))
    assert (fit.se > 1.2 * np.sqrt(np.diag(fit.covariance("observed")))).all()


@pytest.mark.parametrize("task", [{}, {"best_worst": True}])
def test_the_bootstrap_by_people_agrees_with_the_sandwich(task):
    fit = plackett_luce(simulate_rankings(TRUTH, 60, seed=4, **task))
    drawn = fit.bootstrap(200, seed=1)
    assert drawn.by == "people"
    assert np.abs(drawn.se / fit.se - 1).max() < 0.25
    assert drawn == fit.bootstrap(200, seed=1)
    assert np.abs(drawn.intervals() - fit.intervals()).max() < 0.2


# --- invariances


def test_the_scale_hangs_on_no_order_of_trays_people_or_names():
    rankings = simulate_rankings(TRUTH, 20, seed=6)
    fit, lists = plackett_luce(rankings), rankings.lists()
    names = dict(zip(LABELS, "edcba", strict=True))
    turned = [[names[label] for label in each] for each in reversed(lists)]
    other = plackett_luce(Rankings.of_lists(turned, person=range(20)))
    assert np.allclose(other.scale[::-1], fit.scale, atol=1e-9)
    assert np.allclose(other.covariance()[::-1, ::-1], fit.covariance(), atol=1e-9)


def test_best_and_worst_turned_round_turn_the_scale_round():
    rankings = simulate_rankings(TRUTH, 60, best_worst=True, seed=7)
    turned = [(each, each[-1], each[0]) for each in rankings.lists()]
    found = plackett_luce(Rankings.of_best_worst(turned)).scale
    assert np.allclose(found, -plackett_luce(rankings).scale, atol=1e-9)


def test_the_last_of_a_tray_goes_without_saying():
    shown = [["a", "b", "c"]] * 2
    part = Rankings.of_lists([["b", "a"], ["c", "b"]], shown=shown)
    assert part == Rankings.of_lists([["b", "a", "c"], ["c", "b", "a"]])


def test_lists_and_a_long_table_are_the_same_rankings():
    lists = Rankings.of_lists([["b", "a"], ["c", "a", "b"]], person=["mika", "ken"])
    long = table(
        person=["mika", "ken", "ken", "mika", "ken"],
        tray=[1, 1, 1, 1, 1],
        stimulus=["a", "a", "b", "b", "c"],
        rank=[2, 2, 3, 1, 1],
    )
    assert long == lists


# --- what cannot be told


def test_what_always_stands_above_is_named():
    said = refused(lambda: plackett_luce(Rankings.of_lists([["a", "b", "c"], ["a", "c", "b"]])))
    assert said.startswith('no scale holds "a": was always preferred when compared with "b", "c"')
    assert "prior" not in said
    worst = [(["a", "b", "c"], "a", "c"), (["a", "b", "c"], "b", "c")]
    assert 'no scale holds "c": was never' in refused(
        lambda: plackett_luce(Rankings.of_best_worst(worst))
    )


def test_what_never_lay_together_is_named():
    apart = Rankings.of_lists([["a", "b"], ["b", "a"], ["c", "d"], ["d", "c"]])
    assert '"a", "b" were never compared with "c", "d"' in refused(lambda: plackett_luce(apart))


def test_people_who_are_too_few_or_alike_tell_no_errors_over_people():
    pair = [["a", "b"], ["b", "a"]]
    few = plackett_luce(Rankings.of_lists(pair, person=["x", "y"]))
    assert "those of 2 people" in refused(few.covariance)
    assert "no errors over people" in str(few)
    alike = plackett_luce(Rankings.of_lists(pair * 4, person=[1, 1, 2, 2, 3, 3, 4, 4]))
    assert 'kind="observed"' in refused(alike.covariance)
    assert "too few to be drawn anew" in refused(lambda: few.bootstrap(by="people"))
    unknown = plackett_luce(Rankings.of_lists(pair))
    assert "not known who ranked" in refused(lambda: unknown.covariance("people"))


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Rankings.of_lists([["a", "b", "a"]]), 'row 0: column 2: is "a" again'),
        (lambda: Rankings.of_lists([[("a", "b"), "c"]]), "column 0: is ('a', 'b'); allowed: one"),
        (lambda: Rankings.of_lists([["a", "b"], ["a"]]), "row 1: has 1 label; allowed: 2 to 200"),
        (lambda: Rankings.of_lists([["a"]], shown=[["b", "c"]]), '"a" did not lie on the tray'),
        (lambda: Rankings.of_lists([["a", "b"]], person=[]), "person: has no rows"),
        (lambda: Rankings.of_lists([["a", "b"]], stimuli="ac"), "stimuli is 'ac'"),
        (lambda: Rankings.of_best_worst([("abc", "a", "b")]), "row 0: is 'abc'; allowed: a list"),
        (lambda: Rankings.of_best_worst([(["a", "b"], "a", "a")]), '"a" is best and worst'),
        (lambda: Rankings.of_best_worst([(["a", "b"], "a", "c")]), 'the worst is "c", which did'),
        (lambda: table(tray=[1, 1], stimulus=["a", "b"]), "has no column rank"),
        (
            lambda: table(tray=[1] * 3, stimulus=["a", "b", "c"], rank=[1, 2, 2]),
            'row 2: rank of "c" is 2, as that of "b" in row 1; allowed: no ties',
        ),
        (
            lambda: table(tray=[1] * 3, stimulus=["a", "b", "a"], rank=[1, 2, 3]),
            'row 2: stimulus is "a" again, as in row 0 of the same tray',
        ),
        (
            lambda: table(tray=[1] * 3, stimulus=["a", "b", "c"], rank=[1, 2, 4]),
            'row 2: rank of "c" is 4, and the one before it is missing',
        ),
        (lambda: table(tray=[1, 1], stimulus=["a", "b"], rank=[1, 1.5]), "row 1: rank is 1.5"),
        (lambda: table(tray=[1, 1], stimulus=["a", "b"], rank=[None] * 2), "rank is empty on"),
        (lambda: table(tray=[1, 2], stimulus=["a", "b"], rank=[1, 1]), "its tray holds 1 stim"),
        (lambda: plackett_luce([["a", "b"]]), "allowed: Rankings"),
        (lambda: simulate_rankings([1, 0], first=3), "first is 3; allowed: a whole number, 1 to 2"),
        (lambda: simulate_rankings([1, 0], trays=[["1", "9"]]), '"9" is unknown'),
        (lambda: concordance(Rankings.of_lists([["a", "b"]])), "no two whole rankings"),
    ],
)
def test_what_cannot_be_used_is_refused_with_its_place(make, message):
    assert message in refused(make)


# --- agreement, and whose rankings these are


def test_kendalls_w_is_friedmans_statistic_and_its_p_value_that_of_chance():
    rankings = simulate_rankings(TRUTH, 12, seed=8)
    ranks = np.array([np.argsort([int(x) for x in each]) for each in rankings.lists()])
    found, other = concordance(rankings), friedmanchisquare(*ranks.T)
    assert found.statistic == pytest.approx(other.statistic)
    assert found.chi_squared_p_value == pytest.approx(other.pvalue)
    assert found.w == pytest.approx(other.statistic / (12 * 4))
    by_chance = [concordance(simulate_rankings([0] * 4, 6, seed=k), 99).p_value for k in range(60)]
    assert (
        binom.ppf(0.001, 60, 0.2) <= sum(p <= 0.2 for p in by_chance) <= binom.isf(0.001, 60, 0.2)
    )


def test_that_someone_ranked_a_tray_twice_is_no_agreement():
    twice = Rankings.of_lists([["a", "b"]] * 2, person=["mika", "mika"])
    assert '"mika" ranked the same stimuli twice' in refused(lambda: concordance(twice))


def test_simulated_rankings_are_called_so_and_hang_on_the_seed_alone():
    one, same, other = (simulate_rankings(TRUTH, 5, seed=seed) for seed in (1, 1, 2))
    assert one == same != other
    assert all(label.startswith("simulated ") for label in one.people)
