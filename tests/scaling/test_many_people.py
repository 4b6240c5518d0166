"""What is worked out for all people at once is what each person's own answers say."""

import numpy as np
import pytest

import nacreous as nc
from nacreous.scaling.check.person import rows_by_person, triads_by_person
from nacreous.scaling.check.triads import circular_triads
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.fit.case_v import thurstone
from nacreous.scaling.fit.clustering import _common_degrees, _information
from nacreous.scaling.fit.errors import errors_of
from nacreous.scaling.fit.existence import pair_model


@pytest.fixture(scope="module")
def answers() -> Answers:
    """Some of the answers of each of 12 people, so that nobody answered the same pairs."""
    made = nc.scaling.simulate(np.linspace(1, -1, 6), people=12, seed=5)
    return made.take(np.random.default_rng(1).random(len(made)) < 0.8)


@pytest.mark.parametrize("order", [False, True])
@pytest.mark.parametrize("ties", [False, True])
def test_a_persons_information_is_that_of_the_persons_own_counts(
    answers: Answers, ties: bool, order: bool
) -> None:
    size = len(answers.stimuli) + order + ties
    parameters = np.linspace(0.8, 0.2, size)
    found = _information(answers, parameters, ("probit", ties, order, None))
    for own, (_, rows) in zip(found, rows_by_person(answers), strict=True):
        counts = answers.take(rows).comparisons()
        room = pair_model(counts, "probit", ties, order, None, None)
        assert np.allclose(own, room.information(parameters, True), atol=1e-12)


def test_freedom_is_that_of_the_residuals_working_covariance(answers: Answers) -> None:
    clusters = errors_of(thurstone(answers), "people").clusters
    assert clusters is not None
    contrasts = np.eye(len(answers.stimuli)) - 1 / len(answers.stimuli)
    for contrast, found in zip(contrasts, clusters.freedom(contrasts), strict=True):
        weights = clusters.lever @ contrast
        shown = np.einsum("cij,cj->ci", clusters.seen, weights)
        own = np.diag(np.einsum("ci,ci->c", weights, shown))
        covariance = own - shown @ clusters.spread @ shown.T
        assert found == pytest.approx(np.trace(covariance) ** 2 / np.sum(covariance**2))


def test_a_persons_triads_are_those_of_the_persons_own_answers(answers: Answers) -> None:
    people = triads_by_person(answers)
    for found, (label, rows) in zip(people, rows_by_person(answers), strict=True):
        own = circular_triads(answers.take(rows))
        assert (found.person, found.answers) == (label, len(rows))
        assert found.triads.circular == own.circular
        assert found.triads.complete == own.complete
        assert set(found.triads.named) == set(own.named)


def test_people_have_the_same_pairs_whichever_side_and_order(answers: Answers) -> None:
    all_pairs = nc.scaling.simulate(np.linspace(1, -1, 4), people=5, seed=2)
    shuffled = all_pairs.take(np.random.default_rng(3).permutation(len(all_pairs)))
    assert _common_degrees(shuffled, 5, 4, sided=False) == 4
    assert _common_degrees(answers, 12, 6, sided=False) is None


def test_where_nobody_gave_much_own_corrections_change_next_to_nothing(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    made = nc.scaling.simulate(np.linspace(1, -1, 5), people=300, seed=6)
    fit = thurstone(made.take(np.random.default_rng(4).random(len(made)) < 0.7))
    contrasts = np.eye(5)[:4] - np.eye(5)[1:]
    found = errors_of(fit, "people").clusters
    monkeypatch.setattr("nacreous.scaling.fit.clustering._SMALL_SHARE", 0.0)
    exact = errors_of(fit, "people").clusters
    assert found is not None
    assert exact is not None
    assert found.degrees is not None
    assert exact.degrees is None
    variances = [np.diag(contrasts @ one.covariance @ contrasts.T) for one in (found, exact)]
    assert variances[0] == pytest.approx(variances[1], rel=0.01)
    assert np.all(found.freedom(contrasts) <= exact.freedom(contrasts))
