"""Do people share one scale: how often the test is wrong, how often right, and what BIC chooses.

    python benchmarks/persons.py             # the tables of docs/people.md, minutes
    python benchmarks/persons.py --studies 1000

Simulated people, 7 stimuli from 0.8 to -0.8 z, each of the 21 pairs once unless said otherwise.
"+-" is one Monte Carlo error. Nothing here is a test: tests/scaling/ runs a sample.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from nacreous.scaling import Answers, population, shared_scale, simulate

TRUTH = np.linspace(0.8, -0.8, 7)
Study = Callable[[int, int], Answers]


def alike(people: int, seed: int) -> Answers:
    """People who share one scale."""
    return simulate(TRUTH, people, seed=seed)


def together(first: Answers, second: Answers) -> Answers:
    """Two sets of people as one."""
    assert first.person is not None
    assert second.person is not None
    return replace(
        first,
        left=np.concatenate([first.left, second.left]),
        right=np.concatenate([first.right, second.right]),
        outcome=np.concatenate([first.outcome, second.outcome]),
        people=tuple(f"simulated {k + 1}" for k in range(len(first.people + second.people))),
        person=np.concatenate([first.person, second.person + len(first.people)]),
    )


def reversed_share(share: float) -> Study:
    """A share of the people hold the exact reverse."""

    def study(people: int, seed: int) -> Answers:
        few = round(share * people)
        most = simulate(TRUTH, people - few, seed=seed)
        return together(most, simulate(-TRUTH, few, seed=seed + 10**6))

    return study


def own_values(spread: float) -> Study:
    """Everyone has values of their own."""
    return lambda people, seed: simulate(TRUTH, people, person_spread=spread, seed=seed)


def twice(people: int, seed: int) -> Answers:
    """Every pair twice."""
    return simulate(TRUTH, people, repeats=2, seed=seed)


def remembered(people: int, seed: int) -> Answers:
    """Every pair twice, the second answer the first."""
    study = alike(people, seed)
    return study.take(np.tile(np.arange(len(study)), 2))


def unequal(people: int, seed: int) -> Answers:
    """Between 3 and 21 pairs a person."""
    study = alike(people, seed)
    assert study.person is not None
    random = np.random.default_rng(seed)
    chance = random.uniform(3 / 21, 1, people)
    return study.take(random.random(len(study)) < chance[study.person])


def sharper(people: int, seed: int) -> Answers:
    """Half of the people tell the stimuli apart twice as sharply as the others."""
    half = people // 2
    dull = simulate(0.7 * TRUTH, half, seed=seed)
    return together(dull, simulate(1.4 * TRUTH, people - half, seed=seed + 10**6))


def rejections(study: Study, people: int, studies: int) -> tuple[float, float, float]:
    """Shares of studies with p < .05: of the test, along the scale of all, across it."""
    found = [shared_scale(study(people, seed), 199) for seed in range(studies)]
    p_values = [(one.p_value, one.sharper_p_value, one.order_p_value) for one in found]
    rejected = (np.array(p_values) < 0.05).mean(axis=0)
    return float(rejected[0]), float(rejected[1]), float(rejected[2])


def error(share: float, studies: int) -> float:
    """Of a share of simulated studies."""
    return float(np.sqrt(max(share * (1 - share), 1 / studies) / studies))


def table_of_tests(studies: int) -> None:
    """Size and power."""
    rows: list[tuple[str, Study, tuple[int, ...]]] = [
        ("people who share one scale", alike, (20, 60, 104)),
        ("the same, every pair twice", twice, (20,)),
        ("the same, twice, remembered", remembered, (20,)),
        ("the same, 3 to 21 pairs a person", unequal, (60,)),
        ("a tenth reversed", reversed_share(0.1), (20, 60)),
        ("own values, sd .5", own_values(0.5), (20, 60)),
        ("own values, sd .3", own_values(0.3), (20, 60)),
        ("half of them twice as sharp", sharper, (60, 104)),
    ]
    print("| people | how many | p < .05 | sharper, or the other way round | other order |")
    print("|---|---|---|---|---|")
    for name, study, counts in rows:
        for people in counts:
            whole, along, across = rejections(study, people, studies)
            said = f"{whole:.3f} +- {error(whole, studies):.3f}"
            print(f"| {name} | {people} | {said} | {along:.2f} | {across:.2f} |", flush=True)


def table_of_choices(studies: int) -> None:
    """What is chosen, of one scale, spread and up to 4 classes, or left open."""
    few = (("spread, sd .5", own_values(0.5)), ("spread, sd 1", own_values(1.0)))
    halves = ("two opposite halves", reversed_share(0.5))
    rows: list[tuple[str, Study, int]] = [
        *((name, study, people) for people in (6, 8, 10, 15, 20) for name, study in (*few, halves)),
        ("one scale", alike, 30),
        ("spread, sd .5", own_values(0.5), 30),
        ("spread, sd 1", own_values(1.0), 30),
        ("spread, sd .5", own_values(0.5), 104),
        ("two opposite halves", reversed_share(0.5), 30),
        ("a tenth reversed", reversed_share(0.1), 30),
        ("a tenth reversed", reversed_share(0.1), 60),
    ]
    kinds = ("one scale", "spread", "classes", "spread or classes")
    print(f"\n| truth | people | {' | '.join(kinds)} |\n|---|---|---|---|---|---|")
    for name, study, people in rows:
        found = [population(study(people, seed)).kind for seed in range(studies)]
        shares = [found.count(kind) / studies for kind in kinds]
        print(
            f"| {name} | {people} | {' | '.join(f'{share:.2f}' for share in shares)} |", flush=True
        )


def seconds() -> float:
    """Processor time of the test with 999 permutations, 104 people, 21 pairs."""
    study = own_values(0.5)(104, 1)
    shared_scale(study, 99)
    times = []
    for _ in range(5):
        begin = time.process_time()
        shared_scale(study)
        times.append(time.process_time() - begin)
    return min(times)


def main() -> None:
    """Print all of it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--studies", type=int, default=200, help="a row of the first table (200)")
    parser.add_argument("--choices", type=int, default=40, help="a row of the second (40)")
    args = parser.parse_args()
    print(f"999 permutations, 104 people x 21 pairs: {seconds():.2f} s of processor time\n")
    table_of_tests(args.studies)
    table_of_choices(args.choices)


if __name__ == "__main__":
    main()
