"""How often groups are said to differ in places that answer in different ways.

    python benchmarks/groups.py --studies 400

docs/scaling.md has the table. It takes one or two minutes.
"""

from __future__ import annotations

import argparse
from collections import Counter
from typing import NamedTuple

from nacreous.scaling import compare_groups, simulate

TRUTH = {"A": 1.0, "B": 0.4, "C": 0.0, "D": -0.4, "E": -1.0}
MOVED = {"A": 0.8, "B": 0.7, "C": 0.0, "D": -0.4, "E": -1.1}


class Case(NamedTuple):
    """Two groups: people, threshold of ties and pull of the side of each; the second's places."""

    people: tuple[int, int]
    tie: tuple[float, float]
    side: tuple[float, float] = (0.0, 0.0)
    own: float = 0.0
    second: dict[str, float] = TRUTH


CASES = [
    Case((25, 25), (0.5, 0.12)),
    Case((25, 25), (0.5, 0.12), own=0.5),
    Case((25, 25), (0.5, 0.0)),
    Case((25, 25), (0.3, 0.3), side=(0.5, -0.3), own=0.3),
    Case((30, 30), (0.0, 0.0), side=(1.2, 0.0)),
    Case((8, 8), (0.5, 0.12)),
    Case((12, 40), (0.5, 0.12)),
    Case((40, 12), (0.5, 0.12)),
    Case((25, 25), (0.3, 0.3), second=MOVED),
    Case((25, 25), (0.0, 0.0), second=MOVED),
]


def rejected(case: Case, studies: int) -> dict[str, float]:
    """The share of studies in which each test of places rejects, and any way of answering."""
    found: Counter[str] = Counter()
    for study in range(studies):
        groups = {
            name: simulate(
                places,
                case.people[at],
                tie=case.tie[at],
                order=case.side[at],
                person_spread=case.own,
                seed=2 * study + at + 1,
            )
            for at, (name, places) in enumerate({"x": TRUTH, "y": case.second}.items())
        }
        compared = compare_groups(groups, same_people=False, permutations=199)
        found.update(test.name for test in compared.tests if test.p_value <= 0.05)
        found["ways"] += any(style.differs() for style in compared.styles)
    return {name: count / studies for name, count in found.items()}


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--studies", type=int, default=400)
    asked = parser.parse_args()
    for one in CASES:
        print(one, {name: round(share, 3) for name, share in rejected(one, asked.studies).items()})
