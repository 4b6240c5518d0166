"""All trials of one participant."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from nacreous.scaling.planning.sequence import in_sequence
from nacreous.study.design.design import Design
from nacreous.study.plan.order import Again, Shown, in_order
from nacreous.study.plan.trial import Trial
from nacreous.study.random_streams import ORDER, numbered, stream
from nacreous.study.task.task import Items, SoFar
from nacreous.study.task.tasks import TASKS

__all__ = ["trials"]


def trials(design: Design, number: int, so_far: SoFar | None = None) -> list[Trial]:
    """The trials of slot `number`: training, then one question after the other.

    - Under each question every pair of the participant comes once, and the pairs chosen for that
      once more with the sides exchanged.
    - No stimulus comes twice in a row, where that is possible (`repetitions`).
    - Each stimulus is as often on the left as on the right, or once more or less; training and
      catches aside. Numbers 2k and 2k + 1 have the same pairs, mirrored, in different orders,
      unless pairs are adaptive.
    - Catches are spread evenly over their question. Questions begin with another one for every two
      slots.

    so_far: of a study with adaptive pairs, the counts of the answers so far, by question; a
    question without any gets pairs by lot. Other studies do not look at it.

    Same arguments, same trials, with the same version of NumPy. Raises `InputError` for a number
    that cannot be.

    >>> trials(Design.load("paper"), 0) == trials(Design.load("paper"), 0)
    True
    """
    number = numbered(number)
    task, asked = TASKS[design.task], design.asked
    random = stream(design.seed, ORDER, number)
    turn = number // 2 % len(design.questions)
    ids = asked.questions[turn:] + asked.questions[:turn]
    found = task.items(asked, number, ids, so_far or {})
    training = _training(found[0], task.again, design.sitting.training, random)
    shown = [[(ids[0], one) for one in training]]
    before = training[-1] if training else None
    for question, items in zip(ids, found, strict=True):
        catches = _catches(task.catches(asked, question), task.again, number, random)
        order = in_order(items, task.again, catches, before, random)
        shown.append([(question, one) for one in order])
        before = order[-1]
    return list(_in_blocks(design, shown))


def _training(items: Items, again: Again, count: int, random: np.random.Generator) -> list[Shown]:
    """Some of the participant's items, as they are shown first or the second time."""
    shown: list[Shown] = []
    last = None
    while len(shown) < count:
        rows = items.stimuli[in_sequence(items.stimuli, random, last)]
        last = rows[-1]
        for row, turned in zip(rows.tolist(), random.random(len(rows)) < 0.5, strict=True):
            stimuli = again(tuple(row)) if turned else tuple(row)
            shown.append(Shown(stimuli, "training"))
    return shown[:count]


def _catches(
    found: list[tuple[int, ...]], again: Again, number: int, random: np.random.Generator
) -> list[tuple[int, ...]]:
    """The catches of a question in random order, by turns as given and as shown a second time."""
    order = random.permutation(len(found)).tolist()
    return [
        found[row] if (place + number) % 2 else again(found[row]) for place, row in enumerate(order)
    ]


def _in_blocks(design: Design, shown: list[list[tuple[str, Shown]]]) -> Iterator[Trial]:
    """Number all trials; a break after every so many of a question, and before the next one."""
    number, block, every = 0, 0, design.sitting.break_every
    for part, rows in enumerate(shown):
        for place, (question, one) in enumerate(rows):
            pause = bool(every) and part > 0 and place % every == 0 and part + place > 1
            block += pause or (part > 0 and place == 0)
            labels = tuple(design.labels[stimulus] for stimulus in one.stimuli)
            yield Trial(number, question, labels, one.kind, block, pause)
            number += 1
