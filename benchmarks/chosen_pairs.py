"""Pairs chosen while a study runs: whether they stretch its scale, by simulated observers.

    python benchmarks/chosen_pairs.py           # an hour; the figures of docs/scaling.md
    python benchmarks/chosen_pairs.py 40        # so many studies of each kind

For each design, way of choosing and fit: the slope of the estimate on the truth and of the truth on
the estimate, how often 95 % intervals of all differences hold it, and the mean squared error.
Where people are known, intervals are over people; "alone" takes answers as independent.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent))
from tests.scaling.chosen_pairs import figures

STUDIES = 400
#: Stimuli, people (without names: batches), pairs of each, whether people are named, own spread.
DESIGNS = (
    (20, 19, 10, False, 0.0),
    (20, 20, 20, True, 0.0),
    (20, 30, 38, True, 0.0),
    (20, 20, 20, True, 0.5),
)
WAYS = {
    "lots": ("hierarchical", "bias-reduced"),
    "greedy": ("hierarchical", "likelihood", "bias-reduced"),
    "drawn": ("hierarchical", "bias-reduced"),
}


def main() -> None:
    studies = int(sys.argv[1]) if len(sys.argv) > 1 else STUDIES
    print("design        own  pairs   fit                   est|truth  truth|est  cover  error")
    for count, people, pairs, known, own in DESIGNS:
        for method, fits in WAYS.items():
            found = figures(
                method, fits, count, people, pairs, range(studies), own=own, known=known
            )
            for name, one in found.items():
                print(
                    f"{count}, {people} x {pairs:<3d} {own:4.1f}  {method:6s}  {name:20s}"
                    f"  {one.estimate_on_truth:9.3f}  {one.truth_on_estimate:9.3f}"
                    f"  {one.coverage:.3f}  {one.squared_error:.4f}",
                    flush=True,
                )


if __name__ == "__main__":
    main()
