"""Simulated answers that reports are made of."""

from __future__ import annotations

import numpy as np

import nacreous as nc

SPITEFUL = ("<script>alert(1)</script>", "a\"b'c", "x & y", "$\\frac{1}{2}$", "真珠 <b>", "{first}")


def survey(stimuli=("a", "b", "c", "d"), people=25, group=True, ties=True, seed=1):
    """Simulated answers: people who differ, two groups, ties, times, some pairs asked twice."""
    chance = np.random.default_rng(seed)
    count = len(stimuli)
    truth = np.linspace(1, -1, count)
    table = {name: [] for name in ("person", "left", "right", "chosen", "time", "response_s")}
    table["room"] = []
    for person in range(people):
        own = truth + 0.3 * chance.normal(size=count)
        pairs = [(i, j) for i in range(count) for j in range(i)]
        for time, (i, j) in enumerate([*pairs, *pairs[:2]]):
            left, right = (i, j) if chance.random() < 0.5 else (j, i)
            lead = own[left] - own[right] + chance.normal()
            tie = ties and abs(lead) < 0.15
            chosen = "tie" if tie else stimuli[left if lead > 0 else right]
            room = "north" if person % 2 else "<south>"
            row = (f"p{person}", stimuli[left], stimuli[right], chosen, time, 1 + chance.random())
            for name, value in zip(table, (*row, room), strict=True):
                table[name].append(value)
    if not group:
        del table["room"]
    return nc.scaling.Answers.of_table(table)
