"""How often intervals over people hold the truth, and how often equals are told apart.

    python benchmarks/people.py [--studies 250] [--method least-squares]

Simulated studies of 6 stimuli in 3 pairs of equals, each person with values of their own (standard
deviation 0.5 z), 5 repeats of all 15 pairs; in "unequal" designs half of the people answer a fifth
of the pairs once. The truth of the average answer is value / sqrt(1 + 2 sd^2). "together": share of
studies in which any of the 3 pairs of equals is told apart among the 5 neighbours, by Holm.
"""

from __future__ import annotations

import argparse

import numpy as np

from nacreous.problem import InputError
from nacreous.scaling import Answers, simulate, thurstone

VALUES = np.array([0.6, 0.6, 0.0, 0.0, -0.6, -0.6])
SPREAD = 0.5
#: People, repeats, whether half of the people answer a fifth.
DESIGNS = (
    (3, 5, False), (3, 10, False), (4, 5, False), (5, 5, False), (10, 5, False),
    (3, 10, True), (5, 5, True), (10, 5, True),
)  # fmt: skip


def study(people: int, repeats: int, unequal: bool, seed: int) -> Answers:
    """One simulated study."""
    answers = simulate(VALUES, people, repeats=repeats, person_spread=SPREAD, seed=seed)
    if not unequal or answers.person is None:
        return answers
    chance = np.random.default_rng(seed).random(len(answers))
    return answers.take((answers.person % 2 == 0) | (chance < 0.2))


def looked_at(answers: Answers, method: str) -> tuple[float, bool, float]:
    """Share of the 15 differences held, whether equals are told apart, mean width in z."""
    fit = thurstone(answers, method=method)
    truth = VALUES / np.sqrt(1 + 2 * SPREAD**2)
    place = {label: k for k, label in enumerate(fit.stimuli)}
    held, width = [], []
    for one in fit.differences(simultaneous="none"):
        lead = truth[place[one.first]] - truth[place[one.second]]
        held.append(one.low <= lead <= one.high)
        width.append(one.high - one.low)
    neighbours = fit.neighbours()
    apart = any(
        one.p_value < 0.05 and VALUES[place[one.first]] == VALUES[place[one.second]]
        for one in neighbours
    )
    return float(np.mean(held)), apart, float(np.mean(width))


def main() -> None:
    """Print a line for each design."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--studies", type=int, default=250)
    parser.add_argument("--method", default="maximum-likelihood")
    asked = parser.parse_args()
    studies = asked.studies
    print("people repeats design   held  +-     together  width  refused")
    for people, repeats, unequal in DESIGNS:
        found = []
        for seed in range(studies):
            try:
                found.append(looked_at(study(people, repeats, unequal, seed), asked.method))
            except InputError:
                continue
        held, apart, width = (np.array(column, float) for column in zip(*found, strict=True))
        error = held.std() / np.sqrt(len(held))
        design = "unequal" if unequal else "equal"
        print(
            f"{people:6} {repeats:7} {design:8} {held.mean():.3f} {error:.3f}  {apart.mean():8.3f} "
            f"{width.mean():6.2f} {studies - len(found):7}"
        )


if __name__ == "__main__":
    main()
