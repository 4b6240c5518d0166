"""A flag: something about one person's answers that the experimenter should look at."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["LONGEST_PAUSE_S", "RATE", "Flag"]

#: An honest person gets a flag that is a test of chance at most so often **(ours)**.
RATE = 0.01
#: Whoever is away for longer between two answers did something else **(ours)**.
LONGEST_PAUSE_S = 300.0


@dataclass(frozen=True)
class Flag:
    """What was noticed, and how much of it. A flag informs; it excludes nobody.

    kind: one of

    - "catches": pairs whose answer is known were answered otherwise, or by a tie
    - "repeats": pairs asked again were answered otherwise more often than chance makes people do
    - "left", "right": one side was chosen more often than chance makes it
    - "circles": more circular triads (a over b over c over a) than chance makes people have
    - "fast": more than a tenth of the answers came faster than anyone reacts to light, 0.2 s
    - "unwaited": more than a tenth of the answers came before the study's `minimum_viewing_ms`,
      which its page does not let happen
    - "pause": five minutes or more between two answers
    - "answer-NAME": the participant's page noticed NAME with so many answers: "away" (the window
      lost the focus or was hidden), "resized", "shrunk" (pictures were scaled down to fit),
      "early" (keys were pressed before a pair could be answered; from a tenth of answers on)
    - "screen-NAME": the check of the screen found NAME, as docs/study.md lists them

    "repeats", "left", "right" and "circles" are tests of chance, each at a level of `RATE`.

    detail: the figures, in no language: "2/3" is two of three, "640 s" a duration, "" nothing.
    """

    kind: str
    detail: str
