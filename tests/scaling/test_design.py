"""Designs: balanced, joined, the same for the same seed, and nothing shown twice in a row."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import nacreous as nc
from nacreous.scaling import PairDesign, cyclic_design, full_design, random_design

SEEDS = st.integers(0, 2**63 - 1)


def refusal(act: Any) -> str:
    with pytest.raises(nc.InputError) as caught:
        act()
    message = str(caught.value)
    assert "\n" not in message
    return message


def places(design: PairDesign) -> np.ndarray:
    """How often each stimulus is left and right, [side, stimulus]."""
    count = len(design.stimuli)
    return np.stack([np.bincount(side, minlength=count) for side in (design.left, design.right)])


def is_joined(design: PairDesign) -> bool:
    reached = {design.stimuli[0]}
    for _ in design.stimuli:
        reached |= {label for pair in design.pairs if reached & set(pair) for label in pair}
    return reached == set(design.stimuli)


def pair_sets(design: PairDesign) -> list[frozenset[str]]:
    return [frozenset(pair) for pair in design.pairs]


@given(st.integers(2, 14), SEEDS)
def test_a_full_design_has_every_pair_once(count, seed):
    design = full_design(count, seed)
    assert len(set(pair_sets(design))) == len(design) == count * (count - 1) // 2


@given(st.integers(2, 14), SEEDS)
def test_lefts_and_rights_differ_by_one_at_most(count, seed):
    left, right = places(full_design(count, seed))
    assert np.abs(left - right).max() <= 1
    if count % 2:  # then each has an even number of pairs
        assert (left == right).all()


@given(st.integers(5, 14), SEEDS)
def test_no_stimulus_is_shown_twice_in_a_row(count, seed):
    assert full_design(count, seed).repetitions == 0


@given(st.integers(5, 9), st.integers(2, 4), SEEDS)
def test_repeats_exchange_the_sides(count, repeats, seed):
    design = full_design(count, seed, repeats)
    once = len(design) // repeats
    for time in range(1, repeats):
        before = set(design.pairs[(time - 1) * once : time * once])
        after = {(right, left) for left, right in design.pairs[time * once : (time + 1) * once]}
        assert before == after
    assert design.repetitions == 0


@given(st.integers(3, 30), st.data(), SEEDS)
def test_in_a_cyclic_design_everyone_meets_as_many(count, data, seed):
    each = data.draw(st.integers(2, count - 1).filter(lambda each: each * count % 2 == 0))
    design = cyclic_design(count, each, seed)
    left, right = places(design)
    assert set((left + right).tolist()) == {each}
    assert len(set(pair_sets(design))) == len(design) == each * count // 2
    assert is_joined(design)
    assert np.abs(left - right).max() <= 1


@given(st.integers(2, 30), st.data(), SEEDS)
def test_a_random_design_joins_all_with_the_pairs_asked_for(count, data, seed):
    pairs = data.draw(st.integers(count - 1, count * (count - 1) // 2))
    design = random_design(count, pairs, seed)
    assert len(set(pair_sets(design))) == len(design) == pairs
    assert is_joined(design)
    left, right = places(design)
    assert np.abs(left - right).max() <= 1


def test_a_random_design_of_thousands_is_made_from_draws():
    design = random_design(3000, pairs=20_000)
    assert len(set(pair_sets(design))) == 20_000
    assert np.abs(np.subtract(*places(design))).max() <= 1


def test_every_pair_outside_the_chain_is_as_likely():
    """4 stimuli, 4 pairs: by symmetry each of the 6 pairs is in 4/6 of the designs."""
    seen = np.zeros((4, 4))
    for seed in range(1500):
        for a, b in map(sorted, random_design(4, pairs=4, seed=seed).pairs):
            seen[int(a) - 1, int(b) - 1] += 1
    share = seen[np.triu_indices(4, 1)] / 1500
    assert np.abs(share - 2 / 3).max() < 4 * np.sqrt(2 / 9 / 1500)


def test_the_same_seed_gives_the_same_design_and_another_another():
    assert full_design(8, seed=3).pairs == full_design(8, seed=3).pairs
    assert full_design(8, seed=3).pairs != full_design(8, seed=4).pairs
    assert cyclic_design(8, 3, seed=3).pairs != cyclic_design(8, 3, seed=4).pairs


def test_labels_may_be_given():
    assert set(full_design(["akoya", "tahiti", "keshi"]).stimuli) == {"akoya", "tahiti", "keshi"}


@pytest.mark.parametrize(
    ("act", "message"),
    [
        (lambda: full_design(1), "stimuli is 1; allowed: a whole number, 2 to 10000"),
        (lambda: full_design(True), "stimuli is True; allowed: a whole number, 2 to 10000"),
        (lambda: full_design(7.0), "stimuli is 7.0; allowed: a whole number, 2 to 10000"),
        (lambda: full_design("abc"), "stimuli is 'abc'; allowed: a list of labels"),
        (lambda: full_design(["a", "a"]), 'stimuli[1] is "a" again; allowed: each label once'),
        (lambda: full_design(["a"]), 'stimuli: 1 stimuli, "a"; allowed: 2 to 10000'),
        (lambda: full_design(["a", ""]), "stimuli[1] is 0 characters long; allowed: 1 to 200"),
        (lambda: full_design(5, seed=-1), "seed is -1; allowed: a whole number, 0 to 92233"),
        (lambda: full_design(5, repeats=0), "repeats is 0; allowed: a whole number, 1 to 100"),
        (lambda: full_design(5000), "the design has 12497500 pairs; allowed: up to 1000000"),
        (lambda: cyclic_design(2, 2), "2 stimuli have one pair only; allowed: 3 or more"),
        (lambda: cyclic_design(7, 1), "each is 1; allowed: a whole number, 2 to 6"),
        (lambda: cyclic_design(7, 7), "each is 7; allowed: a whole number, 2 to 6"),
        (lambda: cyclic_design(7, 3), "each is 3 and there are 7 stimuli, both odd, which leaves"),
        (lambda: random_design(7, 5), "pairs is 5; allowed: a whole number, 6 to 21"),
        (lambda: random_design(7, 22), "pairs is 22; allowed: a whole number, 6 to 21"),
    ],
)
def test_what_no_design_has_is_refused(act, message):
    assert refusal(act).startswith(message)
