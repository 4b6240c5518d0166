"""How long a lot takes to sort into strands, and how much better that is than sorting and cutting.

    python benchmarks/strands.py

docs/strand.md has the table. It takes about a minute. Beside sorting and cutting stands a second
greedy way, which takes the pearl that has the closest company and that company, again and again.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.sparse.csgraph import minimum_spanning_tree

from nacreous.strand import AKOYA, Form, Lot, Population, Sorting, cut_lot, matching, sort_lot
from nacreous.strand.matching import SIZE_WEIGHT_PER_MM, looks_apart
from nacreous.strand.order import ordered

#: By name: population, pearls, form.
WIDE = AKOYA.replace({"size_mm": 7.0}, {"size_mm": 0.4})
CASES: dict[str, tuple[Population, int, Form]] = {
    "even": (AKOYA, 2000, Form(56)),
    "even, 300 pearls": (AKOYA, 300, Form(30)),
    "graduated by 0.8 mm": (WIDE, 2000, Form(56, 0.8)),
}


def apart(lot: Lot) -> NDArray[np.float64]:
    """Differences of all pairs in an even strand."""
    return looks_apart(lot) + SIZE_WEIGHT_PER_MM * np.abs(lot.size_mm[:, None] - lot.size_mm)


def closest_company(lot: Lot, form: Form) -> float:
    """Mean score of even strands, each the pearl with the closest company and that company."""
    every, left, scores = apart(lot), np.arange(len(lot)), []
    while len(left) >= form.length:
        among = every[np.ix_(left, left)]
        middle = np.argmin(np.partition(among, form.length - 1, axis=1)[:, form.length - 1])
        group = left[np.argsort(among[middle])[: form.length]]
        left = np.setdiff1d(left, group)
        strand = lot.take(group[ordered(every[np.ix_(group, group)], lot.size_mm[group], form)])
        scores.append(matching(strand, np.full(len(strand), 7.0)).score)
    return float(np.mean(scores[: len(lot) // form.length]))


def above_bound(lot: Lot, sorting: Sorting) -> float:
    """How far neighbours' differences are above those of the least tree that joins all, in mean.

    No order can have less: it is such a tree itself.
    """
    over = []
    for strand in sorting.strands:
        pearls = lot.take(strand.pearls)
        tree = minimum_spanning_tree(apart(pearls)).sum() / (len(pearls) - 1)
        over.append(strand.matching.neighbours / tree - 1)
    return float(np.mean(over))


def timed(work: Callable[[], Sorting]) -> tuple[Sorting, float, float]:
    wall, processor = time.perf_counter(), time.process_time()
    found = work()
    return found, time.perf_counter() - wall, time.process_time() - processor


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=3)
    print("| lot | score | sorted and cut | closest company | better by | seconds (processor) |")
    print("|---|---|---|---|---|---|")
    seeds = range(1, parser.parse_args().seeds + 1)
    for name, (population, count, form) in CASES.items():
        rows, over = [], []
        for seed in seeds:
            lot = population.draw(count, seed)
            sorting, wall_s, processor_s = timed(lambda lot=lot, form=form: sort_lot(lot, form))
            cut = cut_lot(lot, form).score
            even = form.graduation_mm == 0
            near = closest_company(lot, form) if even else np.nan
            rows.append([sorting.score, cut, near, 1 - sorting.score / cut, wall_s, processor_s])
            if even:
                over.append(above_bound(lot, sorting))
        score, cut, near, better, wall_s, processor_s = np.mean(rows, axis=0)
        other = "" if np.isnan(near) else f"{near:.2f}"
        print(
            f"| {name} | {score:.2f} | {cut:.2f} | {other} | {better:.0%} "
            f"({min(row[3] for row in rows):.0%} at least) | {wall_s:.1f} ({processor_s:.1f}) |"
        )
        if over:
            print(f"<!-- neighbours {np.mean(over):.0%} above the least tree -->")


if __name__ == "__main__":
    main()
