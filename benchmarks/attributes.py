"""How often `fit_attributes` calls a weight that is 0 more than chance, and finds the others.

    python benchmarks/attributes.py [--studies 60] [--few 400]

Simulated studies of 12 attributes correlated by 0.5: weights 0.5, 0.35 and 0.25, the rest 0; the
first eight differ from person to person by a standard deviation of 0.3. Stimuli may have values of
their own besides ("own", a standard deviation in z), or a square of the first attribute may be left
out of the model. A null weight should reach p < 0.05 in 5 % of cases.

Then few stimuli: 7, with 3 attributes of which one has a weight, each pair once by 12 people whose
own values differ by 0.3 z, with and without ties.
"""

from __future__ import annotations

import argparse

import numpy as np

from nacreous.problem import InputError
from nacreous.scaling import Answers, fit_attributes, simulate

TERMS, REAL = 12, 3
WEIGHTS = np.array([0.5, 0.35, 0.25] + [0.0] * 9)
SPREAD = np.array([0.3] * 8 + [0.0] * 4)
#: People, pairs a person, stimuli, their own standard deviation, omitted square.
DESIGNS = (
    (10, 100, 30, 0.0, 0.0), (30, 100, 30, 0.0, 0.0), (5, 100, 30, 0.3, 0.0),
    (10, 100, 30, 0.3, 0.0), (10, 100, 30, 0.0, 0.3), (30, 100, 20, 0.3, 0.0),
)  # fmt: skip


def study(
    people: int, pairs: int, stimuli: int, own: float, square: float, seed: int
) -> tuple[Answers, dict[str, dict[str, float]]]:
    """Answers to pairs by lot, and the attributes."""
    random = np.random.default_rng(seed)
    mixing = np.linalg.cholesky(0.5 * np.eye(TERMS) + 0.5)
    attributes = random.standard_normal((stimuli, TERMS)) @ mixing.T
    weights = WEIGHTS + SPREAD * random.standard_normal((people, TERMS))
    apart = own * random.standard_normal(stimuli) + square * (attributes[:, 0] ** 2 - 1)
    values = weights @ attributes.T + apart
    person = np.repeat(np.arange(people), pairs)
    left = random.integers(stimuli, size=len(person))
    right = (left + 1 + random.integers(stimuli - 1, size=len(person))) % stimuli
    lead = values[person, left] - values[person, right] + random.standard_normal(len(person))
    outcome = np.where(lead > 0, 1, -1).astype(np.int8)
    labels = tuple(f"p{k:02d}" for k in range(stimuli))
    names = tuple(str(k) for k in range(people))
    answers = Answers(labels, left, right, outcome, names, person)
    table = {
        label: {f"a{k}": float(value) for k, value in enumerate(row)}
        for label, row in zip(labels, attributes, strict=True)
    }
    return answers, table


def few(tie: float, own: float, seed: int) -> tuple[Answers, dict[str, dict[str, float]]]:
    """7 stimuli and 3 attributes."""
    random = np.random.default_rng(seed)
    attributes = random.standard_normal((7, 3))
    values = 0.5 * attributes[:, 0] + own * random.standard_normal(7)
    scale = {f"p{k}": float(value) for k, value in enumerate(values)}
    rows = attributes.tolist()
    table = {
        label: dict(zip("abc", row, strict=True)) for label, row in zip(scale, rows, strict=True)
    }
    return simulate(scale, 12, person_spread=0.3, tie=tie, seed=seed), table


def table_of_few(studies: int) -> None:
    """Few stimuli: a line for each width of ties and own standard deviation."""
    print("\nfew stimuli: tie  own   null  +-")
    for tie, own in ((0.0, 0.3), (0.4, 0.3), (0.0, 0.0), (0.4, 0.0)):
        null = []
        for seed in range(studies):
            fit = fit_attributes(*few(tie, own, seed))
            null.append(np.mean([weight.p_value < 0.05 for weight in fit.weights[1:]]))
        error = np.std(null) / studies**0.5
        print(f"             {tie:3}  {own:3}  {np.mean(null):.3f} {error:.3f}", flush=True)


def main() -> None:
    """Print a line for each design."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--studies", type=int, default=60)
    parser.add_argument("--few", type=int, default=400, help="studies of few stimuli (400)")
    args = parser.parse_args()
    studies = args.studies
    print("people pairs stimuli  own square   null  +-     found (0.5 0.35 0.25)  own found")
    for design in DESIGNS if studies else ():
        p_values, found = [], []
        for seed in range(studies):
            try:
                fit = fit_attributes(*study(*design, seed))
            except InputError:
                continue
            p_values.append([weight.p_value for weight in fit.weights])
            found.append(fit.unexplained)
        low = np.array(p_values) < 0.05
        null = low[:, REAL:].mean(axis=1)
        power = " ".join(f"{share:.2f}" for share in low[:, :REAL].mean(axis=0))
        people, pairs, stimuli, own, square = design
        print(
            f"{people:6} {pairs:5} {stimuli:7} {own:4} {square:6}  {null.mean():.3f} "
            f"{null.std() / len(null) ** 0.5:.3f}  {power:22} {np.mean(found):.2f} "
            f"({len(low)} studies)",
            flush=True,
        )
    if args.few:
        table_of_few(args.few)


if __name__ == "__main__":
    main()
