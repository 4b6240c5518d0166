"""How many people judged each stimulus, and whether they are enough to tell how people differ."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.fault import quoted
from nacreous.scaling.fit.blocks import numbered

if TYPE_CHECKING:
    from nacreous.scaling.data.answers import Answers

#: With fewer people nothing tells how others would differ: an interval of 2 is 10 units wide.
LEAST_PEOPLE = 3
#: With fewer people, or fewer for a stimulus, more than a few samples are of one or two people over
#: and over; from 8 on 95 of 100 intervals are within 1.5 times those of t, where with 5 some are 47
#: times as wide, and with 4 thousands (docs/scaling.md).
LEAST_DRAWN = 8
INSTEAD = 'kind="expected" or counts, which take answers as independent'
DRAWN_INSTEAD = 'by="answers", which takes the answers as independent'


def require_people(answers: Answers | None, instead: str = INSTEAD) -> Answers:
    """The answers, if they tell how people differ: each stimulus judged by three of them."""
    if answers is None or answers.person is None:
        raise InputError("it is not known who gave the answers; allowed: answers with people")
    people = len(numbered(answers.person, int(answers.person.max(initial=0)) + 1)[0])
    require_judges(answers.stimuli, judges_of(answers), people, instead)
    return answers


def require_judges(
    stimuli: tuple[str, ...], judges: NDArray[np.int64], people: int, instead: str = INSTEAD
) -> None:
    """Raise `InputError` where fewer than three of the people judged a stimulus.

    judges: how many judged each, int64 [stimulus].
    """
    least = LEAST_PEOPLE
    if people < least:
        whose = "1 person" if people == 1 else f"{people} people"
        raise InputError(
            f"the answers are those of {whose}, who cannot tell how people differ; allowed: "
            f"{least} or more people, or {instead}"
        )
    if judges.min() < least:
        at = int(np.argmin(judges))
        raise InputError(
            f"{quoted(stimuli[at])} was judged by {judges[at]} of {people} people, too few "
            f"to tell how people differ; allowed: {least} or more a stimulus, or {instead}"
        )


def judges_of(answers: Answers) -> NDArray[np.int64]:
    """How many people judged each stimulus, int64 [stimulus]; all 0 where they are unknown."""
    count = len(answers.stimuli)
    if answers.person is None:
        return np.zeros(count, np.int64)
    return judges_among(count, answers.person, (answers.left, answers.right))


def judges_among(
    count: int, person: NDArray[np.int64], shown: Sequence[NDArray[np.int64]]
) -> NDArray[np.int64]:
    """How many people saw each of so many stimuli; shown: int64 [answer] each, what stood there."""
    size = (int(person.max(initial=0)) + 1) * count
    met = np.concatenate([numbered(person * count + each, size)[0] for each in shown])
    return np.bincount(np.unique(met) % count, minlength=count)


def require_many(stimuli: tuple[str, ...], judges: NDArray[np.int64], people: int) -> None:
    """Raise `InputError` where too few people, of so many, judged a stimulus to be drawn anew."""
    if judges.min() >= LEAST_DRAWN:
        return
    at = int(np.argmin(judges))
    who = f"{quoted(stimuli[at])} was judged by {judges[at]} of {people} people"
    if people < LEAST_DRAWN:
        who = f"the answers are those of {people} people"
    raise InputError(
        f"{who}, too few to be drawn anew; allowed: {LEAST_DRAWN} or more, the fit's own "
        f"intervals, which are Student's t, or {DRAWN_INSTEAD}"
    )
