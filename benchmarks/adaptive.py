"""Adaptive pairs: how many answers they save, by simulated observers.

    python benchmarks/adaptive.py           # five minutes; the figures of docs/study.md

For each spread of the scale, and for observers who enter some at a time: how many times the answers
pairs by lot need for the same standard error, and the same squared error, of the steps between
neighbours; and how often the intervals of 95 % hold the truth.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent.parent))
from tests.study.test_adaptive import KINDS, simulated

STUDIES = 60
#: Spread of the scale in z, and how many observers enter at a time.
CASES = ((2, 1), (3, 1), (6, 1), (3, 10), (3, 40))


def main() -> None:
    print("spread  at a time  by standard error  by true error  95 % intervals hold")
    for spread, together in CASES:
        value = np.linspace(0, spread, 12)
        found = [
            [simulated(kind, value, seed, together) for seed in range(STUDIES)] for kind in KINDS
        ]
        # [kind, study, step]
        se, error = (
            np.array([[study[part] for study in kind] for kind in found]) for part in (0, 1)
        )
        by_se, by_error = (np.divide(*np.mean(part**2, axis=(1, 2))) for part in (se, error))
        held = np.mean(np.abs(error[1]) < 1.96 * se[1])
        print(
            f"{spread:4d} z  {together:9d}  {by_se:17.2f}  {by_error:13.2f}  {held:20.3f}",
            flush=True,
        )


if __name__ == "__main__":
    main()
