"""The report of a study: that of `nacreous.scaling`, with the study's question and groups."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection
from dataclasses import replace
from typing import TYPE_CHECKING, get_args

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.data.fault import hint_of
from nacreous.study.results.scale import counted, question_of, without_prior
from nacreous.study.running.screening import ScreenFlag
from nacreous.study.store.codebook import group_column

if TYPE_CHECKING:
    from nacreous.scaling import Answers
    from nacreous.scaling.report.settings import Settings
    from nacreous.study.running import Running

__all__ = ["report"]


def report(
    running: Running,
    question: str,
    language: str = "en",
    simulated: bool = False,
    group: str | None = None,
    progress: Callable[[float], None] | None = None,
) -> str:
    """A page in a language, "en" or "ja", that reads without statistics.

    Groups are compared by the factor `group`; unless it is given, by the first of the study's
    factors by which they can be; what cannot be compared the report names. Raises `InputError` for
    what there is not, and while there is no scale (`scale_so_far` says why).
    """
    from nacreous.scaling import analyse
    from nacreous.scaling.report.page import html
    from nacreous.study.design.called import called_stimuli

    asked = question_of(running, question)
    known = [factor.name for factor in running.frozen.design.groups]
    if group is not None and group not in known:
        hint = hint_of(group, known) if known else "allowed: none, for the study has no groups"
        raise InputError(f"group is {said(group)}; {hint}")
    answers = counted(running, question, simulated)
    text = asked.text.in_language(language) or asked.text.in_language(
        "en" if language == "ja" else "ja"
    )
    factors = known if group is None else [group]
    column = _told_most(answers, [group_column(name).name for name in factors], running.settings)
    wanted = replace(running.settings, question=text, group=column, simulated=simulated)
    with without_prior():
        analysis = analyse(answers, wanted, progress=progress)
    analysis = replace(analysis, called=called_stimuli(running.frozen))
    return html(analysis, language, screen_marks(running, answers.people))


def screen_marks(running: Running, people: Collection[str]) -> dict[str, int]:
    """How many of these people have each mark of their last screen check, in the marks' order."""
    found = Counter(
        mark
        for session in running.store.sessions(running.study)
        if not {str(session.number), f"simulated {session.number}"}.isdisjoint(people)
        for mark in running.screen_flags(session)
    )
    return {mark: found[mark] for mark in get_args(ScreenFlag) if found[mark]}


def _told_most(answers: Answers, columns: list[str], settings: Settings) -> str | None:
    """The first column of which groups can be compared; else the first of which any are known."""
    from nacreous.scaling.report.groups import left_out_of

    told = [column for column in columns if column in answers.groups and answers.sizes(column)]
    if len(told) == 1:  # whatever can be compared, there is no other
        return told[0]
    for column in told:
        parts = answers.split(column)
        # Whether ties are fitted changes nothing for which groups have a scale of their own.
        if len(parts) - len(left_out_of(parts, settings, with_ties=False)) > 1:
            return column
    return told[0] if told else None
