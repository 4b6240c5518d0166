"""Scales by likelihood and by least squares: laws, published numbers, other programs' results."""

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.special import log_ndtr, logit, ndtri

from nacreous._core import log_normal_cdf
from nacreous.problem import InputError
from nacreous.scaling import Comparisons, bradley_terry, paper, paper_proportions, thurstone
from nacreous.scaling.fit.row_means import z_of_pairs

GOLDEN = Path(__file__).parent.parent / "golden" / "thurstone"
REFERENCE = json.loads((GOLDEN / "reference.json").read_text())


def counts_for(p, n):
    return [[0, round(p * n)], [round((1 - p) * n), 0]]


def tournament(scale, answers, seed, people=None):
    """Simulated answers (winner, loser) of the probit model."""
    random = np.random.default_rng(seed)
    first = random.integers(len(scale), size=answers)
    second = (first + random.integers(1, len(scale), size=answers)) % len(scale)
    lead = np.asarray(scale)[first] - np.asarray(scale)[second]
    won = lead + random.standard_normal(answers) > 0
    winner, loser = np.where(won, first, second), np.where(won, second, first)
    return list(zip(winner.tolist(), loser.tolist(), strict=True))


def test_log_cdf_is_that_of_scipy():
    # Above 4, SciPy's own digits are fewer; the room's own tests go on there.
    x = np.concatenate((-np.logspace(-3, 5, 2000), np.linspace(-10, 4, 2001)))
    assert np.abs(log_normal_cdf(x) / log_ndtr(x) - 1).max() < 2e-14


def test_probit_is_that_of_r():
    expected = REFERENCE["probit_maximum_likelihood"]
    fit = thurstone(paper())
    assert np.abs(fit.scale - expected["scale"]).max() < 1e-5
    assert np.abs(fit.se - expected["se_expected_information"]).max() < 1e-4
    observed = np.sqrt(np.diag(fit.covariance("observed")))
    assert np.abs(observed - expected["se_observed_information"]).max() < 1e-4


def test_bradley_terry_is_that_of_r():
    expected = REFERENCE["bradley_terry_maximum_likelihood"]
    fit = bradley_terry(paper())
    assert np.abs(fit.scale - expected["scale"]).max() < 1e-5
    assert np.abs(fit.se - expected["se"]).max() < 1e-4


def test_z_of_the_printed_proportions_is_table_1():
    """z(2, 4) is printed as 0.498 where p = 0.69 gives 0.496."""
    pairs = Comparisons.of_proportions(paper_proportions(), 104).unsided()
    printed = np.loadtxt(GOLDEN / "z_published.csv", delimiter=",")
    assert len(pairs) == 21
    assert np.abs(z_of_pairs(pairs) - printed[pairs.left, pairs.right]).max() < 2.5e-3


def test_least_squares_is_table_1():
    fit = thurstone(Comparisons.of_proportions(paper_proportions(), 104), "least-squares")
    assert np.abs(fit.scale - REFERENCE["published_v"]).max() < 1e-3
    assert np.abs(fit.scale - REFERENCE["case_v_least_squares_from_p_2dec"]).max() < 1e-5
    from_counts = thurstone(paper(), "least-squares").scale
    assert np.abs(from_counts - REFERENCE["case_v_least_squares_from_counts"]).max() < 1e-5
    assert fit.ranking == ("2", "4", "3", "1", "5", "6", "7")


@pytest.mark.parametrize("p", [0.001, 0.2, 0.5, 0.84, 0.999])
def test_two_stimuli_are_as_far_apart_as_the_proportion_says(p):
    counts = counts_for(p, 1000)
    for fit, expected in (
        (thurstone(counts), ndtri(p)),
        (thurstone(counts, "least-squares"), ndtri(p)),
        (bradley_terry(counts), logit(p)),
    ):
        assert abs(fit.scale[0] - fit.scale[1] - expected) < 1e-12


@pytest.mark.parametrize("model", [thurstone, bradley_terry])
def test_labels_do_not_matter(model):
    answers = tournament([0.5, 0.1, -0.2, -0.4], 400, 1)
    turned = [(3 - winner, 3 - loser) for winner, loser in answers]
    fit, mirror = model(answers), model(turned)
    assert np.abs(fit.scale - mirror.scale[::-1]).max() < 1e-13
    assert abs(fit.log_likelihood - mirror.log_likelihood) < 1e-10


@pytest.mark.parametrize("model", [thurstone, bradley_terry])
def test_symmetric_answers_make_all_alike(model):
    fit = model((np.ones((5, 5)) - np.eye(5)) * 7)
    assert np.abs(fit.scale).max() < 1e-15
    assert np.abs(fit.proportions - 0.5).max() < 1e-15


@pytest.mark.parametrize("model", [thurstone, bradley_terry])
def test_ties_only_are_halved_or_refused(model):
    ties = Comparisons.of_counts(np.zeros((3, 3)), ties=3 * (np.ones((3, 3)) - np.eye(3)))
    assert np.abs(model(ties).scale).max() == 0
    with pytest.raises(InputError, match="ties=True"):
        model(ties, ties=True)


def test_a_unanimous_pair_is_no_trouble_where_others_hold_it():
    fit = thurstone([[0, 9, 5], [0, 0, 5], [4, 4, 0]])
    assert np.isfinite(fit.scale).all()
    assert fit.scale[0] > fit.scale[1]


def test_who_cannot_be_placed_is_named():
    with pytest.raises(InputError, match=r'no scale holds "3": was never preferred'):
        thurstone([[0, 2, 3], [1, 0, 3], [0, 0, 0]])
    with pytest.raises(InputError, match=r'"1", "2" were never compared with "3", "4"'):
        thurstone([[0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 0, 1], [0, 0, 1, 0]])
    with pytest.raises(InputError, match="no scale holds"):
        bradley_terry([("a", "b")])


def test_a_prior_always_gives_a_scale():
    fit = thurstone([[0, 9], [0, 0]], prior=1.0)
    # 9 φ(d) / Φ(d) = d / 2 with d the distance, each value half of it
    distance = fit.scale[0] - fit.scale[1]
    slope = 9 * np.exp(-0.5 * distance**2 - log_ndtr(distance)) / np.sqrt(2 * np.pi)
    assert abs(slope - distance / 2) < 1e-12


def test_a_design_of_indicators_is_no_design():
    answers = tournament([0.8, 0.0, -0.3, -0.5], 500, 2)
    free = thurstone(answers)
    columns = thurstone(answers, design=np.eye(4)[:, 1:])
    assert np.abs(free.scale - columns.scale).max() < 1e-12
    assert np.abs(free.covariance() - columns.covariance()).max() < 1e-12
    with pytest.raises(InputError, match="cannot be told apart"):
        thurstone(answers, design=np.eye(4))
    with pytest.raises(InputError, match="explains every answer"):
        thurstone([[0, 3], [0, 0]], design=[[1.0], [0.0]])


def test_least_squares_says_what_it_does_with_unanimous_and_missing_pairs():
    # 20 of 20 count as 19.5; a and c never met, so each value is that of the chain.
    half = ndtri(19.5 / 20)
    fit = thurstone([[0, 20, 0], [0, 0, 15], [0, 5, 0]], "least-squares")
    assert abs(fit.scale[0] - fit.scale[1] - half) < 1e-12
    assert abs(fit.scale[1] - fit.scale[2] - ndtri(0.75)) < 1e-12
    other = thurstone([[0, 20], [0, 0]], "least-squares", extremes=1)
    assert abs(other.scale[0] - other.scale[1] - ndtri(0.95)) < 1e-12
    with pytest.raises(InputError, match="never compared"):
        thurstone([[0, 1, 0], [1, 0, 0], [0, 0, 0]], "least-squares")
    with pytest.raises(InputError, match="extremes is 2"):
        thurstone(paper(), "least-squares", extremes=2)


@pytest.mark.parametrize("model", [thurstone, bradley_terry])
@pytest.mark.parametrize("times", [0.01, 0.7, 1e6])
def test_fractional_and_huge_counts_give_the_same_scale(model, times):
    counts = paper().matrix
    scaled = Comparisons.of_proportions(counts / np.maximum(counts + counts.T, 1), 104 * times)
    assert np.abs(model(scaled).scale - model(paper()).scale).max() < 1e-9
    assert np.abs(model(scaled).se * np.sqrt(times) / model(paper()).se - 1).max() < 1e-9


def test_thousands_of_stimuli_in_a_ring_are_placed():
    ring = [(i, (i + 1) % 5000) for i in range(5000)]
    assert np.abs(bradley_terry(ring).scale).max() < 1e-9
    chain = ring[:-1] + [(b, a) for a, b in ring[:-1]]
    assert np.abs(thurstone(chain).scale).max() < 1e-9
    with pytest.raises(InputError, match=r'no scale holds "4999".*there are 5000 such sets'):
        bradley_terry(ring[:-1])


def test_parameters_of_another_model_are_refused_and_do_not_panic():
    room = thurstone(paper()).pair_model
    for ask in (lambda p: room.information(p, True), room.log_likelihood):
        with pytest.raises(InputError, match="parameters has 3 rows; allowed: 7"):
            ask(np.zeros(3))


def test_a_width_that_ties_cannot_have_is_refused_and_does_not_hang():
    counts = np.ones((3, 3)) - np.eye(3)
    fit = thurstone(Comparisons.of_counts(counts, ties=counts), ties=True)
    room, below = fit.pair_model, np.array([0.0, 0.0, 0.0, -0.1])
    for ask in (lambda p: room.information(p, True), room.log_likelihood):
        with pytest.raises(InputError, match=r"width of ties is -0\.1; allowed: 0 or more"):
            ask(below)
    with pytest.raises(InputError, match=r"width of ties is -0\.1; allowed: 0 or more"):
        room.probabilities(np.zeros(2), -0.1)
