"""The report of a study: that of `nacreous.scaling`, with the study's question and groups."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection
from dataclasses import replace
from typing import TYPE_CHECKING, get_args

from nacreous.problem import InputError
from nacreous.study.results.scale import counted, question_of
from nacreous.study.running.screening import ScreenFlag
from nacreous.study.store.codebook import group_column

if TYPE_CHECKING:
    from nacreous.scaling import Answers
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
    factors by which they can be. Raises `InputError` for what there is not, and while there is no
    scale (`scale_so_far` says why).
    """
    from nacreous.scaling import analyse
    from nacreous.scaling.report.page import html

    asked = question_of(running, question)
    known = [factor.name for factor in running.frozen.design.groups]
    if group is not None and group not in known:
        allowed = ", ".join(known) or "none, for the study has no groups"
        raise InputError(f"group is {group!a}; allowed: {allowed}")
    answers = counted(running, question, simulated)
    text = asked.text.in_language(language) or asked.text.in_language(
        "en" if language == "ja" else "ja"
    )
    column = None if group is None else group_column(group).name
    if group is None:
        column = _comparable(answers, [group_column(name).name for name in known])
    wanted = replace(running.settings, question=text, group=column, simulated=simulated)
    analysis = analyse(answers, wanted, progress=progress)
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


def _comparable(answers: Answers, columns: list[str]) -> str | None:
    """The first column whose groups each have a scale with its errors, so that they compare."""
    from nacreous.scaling.compare.estimate import estimates

    for column in columns:
        parts = answers.split(column) if column in answers.groups else {}
        if len(parts) < 2:
            continue
        try:
            estimates(parts, "probit")
        except InputError:  # the report says what can be said without them
            continue
        return column
    return None
