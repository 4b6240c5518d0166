"""Whether a scale exists: against its definition, and in what is said where it does not."""

from itertools import product

import numpy as np
import pytest
from scipy.optimize import linprog

from nacreous.problem import InputError
from nacreous.scaling import Answers, Comparisons, bradley_terry, thurstone
from nacreous.scaling.fit.existence import parts


def can_be_split(wins):
    """Ford's condition as it stands: some set never beats, or was never beaten by, the rest."""
    n = len(wins)
    for chosen in product([False, True], repeat=n):
        inside = np.array(chosen)
        if 0 < inside.sum() < n and not wins[np.ix_(inside, ~inside)].any():
            return True
    return False


def test_a_scale_exists_where_no_set_stands_apart():
    random = np.random.default_rng(1)
    found = {True: 0, False: 0}
    for _ in range(300):
        wins = (random.random((5, 5)) < 0.35) * random.integers(1, 4, (5, 5))
        np.fill_diagonal(wins, 0)
        if not wins.any():
            continue
        apart = can_be_split(wins)
        found[apart] += 1
        assert (len(parts(wins)) > 1) == apart
        if apart:
            with pytest.raises(InputError, match="no scale"):
                thurstone(wins)
        else:
            assert np.isfinite(thurstone(wins).scale).all()
    assert min(found.values()) > 30


def recedes(answers, ties, order):
    """Whether some direction makes no answer less likely, by a linear programme."""
    n = len(answers.stimuli)
    rows = []
    for left, right, outcome in zip(answers.left, answers.right, answers.outcome, strict=True):
        lead = np.zeros(n + 2)
        lead[left], lead[right] = 1, -1
        lead[n] = order
        width = np.eye(n + 2)[n + 1] * ties
        if outcome == 1:
            rows.append(lead - width)
        elif outcome == -1:
            rows.append(-lead - width)
        else:
            rows += [lead + width, width - lead]
    kept = [*range(1, n), *([n] if order else []), *([n + 1] if ties else [])]
    table = np.array(rows)[:, kept]
    for k in range(len(kept)):
        for sign in (1, -1):
            bounds = [(-1, 1)] * len(kept)
            bounds[k] = (sign, sign)
            if (
                linprog(np.zeros(len(kept)), -table, np.zeros(len(table)), bounds=bounds).status
                == 0
            ):
                return True
    return False


@pytest.mark.parametrize(("ties", "order"), [(False, True), (True, False), (True, True)])
def test_effects_exist_where_no_direction_is_free(ties, order):
    random = np.random.default_rng(2)
    found = {True: 0, False: 0}
    for _ in range(60):
        left = random.integers(3, size=8)
        right = (left + random.integers(1, 3, size=8)) % 3
        outcome = random.choice([1, 1, -1, 0] if ties else [1, 1, -1], size=8).astype(np.int8)
        answers = Answers(("a", "b", "c"), left, right, outcome)
        has_ties = ties and bool((outcome == 0).any())
        free = recedes(answers, has_ties, order)
        found[free] += 1
        if free:
            with pytest.raises(InputError):
                bradley_terry(answers, ties=ties, order=order)
        else:
            fit = bradley_terry(answers, ties=ties, order=order)
            assert np.isfinite(fit.scale).all()
            assert np.abs(fit.scale).max() < 50
    assert min(found.values()) > 3


def test_ties_join_what_wins_do_not():
    counts = Comparisons.of_counts([[0, 3], [0, 0]], ties=[[0, 1], [1, 0]])
    assert parts(counts) == [("1", "2")]
    assert np.isfinite(thurstone(counts).scale).all()


def test_a_long_list_of_names_is_shortened():
    wins = np.triu(np.ones((30, 30)), 1)
    wins[1:20, 1:20] = 1 - np.eye(19)
    with pytest.raises(InputError) as said:
        thurstone(wins)
    assert len(str(said.value)) < 400
    assert "\n" not in str(said.value)
    assert "and 21 more" in str(said.value)
