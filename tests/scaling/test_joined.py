"""Stimuli that no chain of answers joins are never ranked against each other."""

from itertools import combinations

import numpy as np
import pytest

from nacreous.problem import InputError
from nacreous.scaling import Answers, analyse, next_pairs, thurstone
from nacreous.scaling.data.given import comparisons_of

TRUTH = {"s0": 2.2, "s1": 2.0, "s2": 1.8, "s3": -1.8, "s4": -2.0, "s5": -2.2}
WHO = r'"s0", "s1", "s2" were never compared with "s3", "s4", "s5"'


def apart(people: int, join: bool = False) -> Answers:
    """People who compare the first three and the last three; one more pair if they are to join."""
    random = np.random.default_rng(1)
    sets = (("s0", "s1", "s2"), ("s3", "s4", "s5"))
    pairs = [pair for one in sets for pair in combinations(one, 2)] + [("s2", "s3")] * join
    rows = [
        (left, right, left if TRUTH[left] - TRUTH[right] > random.normal() else right, f"p{person}")
        for person in range(people)
        for left, right in pairs
    ]
    return Answers.of_table(
        dict(zip(("left", "right", "chosen", "person"), zip(*rows, strict=True), strict=True))
    )


@pytest.mark.parametrize("prior", [None, 1.0, "hierarchical"])
@pytest.mark.parametrize("counted", [False, True])
def test_no_report_ranks_what_no_answers_join(prior, counted):
    answers = apart(20)
    data = comparisons_of(answers) if counted else answers
    with pytest.raises(InputError, match=WHO):
        analyse(data, prior=prior, bootstrap=0)


@pytest.mark.parametrize("method", ["maximum-likelihood", "bias-reduced"])
def test_the_advice_is_answers_and_never_a_prior(method):
    with pytest.raises(InputError, match=WHO) as problem:
        thurstone(apart(20), method)
    assert "prior" not in str(problem.value)


@pytest.mark.parametrize("prior", [1.0, "hierarchical"])
def test_a_fit_with_a_prior_says_first_that_it_guesses(prior):
    fit = thurstone(apart(20), prior=prior)
    first = str(fit).splitlines()[0]
    assert "never compared" in first
    assert "the prior's guess" in first


@pytest.mark.parametrize("prior", [1.0, "hierarchical"])
def test_people_tell_no_margins_across_what_they_never_compared(prior):
    fit = thurstone(apart(20), prior=prior)
    for call in (fit.covariance, fit.intervals, fit.differences, fit.neighbours):
        with pytest.raises(InputError, match=WHO):
            call()
    # By the model alone the distance is as open as the prior leaves it.
    across = fit.difference("s0", "s3", kind="expected")
    within = fit.difference("s0", "s1", kind="expected")
    assert across.high - across.low > 1.5 * (within.high - within.low)


def test_no_bootstrap_draws_what_a_prior_holds_still():
    fit = thurstone(apart(20), prior=1.0)
    for by in ("people", "answers"):
        with pytest.raises(InputError, match=WHO):
            fit.bootstrap(10, by)


def test_one_answer_that_joins_them_is_enough_for_a_posterior():
    found = analyse(apart(20, join=True), prior="hierarchical", bootstrap=0)
    assert set(found.ranking[:3]) == {"s0", "s1", "s2"}


def test_pairs_that_would_join_them_can_still_be_chosen():
    assert len(next_pairs(apart(20), 3)) == 3
