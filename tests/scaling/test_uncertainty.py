"""Standard errors, intervals and bootstraps: laws, and truths planted in simulated answers."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import studentized_range

from nacreous.problem import InputError
from nacreous.scaling import Answers, analyse, bradley_terry, paper, simulate, thurstone
from nacreous.scaling.fit.uncertainty import inverse, largest_of_normal

VALUES = [0.6, 0.2, -0.1, -0.7]


def study(seed, people=40, stimuli=5, spread=0.5):
    """Simulated people, each with a scale of their own, who answer every pair once."""
    random = np.random.default_rng(seed)
    i, j = np.triu_indices(stimuli, 1)
    left, right = np.tile(i, people), np.tile(j, people)
    person = np.repeat(np.arange(people), len(i))
    own = np.linspace(0.8, -0.8, stimuli) + spread * random.standard_normal((people, stimuli))
    lead = own[person, left] - own[person, right] + random.standard_normal(len(left))
    outcome = np.where(lead > 0, 1, -1).astype(np.int8)
    labels = tuple(f"s{index}" for index in range(stimuli))
    return Answers(labels, left, right, outcome, tuple(map(str, range(people))), person)


def test_covariance_holds_the_mean_at_zero():
    fit = thurstone(paper())
    for kind in ("expected", "observed"):
        assert np.abs(fit.covariance(kind).sum(axis=0)).max() < 1e-16
        assert (np.linalg.eigvalsh(fit.covariance(kind)) > -1e-16).all()


def test_covariance_is_the_pseudo_inverse_of_the_information():
    fit = bradley_terry(paper())
    information = fit.pair_model.information(fit.parameters, True)
    assert np.abs(fit.covariance() - np.linalg.pinv(information)).max() < 1e-14


def test_the_error_of_two_is_that_of_a_proportion():
    fit = thurstone([[0, 30], [20, 0]])
    p, n, z = 0.6, 50, fit.scale[0] - fit.scale[1]
    density = np.exp(-0.5 * z**2) / np.sqrt(2 * np.pi)
    expected = np.sqrt(p * (1 - p) / n) / density
    found = fit.difference("1", "2")
    assert abs(found.se / expected - 1) < 1e-12
    least = thurstone([[0, 30], [20, 0]], "least-squares").difference("1", "2")
    assert abs(least.se / expected - 1) < 1e-12


def test_people_as_clusters_of_one_answer_are_single_answers():
    # Two stimuli, one answer a person: the sandwich is the binomial's, times n / (n - 1).
    person = np.arange(50)
    outcome = np.where(person < 30, 1, -1).astype(np.int8)
    zero, one = np.zeros(50, np.int64), np.ones(50, np.int64)
    fit = bradley_terry(Answers(("a", "b"), zero, one, outcome, tuple(map(str, person)), person))
    ratio = fit.covariance("people")[0, 0] / fit.covariance("observed")[0, 0]
    assert abs(ratio - 50 / 49) < 1e-12


def test_people_widen_what_hangs_together():
    twice = study(1, people=30, spread=0.0)
    doubled = twice.take(np.repeat(np.arange(len(twice)), 4))  # everyone says the same four times
    fit, four = thurstone(twice), thurstone(doubled)
    alone = [np.diag(each.covariance("expected")) for each in (four, fit)]
    assert np.abs(alone[0] / alone[1] - 0.25).max() < 1e-9
    assert np.abs(four.covariance("people") - fit.covariance("people")).max() < 1e-12


def test_tukey_is_the_studentised_range_where_all_are_alike():
    alike = np.eye(4) - 0.25
    i, j = np.triu_indices(4, 1)
    contrast = np.eye(4)[i] - np.eye(4)[j]
    largest = largest_of_normal(contrast @ alike @ contrast.T)
    expected = studentized_range.ppf(0.95, 4, np.inf) / np.sqrt(2)
    assert abs(np.quantile(largest, 0.95) - expected) < 0.02


def test_controls_stand_in_their_order():
    fit = thurstone(paper())
    width = {}
    for control in ("none", "tukey", "bonferroni"):
        found = fit.differences(simultaneous=control)
        width[control] = np.array([d.high - d.low for d in found])
        assert all(d.low < d.value < d.high for d in found)
    assert (width["none"] < width["tukey"]).all()
    assert (width["tukey"] < width["bonferroni"]).all()
    by = {
        c: [d.p_value for d in fit.differences(simultaneous=c)]
        for c in ("none", "holm", "bonferroni")
    }
    assert (np.array(by["none"]) <= by["holm"]).all()
    assert (np.array(by["holm"]) <= by["bonferroni"]).all()
    assert max(by["bonferroni"]) <= 1


def test_same_seed_same_bytes():
    fit = thurstone(study(2))
    first, again = fit.bootstrap(50, seed=5), fit.bootstrap(50, seed=5)
    assert first.samples.tobytes() == again.samples.tobytes()
    assert first.samples.tobytes() != fit.bootstrap(50, seed=6).samples.tobytes()
    assert first.samples[:20].tobytes() == fit.bootstrap(20, seed=5).samples.tobytes()


def test_people_are_drawn_where_they_are_known():
    fit = thurstone(study(3, spread=0.8))
    people, answers = fit.bootstrap(), fit.bootstrap(by="answers")
    assert (people.by, answers.by) == ("people", "answers")
    clusters = np.sqrt(np.diag(fit.covariance("people")))
    assert np.abs(people.se / clusters - 1).max() < 0.15
    assert np.abs(answers.se / np.sqrt(np.diag(fit.covariance("expected"))) - 1).max() < 0.15
    assert (people.se > 1.1 * answers.se).any()


@pytest.mark.parametrize("people", [3, 7])
def test_few_people_are_not_drawn(people):
    fit = thurstone(simulate(VALUES, people, repeats=10, person_spread=0.5, seed=2))
    with pytest.raises(InputError, match=f"{people} people, too few to be drawn anew; allowed: 8"):
        fit.bootstrap(100)
    assert fit.bootstrap(100, by="answers").tells


def test_a_stimulus_that_few_people_judged_makes_no_bootstrap():
    answers = study(2, people=30)
    seldom = (answers.left == 4) | (answers.right == 4)
    answers = answers.take(~seldom | (answers.person < 7))
    with pytest.raises(InputError, match='"s4" was judged by 7 of 30 people'):
        thurstone(answers).bootstrap(100)
    found = analyse(answers, bootstrap=100).doubt  # and the report takes Student's t
    assert (found.by, found.samples) == ("clusters", 0)


def test_intervals_of_eight_people_are_about_as_wide_as_those_of_t():
    """150 studies: half within 1.02 times, 95 of 100 within 1.5 times (docs/scaling.md)."""
    ratios = []
    for seed in range(10):
        fit = thurstone(simulate(VALUES, 8, repeats=10, person_spread=0.5, seed=seed))
        drawn, own = fit.bootstrap(200).intervals(), fit.intervals()
        ratios.append((drawn[:, 1] - drawn[:, 0]) / (own[:, 1] - own[:, 0]))
    assert 0.85 < np.median(ratios) < 1.25
    assert np.max(ratios) < 5


def test_samples_in_which_nobody_differs_are_not_measured_in_their_errors():
    """Simulated: 12 people, of whom 10 gave the same answers."""
    own = study(5, people=3)
    each = len(own) // 3
    copies = np.concatenate([np.tile(np.arange(each), 10), np.arange(each, 3 * each)])
    answers = replace(
        own.take(copies), people=tuple("abcdefghijkl"), person=np.repeat(np.arange(12), each)
    )
    drawn = thurstone(answers, prior=1.0).bootstrap(400)
    assert not drawn.tells
    with pytest.raises(InputError, match="samples all people answered alike about a stimulus"):
        drawn.intervals()


def test_samples_without_a_maximum_are_counted_and_finite():
    # One answer keeps "c" from always losing; a third of the samples miss it.
    answers = [("a", "b"), ("b", "a")] * 20 + [("a", "c"), ("b", "c")] * 10 + [("c", "a")]
    found = thurstone(answers).bootstrap(500)
    assert 100 < found.without_maximum < 300
    assert np.isfinite(found.samples).all()
    assert np.abs(found.samples).max() < 10
    # Their spread is that of the prior that holds them.
    message = f"{found.without_maximum} of 500 samples have no scale of their own"
    for told in (
        found.intervals,
        lambda: found.difference("a", "b"),
        lambda: found.se,
        lambda: found.covariance,
    ):
        with pytest.raises(InputError, match=message):
            told()


@pytest.mark.parametrize("kind", ["studentised", "percentile", "basic"])
def test_intervals_are_in_their_unit_and_hold_the_fit(kind):
    fit = thurstone(study(4))
    found = fit.bootstrap(300).intervals(kind=kind)
    assert (found[:, 0] < fit.scale).all()
    assert (fit.scale < found[:, 1]).all()
    other = fit.to("d'").bootstrap(300).intervals(kind=kind)
    assert np.abs(other / found - np.sqrt(2)).max() < 1e-9


def test_intervals_that_hold_together_are_wider():
    found = thurstone(study(5)).bootstrap(400)
    alone, together = found.intervals(), found.intervals(simultaneous=True)
    assert (together[:, 1] - together[:, 0] > alone[:, 1] - alone[:, 0]).all()


def test_the_best_intervals_cover_the_truth():
    # The slow suite counts exactly; this sees gross errors. Marginal scale: own / sqrt(1 + 2 s²).
    truth = np.linspace(0.8, -0.8, 5) / np.sqrt(1.5)
    hits = []
    for seed in range(60):
        found = thurstone(study(100 + seed, people=30)).bootstrap(200).intervals()
        hits.append((found[:, 0] <= truth) & (truth <= found[:, 1]))
    assert 0.90 < np.mean(hits) < 0.99


def test_progress_is_told_and_may_stop():
    fit = thurstone(study(6, people=100, stimuli=20))
    shares = []
    fit.bootstrap(2000, progress=shares.append)
    assert shares == sorted(shares)
    assert all(0 <= share <= 1 for share in shares)

    def stop(_share):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        fit.bootstrap(100_000, progress=stop)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"samples": 1}, "samples is 1; allowed: a whole number, 2 to 1000000"),
        ({"samples": 2.5}, "samples is 2.5; allowed: a whole number"),
        ({"seed": -1}, "seed is -1"),
        ({"by": "pairs"}, "by is 'pairs'; allowed: people, answers"),
        ({"by": "people"}, "not known who gave the answers"),
    ],
)
def test_a_bad_bootstrap_is_refused(arguments, message):
    with pytest.raises(InputError, match=message):
        thurstone(paper()).bootstrap(**arguments)


def test_bad_questions_are_refused():
    fit = thurstone(paper())
    for call, message in (
        (lambda: fit.covariance("bayes"), "kind is 'bayes'"),
        (lambda: fit.covariance("people"), "not known who"),
        (lambda: fit.intervals(level=2), "level is 2; allowed: 0.5 to 0.9999"),
        (lambda: fit.intervals(simultaneous="scheffe"), "simultaneous is 'scheffe'"),
        (lambda: fit.difference("1", "9"), "there is no stimulus '9'"),
        (lambda: fit.to("px"), "unit is 'px'; allowed: z, d', logit, JOD, JND"),
        (lambda: fit.bootstrap(10).intervals(kind="bca"), "kind is 'bca'"),
        (lambda: thurstone(paper(), prior=-1), "prior is -1"),
        (lambda: thurstone(paper(), method="bayes"), "method is 'bayes'"),
        (lambda: thurstone(paper(), "least-squares").bootstrap(), "least-squares"),
        (lambda: thurstone([[0, 1.5], [3, 0]]).bootstrap(10), "whole"),
    ):
        with pytest.raises(InputError, match=message):
            call()


def test_one_person_has_no_clusters():
    one = study(7, people=1, spread=0.0)
    mixed = one.take(np.tile(np.arange(len(one)), 2))
    fit = thurstone(mixed, prior=1.0)
    with pytest.raises(InputError, match="those of 1 person, who cannot tell"):
        fit.bootstrap(10)


def test_large_and_small_matrices_are_inverted_alike():
    random = np.random.default_rng(3)
    half = random.standard_normal((300, 900))
    matrix = half @ half.T
    assert np.abs(inverse(matrix) @ matrix - np.eye(300)).max() < 1e-10
    small = matrix[:150, :150]
    assert np.abs(inverse(small) @ small - np.eye(150)).max() < 1e-10
    for size in (150, 300):
        with pytest.raises(InputError, match="unknown"):
            inverse(np.ones((size, size)) * 2 - np.eye(size))
