"""The scale so far: what the report would say of it, quickly enough to be looked at all day."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.data.fault import hint_of
from nacreous.study.store import answers_of

if TYPE_CHECKING:
    from nacreous.scaling import Answers
    from nacreous.study.design.question import Question
    from nacreous.study.running import Running

__all__ = [
    "Placed",
    "ScaleSoFar",
    "called_simulated",
    "counted",
    "question_of",
    "scale_so_far",
    "without_prior",
]


@dataclass(frozen=True)
class Placed:
    """A stimulus at its place, with its interval. picture: its file's SHA-256.

    low, high: None where the answers set no end to the interval on that side.
    """

    label: str
    picture: str
    value: float
    low: float | None
    high: float | None


@dataclass(frozen=True)
class ScaleSoFar:
    """The scale of one question, the highest stimulus first.

    question: its id. text: by language. simulated: nobody gave these answers. answers, people: how
    many count. unit, level: of the intervals, in which one person's answers hang together.
    verdict: whether one scale holds the answers: "describes", "misfits" or "untested". misfit: the
    two stimuli that it holds worst, the one chosen too often first; None unless "misfits".
    people_differ: people were found not to share the scale, which holds their sums at best.
    people_told: the answers could have told it of people with hardly anything in common.
    """

    question: str
    text: Mapping[str, str]
    simulated: bool
    stimuli: tuple[Placed, ...]
    answers: int
    people: int
    unit: str
    level: float
    verdict: str
    misfit: tuple[str, str] | None
    people_differ: bool
    people_told: bool


def scale_so_far(running: Running, question: str, simulated: bool = False) -> ScaleSoFar:
    """Thurstone's case V of the answers that count, as `nacreous.scaling.analyse` has it.

    Pairs chosen by the answers so far are fitted as the report fits them (`Task.settings`).

    Raises `InputError` with the reason while there is no scale: nobody has answered yet, stimuli
    are not joined by answers, or one of them always wins.
    """
    from nacreous.scaling import analyse

    asked = question_of(running, question)
    answers = counted(running, question, simulated)
    with without_prior():
        found = analyse(answers, running.settings, bootstrap=0)
    pictures = {stimulus.label: stimulus.sha256 for stimulus in running.frozen.stimuli}
    unset = found.doubt.open_ends(found.fit.stimuli)
    stimuli = tuple(
        Placed(
            found.fit.stimuli[at],
            pictures[found.fit.stimuli[at]],
            float(found.fit.scale[at]),
            *(
                None if gone else float(end)
                for end, gone in zip(found.doubt.intervals[at], unset[at], strict=True)
            ),
        )
        for at in found.order
    )
    describes = None if found.fit_hidden_by else found.goodness.describes
    verdict = {True: "describes", False: "misfits", None: "untested"}[describes]
    worst = found.goodness.largest
    return ScaleSoFar(
        question=question,
        text=asked.text.model_dump(exclude_none=True),
        simulated=simulated,
        stimuli=stimuli,
        answers=len(answers),
        people=len(answers.people),
        unit=found.fit.unit,
        level=found.settings.level,
        verdict=verdict,
        misfit=(worst.first, worst.second) if verdict == "misfits" else None,
        people_differ=found.people_differ,
        people_told=found.people_told,
    )


@contextmanager
def without_prior() -> Iterator[None]:
    """Why there is no scale, without the advice of a prior, which nobody can give to a study."""
    from nacreous.scaling.fit.existence import REMEDY

    try:
        yield
    except InputError as problem:
        raise InputError(str(problem).replace(REMEDY, "")) from problem


def counted(running: Running, question: str, simulated: bool) -> Answers:
    """The answers that count; simulated people are called so."""
    answers = answers_of(running.store, running.study, question, simulated=simulated)
    return called_simulated(answers) if simulated else answers


def called_simulated(answers: Answers) -> Answers:
    """The same answers, of people who are called simulated."""
    return replace(answers, people=tuple(f"simulated {person}" for person in answers.people))


def question_of(running: Running, question: str) -> Question:
    """A question of the study by its id; or one clear message."""
    asked = {one.id: one for one in running.frozen.design.questions}
    if question not in asked:
        raise InputError(f"question is {said(question)}; {hint_of(question, asked)}")
    return asked[question]
