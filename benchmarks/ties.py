"""How often the test of fit finds a misfit among ties: ties fitted, and ties counted half.

    python benchmarks/ties.py              # the table of docs/scaling.md, minutes
    python benchmarks/ties.py --studies 1000

Simulated studies of 7 stimuli from 1 to -1 z, 30 people, each of the 21 pairs once; leads below a
threshold are ties. In a bent study two neighbours, the third and the fourth, stand the other way
round when they are held against each other. "+-" is one Monte Carlo error. Nothing here is a test:
tests/scaling/ runs a sample.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator

import numpy as np

from nacreous.scaling import Answers, goodness, simulate, thurstone

VALUES = np.linspace(1, -1, 7)
PEOPLE = 30
#: The pair that a bent study turns.
BENT = (2, 3)


def studies(count: int, threshold: float, bend: float) -> Iterator[Answers]:
    """Studies whose bent pair has a lead of `-bend` z, all others their own."""
    for seed in range(count):
        answers = simulate(VALUES, PEOPLE, tie=threshold, seed=seed)
        if not bend:
            yield answers
            continue
        turned = simulate([-bend / 2, bend / 2], PEOPLE, tie=threshold, seed=seed + 10**6)
        yield _replaced(answers, turned)


def _replaced(answers: Answers, pair: Answers) -> Answers:
    """The answers with those to the bent pair taken from a study of two stimuli."""
    low, high = np.minimum(answers.left, answers.right), np.maximum(answers.left, answers.right)
    kept = ~((low == BENT[0]) & (high == BENT[1]))
    return Answers(
        answers.stimuli,
        np.concatenate([answers.left[kept], np.array(BENT)[pair.left]]),
        np.concatenate([answers.right[kept], np.array(BENT)[pair.right]]),
        np.concatenate([answers.outcome[kept], pair.outcome]),
    )


def found(made: Iterator[Answers]) -> tuple[float, float, float]:
    """The share of ties, and of studies whose misfit is found with ties fitted and counted half."""
    shares = [
        (
            (answers.outcome == 0).mean(),
            goodness(thurstone(answers, ties=True)).describes is False,
            goodness(thurstone(answers, ties=False)).describes is False,
        )
        for answers in made
    ]
    ties, fitted, half = np.mean(shares, axis=0).tolist()
    return ties, fitted, half


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--studies", type=int, default=400)
    count = parser.parse_args().studies
    print("| ties | bent pair's lead, z | found, ties fitted | found, ties counted half |")
    print("|---|---|---|---|")
    for threshold in (0.15, 0.3, 0.5):
        for bend in (0.0, 0.3, 0.6):
            ties, *shares = found(studies(count, threshold, bend))
            lead = f"{-bend:g}" if bend else "as the scale has it"
            told = [f"{one:.3f} ± {(one * (1 - one) / count) ** 0.5:.3f}" for one in shares]
            print(f"| {ties:.2f} | {lead} | {' | '.join(told)} |", flush=True)


if __name__ == "__main__":
    main()
