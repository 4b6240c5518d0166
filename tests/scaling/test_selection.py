"""Laws of choosing pairs: bits by another integral, balance, and less error than chance."""

from collections import Counter
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import expit, ndtr
from scipy.stats import norm

from nacreous.problem import InputError
from nacreous.scaling import Comparisons, thurstone
from nacreous.scaling.planning import selection
from nacreous.scaling.planning.bits import bits_of
from nacreous.scaling.planning.selection import next_pairs
from nacreous.scaling.planning.simulation import simulate

LABELS = tuple(str(k + 1) for k in range(12))


def entropy(p):
    return -(p * np.log2(p) + (1 - p) * np.log2(1 - p)) if 0 < p < 1 else 0.0


@pytest.mark.parametrize(("model", "chance"), [("probit", ndtr), ("logit", expit)])
@pytest.mark.parametrize(("mean", "variance"), [(0.0, 0.1), (0.7, 1.5), (-2.0, 0.5), (1.0, 2.0)])
def test_bits_are_the_mutual_information(model, chance, mean, variance):
    lead = norm(mean, np.sqrt(variance))

    def average(of):
        return quad(lambda x: lead.pdf(x) * of(chance(x)), mean - 9, mean + 9, epsabs=1e-9)[0]

    found = bits_of(np.array([mean]), np.array([variance]), model)[0]
    expected = entropy(average(lambda p: p)) - average(entropy)
    assert found == pytest.approx(expected, abs=1e-4)


def test_what_is_known_tells_nothing():
    assert bits_of(np.array([0.0, 1.0]), np.zeros(2)) == pytest.approx([0, 0], abs=1e-12)


def test_the_pair_that_was_asked_least_is_next():
    counts = np.full((4, 4), 20) - 20 * np.eye(4, dtype=int)
    counts[1, 2] = counts[2, 1] = 0
    [pair] = next_pairs(counts)
    assert {pair.left, pair.right} == {"2", "3"}


def test_a_stimulus_without_answers_is_next():
    [pair] = next_pairs([("a", "b"), ("b", "a")] * 10, stimuli=["a", "b", "c"])
    assert "c" in (pair.left, pair.right)


def test_a_pair_whose_answer_is_certain_is_not_asked():
    counts = np.array([[0, 20, 40], [20, 0, 40], [0, 0, 0]])
    pairs = next_pairs(counts, 4, prior=1.0)  # how far apart unanimous ones may be
    assert {pair.left for pair in pairs} | {pair.right for pair in pairs} == {"1", "2"}


def test_a_tree_reaches_every_stimulus_and_closes_no_circle():
    pairs = next_pairs(stimuli=LABELS, batch=11, method="tree", seed=3)
    parts = {label: label for label in LABELS}

    def top(label):
        return label if parts[label] == label else top(parts[label])

    for pair in pairs:
        assert top(pair.left) != top(pair.right)
        parts[top(pair.left)] = top(pair.right)
    assert len({top(label) for label in LABELS}) == 1


def test_stimuli_in_another_order_get_the_same_pair():
    answers = simulate({"a": 1.0, "b": 0.5, "c": -1.0, "d": 0.0}, people=3, seed=5)
    [one], [two] = (next_pairs(answers, stimuli=order) for order in (list("abcd"), list("dcba")))
    assert {one.left, one.right} == {two.left, two.right}
    assert one.bits == pytest.approx(two.bits)


@pytest.mark.parametrize("method", ["greedy", "tree"])
def test_all_are_asked_alike_before_anything_is_known(method):
    pairs = next_pairs(stimuli=LABELS, batch=66, method=method)
    asked = Counter(label for pair in pairs for label in (pair.left, pair.right))
    assert set(asked) == set(LABELS)
    if method == "greedy":
        assert max(asked.values()) - min(asked.values()) <= 3


@pytest.mark.parametrize("method", ["greedy", "tree", "drawn"])
def test_each_stimulus_stands_on_both_sides_alike(method):
    pairs = next_pairs(stimuli=LABELS, batch=132, method=method)
    lean = Counter(pair.left for pair in pairs)
    lean.subtract(pair.right for pair in pairs)
    assert max(abs(count) for count in lean.values()) <= 3


def test_a_pair_shown_one_way_is_next_shown_the_other():
    answers = simulate([0.0, 0.0], people=1, repeats=7, seed=2)
    on_left = Counter(answers.stimuli[k] for k in answers.left)
    [pair] = next_pairs(answers)
    assert pair.left == min(on_left, key=on_left.get)


def test_same_arguments_same_pairs_and_another_seed_others():
    one, same, other = (next_pairs(stimuli=LABELS, batch=5, seed=seed) for seed in (1, 1, 2))
    assert one == same
    assert one != other


@pytest.mark.parametrize("method", ["greedy", "tree", "drawn"])
def test_one_person_is_shown_no_pair_twice_in_a_batch(method):
    answers = simulate([0.0, 0.1, 5.0, 9.0], people=40, seed=1)
    often = Counter(frozenset((p.left, p.right)) for p in next_pairs(answers, 6, method=method))
    assert max(often.values()) > 1, "or there is nothing to test"
    once = next_pairs(answers, 6, method=method, distinct=True)
    assert len({frozenset((p.left, p.right)) for p in once}) == 6
    with pytest.raises(InputError, match="batch is 7; allowed: 1 to 6, the distinct pairs"):
        next_pairs(answers, 7, method=method, distinct=True)


def test_bits_fall_along_a_greedy_batch():
    bits = [pair.bits for pair in next_pairs(stimuli=LABELS, batch=200)]
    assert all(later <= earlier + 1e-6 for earlier, later in pairwise(bits))
    assert bits[-1] < bits[0]


def test_pairs_are_drawn_with_chances_in_proportion_to_their_bits(monkeypatch):
    """Of the first pair of a batch, whose bits are those before it."""
    answers = simulate([0.0, 0.3, 1.5, 1.6], people=12, seed=5)
    counts = answers.comparisons()
    known = selection._posterior(counts.stimuli, counts, "probit", "hierarchical")
    monkeypatch.setattr(selection, "_posterior", lambda *_: known)  # no seed moves it
    drawn = Counter()
    for seed in range(800):
        [pair] = next_pairs(answers, method="drawn", seed=seed)
        drawn[frozenset((pair.left, pair.right)), pair.bits] += 1
    total = sum(bits for _, bits in drawn)
    assert len(drawn) == 6
    for (_, bits), often in drawn.items():
        assert often / 800 == pytest.approx(bits / total, abs=4 * np.sqrt(0.25 / 800))
    assert max(bits for _, bits in drawn) > 1.5 * min(bits for _, bits in drawn)


def squared_error(method, truth, answers, seed):
    """Of the scale after so many simulated answers, in batches of eleven."""
    random = np.random.default_rng(seed)
    counts = np.zeros((12, 12))
    for batch in range(answers // 11):
        if method == "random":
            pairs = [random.choice(12, 2, replace=False) for _ in range(11)]
        else:
            data = Comparisons.of_counts(counts, stimuli=LABELS) if batch else None
            chosen = next_pairs(data, 11, stimuli=LABELS, method=method, seed=seed)
            pairs = [(int(pair.left) - 1, int(pair.right) - 1) for pair in chosen]
        for i, j in pairs:
            won = truth[i] - truth[j] + random.standard_normal() > 0
            counts[(i, j) if won else (j, i)] += 1
    fit = thurstone(Comparisons.of_counts(counts, stimuli=LABELS), prior="hierarchical")
    return np.mean((fit.scale - truth) ** 2)


def mean_error(method):
    """Over 80 simulated studies of 12 stimuli with 110 answers each."""
    errors = []
    for study in range(80):
        truth = np.random.default_rng(study).standard_normal(12)
        errors.append(squared_error(method, truth - truth.mean(), 110, 500 + study))
    return np.mean(errors)


def test_chosen_pairs_leave_less_error_than_random_ones():
    """By an eighth in 240 studies, with the same fit; the share's standard error is 6 % there."""
    chosen = [mean_error(method) for method in ("greedy", "tree")]
    assert np.mean(chosen) < mean_error("random")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({}, "neither data nor stimuli"),
        ({"stimuli": ["a"]}, "1 stimuli"),
        ({"stimuli": ["a", "b"], "batch": 0}, "batch is 0"),
        (
            {"stimuli": ["a", "b"], "method": "asap"},
            "method is 'asap'; allowed: greedy, tree, drawn",
        ),
        ({"stimuli": ["a", "b"], "prior": 0}, "prior is 0"),
        ({"stimuli": ["a", "b"], "prior": None}, "prior is None"),
        ({"stimuli": ["a", "b"], "prior": "flat"}, "prior is 'flat'"),
        ({"stimuli": ["a", "b"], "model": "gauss"}, "model is 'gauss'"),
        ({"data": [("a", "x")], "stimuli": ["a", "b"]}, "the data have the stimulus 'x'"),
        ({"stimuli": [str(k) for k in range(2001)]}, "2001 stimuli"),
    ],
)
def test_bad_values_are_refused_in_one_line(arguments, message):
    with pytest.raises(InputError) as refusal:
        next_pairs(**arguments)
    assert message in str(refusal.value)
