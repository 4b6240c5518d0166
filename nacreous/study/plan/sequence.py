"""All trials of one participant."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.planning.sequence import in_sequence
from nacreous.study.design.design import Design
from nacreous.study.plan.choice import Choice, choices
from nacreous.study.plan.order import Shown, in_order
from nacreous.study.plan.random_streams import ORDER, numbered, stream
from nacreous.study.plan.trial import Trial

__all__ = ["trials"]


def trials(
    design: Design, number: int, so_far: Mapping[str, Comparisons] | None = None
) -> list[Trial]:
    """The trials of participant `number`: training, then one question after the other.

    - Under each question every pair of the participant comes once, and the pairs chosen for that
      once more with the sides exchanged.
    - No stimulus comes twice in a row, where that is possible (`repetitions`).
    - Each stimulus is as often on the left as on the right, or once more or less; training and
      catches aside. Numbers 2k and 2k + 1 have the same pairs, mirrored, in different orders,
      unless pairs are adaptive.
    - Catches are spread evenly over their question. Questions begin with another one for every two
      participants.

    so_far: of a study with adaptive pairs, the counts of the answers so far, by question; a
    question without any gets pairs by lot. Other studies do not look at it.

    Same arguments, same trials, with the same version of NumPy. Raises `InputError` for a number
    that cannot be.

    >>> trials(Design.load("paper"), 0) == trials(Design.load("paper"), 0)
    True
    """
    number = numbered(number)
    random = stream(design, ORDER, number)
    turn = number // 2 % len(design.questions)
    ids = [question.id for question in design.questions]
    ids = ids[turn:] + ids[:turn]
    chosen = choices(design, number, ids, so_far or {})
    training = _training(design, chosen[0], random)
    shown = [[(ids[0], one) for one in training]]
    before = training[-1] if training else None
    for question, choice in zip(ids, chosen, strict=True):
        order = in_order(choice, _catches(design, question, number, random), before, random)
        shown.append([(question, one) for one in order])
        before = order[-1]
    return list(_in_blocks(design, shown))


def _training(design: Design, choice: Choice, random: np.random.Generator) -> list[Shown]:
    """Some of the participant's pairs, either way round."""
    shown: list[Shown] = []
    last = None
    while len(shown) < design.sitting.training:
        rows = choice.pairs[in_sequence(choice.pairs, random, last)]
        last = rows[-1]
        for row, turned in zip(rows.tolist(), random.random(len(rows)) < 0.5, strict=True):
            left, right = reversed(row) if turned else row
            shown.append(Shown(left, right, "training"))
    return shown[: design.sitting.training]


def _catches(
    design: Design, question: str, number: int, random: np.random.Generator
) -> list[tuple[int, int]]:
    """The catches of a question in random order, the expected one by turns on the left."""
    index = {label: place for place, label in enumerate(design.labels)}
    first = design.questions[0].id
    found = [
        (index[catch.expected], index[catch.against])
        for catch in design.catches
        if (catch.question or first) == question
    ]
    order = random.permutation(len(found)).tolist()
    return [
        found[row] if (place + number) % 2 else (found[row][1], found[row][0])
        for place, row in enumerate(order)
    ]


def _in_blocks(design: Design, shown: list[list[tuple[str, Shown]]]) -> Iterator[Trial]:
    """Number all trials; a break after every so many of a question, and before the next one."""
    number, block, every = 0, 0, design.sitting.break_every
    for part, rows in enumerate(shown):
        for place, (question, one) in enumerate(rows):
            pause = bool(every) and part > 0 and place % every == 0 and part + place > 1
            block += pause or (part > 0 and place == 0)
            left, right = design.labels[one.left], design.labels[one.right]
            yield Trial(number, question, left, right, one.kind, block, pause)
            number += 1
