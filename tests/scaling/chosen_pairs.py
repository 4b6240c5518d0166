"""Simulated studies whose pairs are chosen while they run, no data of people."""

from dataclasses import dataclass

import numpy as np

from nacreous.problem import InputError
from nacreous.scaling import Answers, Comparisons, next_pairs, thurstone

FITS = {
    "likelihood": {},
    "hierarchical": {"prior": "hierarchical"},
    "bias-reduced": {"method": "bias-reduced"},
}


@dataclass
class Figures:
    """Sums over studies; truth and estimate have mean 0 in each."""

    studies: int = 0
    products: float = 0.0
    truths: float = 0.0
    estimates: float = 0.0
    errors: float = 0.0
    held: float = 0.0
    refused: int = 0

    def add(self, truth, fit, kind):
        """A study more; kind: of the errors of which intervals of all differences are made."""
        self.studies += 1
        self.products += truth @ fit.scale
        self.truths += truth @ truth
        self.estimates += fit.scale @ fit.scale
        self.errors += np.mean((fit.scale - truth) ** 2)
        place = {label: at for at, label in enumerate(fit.stimuli)}
        inside = [
            one.low <= truth[place[one.first]] - truth[place[one.second]] <= one.high
            for one in fit.differences(simultaneous="none", kind=kind)
        ]
        self.held += np.mean(inside)

    @property
    def truth_on_estimate(self):
        return self.products / self.estimates

    @property
    def estimate_on_truth(self):
        return self.products / self.truths

    @property
    def coverage(self):
        return self.held / self.studies

    @property
    def squared_error(self):
        return self.errors / self.studies


def answered(method, truth, people, pairs, seed, own=0.0):
    """Answers of people who enter one after the other, each about so many pairs.

    method: of `next_pairs`, or "lots". own: spread of values that people have of their own, in z.
    """
    count = len(truth)
    labels = [f"s{k:02d}" for k in range(count)]
    lots, senses = np.random.default_rng([seed, 1]), np.random.default_rng([seed, 2])
    every = np.stack(np.triu_indices(count, 1), axis=1)
    wins = np.zeros((count, count))
    rows = []
    for person in range(people):
        if method == "lots":
            chosen = every[lots.choice(len(every), pairs, replace=False)]
        else:
            so_far = Comparisons.of_counts(wins, stimuli=labels) if person else None
            entry = int(lots.integers(2**31))
            found = next_pairs(
                so_far, pairs, stimuli=labels, method=method, seed=entry, distinct=True
            )
            chosen = np.array([(int(one.left[1:]), int(one.right[1:])) for one in found])
        values = truth + own * senses.standard_normal(count)
        for i, j in chosen.tolist():
            first = values[i] - values[j] + senses.standard_normal() > 0
            wins[(i, j) if first else (j, i)] += 1
            rows.append((person, i, j, 1 if first else -1))
    return Comparisons.of_counts(wins, stimuli=labels), rows, labels


def answers_of(rows, labels):
    """The same with who gave them."""
    return Answers.of_table(
        {
            "person": [f"p{row[0]}" for row in rows],
            "left": [labels[row[1]] for row in rows],
            "right": [labels[row[2]] for row in rows],
            "chosen": [labels[row[1] if row[3] > 0 else row[2]] for row in rows],
        },
        sided=False,
    )


def figures(method, fits, count, people, pairs, seeds, *, own=0.0, known=True, spread=1.0):
    """Figures by fit, over studies with stimuli drawn from a normal distribution.

    known: whether the answers name their people, over whom errors then are; own: as in `answered`.
    The truth is the average answer's: people with values of their own differ by more.
    """
    found = {name: Figures() for name in fits}
    for seed in seeds:
        truth = spread * np.random.default_rng([seed, 0]).standard_normal(count)
        counts, rows, labels = answered(method, truth, people, pairs, seed, own)
        average = (truth - truth.mean()) / np.sqrt(1 + 2 * own**2)
        data = answers_of(rows, labels) if known else counts
        for name in fits:
            try:
                fit = thurstone(data, ties=False, **FITS[name])
            except InputError:  # the most likely scale of few answers may have no end
                found[name].refused += 1
                continue
            found[name].add(average, fit, "people" if known else "expected")
            if known:
                alone = found.setdefault(f"{name}, alone", Figures())
                alone.add(average, fit, "expected")
    return found
