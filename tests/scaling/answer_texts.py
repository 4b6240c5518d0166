"""Answers' files as text, and what is read of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from nacreous.scaling import Answers

HEAD = "person,left,right,chosen\n"
ROWS = "p1,A,B,A\np1,B,C,C\np2,C,A,A\n"
PLAIN = HEAD + ROWS


def read(folder: Path, content: str | bytes, name: str = "a.csv", **options: Any) -> Answers:
    path = folder / name
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return Answers.read(path, **options)


def said(answers: Answers) -> list[str]:
    """Each answer as person:winner>loser, or person:left=right."""
    lines = []
    for row in range(len(answers)):
        left, right = answers.stimuli[answers.left[row]], answers.stimuli[answers.right[row]]
        who = "" if answers.person is None else answers.people[answers.person[row]] + ":"
        told = {1: f"{left}>{right}", -1: f"{right}>{left}", 0: f"{left}={right}"}
        lines.append(who + told[int(answers.outcome[row])])
    return lines


TOLD = ["p1:A>B", "p1:C>B", "p2:A>C"]
