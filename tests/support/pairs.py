"""Answers to pairs, made up."""

from __future__ import annotations

from typing import Any

from nacreous.study.store import Answer, Response


def pair_answer(
    trial: int,
    question: str,
    left: str,
    right: str,
    chosen: str,
    *timed: Any,
    kind: str = "pair",
    **more: Any,
) -> Answer:
    """An answer to a pair. timed, more: of `Response`, after what was chosen."""
    response = Response(chosen, *timed, **more)
    return Answer(trial, question, {"left": left, "right": right}, response, kind)
