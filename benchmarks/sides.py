"""How often people of one scale are said to judge differently whom the side draws differently.

    python benchmarks/sides.py --studies 100

docs/people.md has the table. It takes about two minutes.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from nacreous.scaling import Answers, Grouping, person_covariates, shared_scale, simulate

TRUTH = [1.0, 0.5, 0.0, -0.5, -1.0]
OTHER = [0.7, 0.8, 0.0, -0.4, -1.1]
EACH = 25

#: By name: the scales of two groups, and the mean and the spread of the first one's pulls, in z.
CASES = {
    "no pull": (TRUTH, TRUTH, 0.0, 0.0),
    "1.2 and 0": (TRUTH, TRUTH, 1.2, 0.0),
    "sd 1 and 0": (TRUTH, TRUTH, 0.0, 1.0),
    "no pull, 1.7 times as sharp": (TRUTH, [1.7 * value for value in TRUTH], 0.0, 0.0),
    "no pull, other places": (TRUTH, OTHER, 0.0, 0.0),
}


def people(case: tuple[list[float], list[float], float, float], study: int) -> Iterator[Answers]:
    """The answers of each person of a study."""
    first, second, mean, spread = case
    random = np.random.default_rng(study)
    for at in range(2 * EACH):
        scale, pull = (first, random.normal(mean, spread)) if at < EACH else (second, 0.0)
        yield simulate(scale, 1, order=pull, seed=1000 * study + at)


def study_of(case: tuple[list[float], list[float], float, float], study: int) -> Answers:
    """All answers of a study, with a column that tells the two groups apart."""
    parts = list(people(case, study))
    person = np.repeat(np.arange(len(parts)), [len(part) for part in parts])
    return replace(
        parts[0],
        left=np.concatenate([part.left for part in parts]),
        right=np.concatenate([part.right for part in parts]),
        outcome=np.concatenate([part.outcome for part in parts]),
        people=tuple(str(at) for at in range(len(parts))),
        person=person,
        groups={"g": Grouping(("x", "y"), (person >= EACH).astype(np.int64))},
    )


def rejected(case: tuple[list[float], list[float], float, float], studies: int) -> dict[str, float]:
    """The share of studies in which each test has p <= 0.05."""
    found: Counter[str] = Counter()
    for study in range(studies):
        answers = study_of(case, study)
        column = person_covariates(answers, permutations=199)[0]
        shared = shared_scale(answers, permutations=199)
        found["column"] += column.p_value <= 0.05
        found["side"] += column.side_p_value is not None and column.side_p_value <= 0.05
        found["shared scale"] += shared.p_value <= 0.05
        found["sharper"] += shared.sharper_p_value <= 0.05
    return {name: count / studies for name, count in found.items()}


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--studies", type=int, default=100)
    asked = parser.parse_args()
    for name, one in CASES.items():
        print(name, rejected(one, asked.studies), flush=True)
