"""The [sitting] of a study: how one participant goes through it."""

from __future__ import annotations

from nacreous.spec.key import key, quantity
from nacreous.spec.section import Section


class Sitting(Section):
    """Training, breaks and pace."""

    training: int = quantity(
        3,
        "How many pairs are shown first, to learn how it goes; their answers do not count.",
        least=0,
        most=100,
        source="**(ours)**",
    )
    break_every: int = quantity(
        30,
        "After how many trials there is a break; 0 for none.",
        least=0,
        most=1000,
        source="**(ours)**",
    )
    adaptation_s: float = quantity(
        60.0,
        "How long a plain page of the pictures' grey is looked at after a break and on coming "
        "back, before the next pair; 0 for not at all.",
        least=0,
        most=600,
        unit="s",
        source="Fairchild and Reniff 1995, 90 % of chromatic adaptation within 60 s",
    )
    minimum_viewing_ms: int = quantity(
        500,
        "How long a pair is on the screen before an answer is taken.",
        least=0,
        most=60_000,
        unit="ms",
        source="**(ours)**",
    )
    ties: bool = key(
        False,
        'Whether "no difference" may be answered.',
        allowed="true or false",
        source="**(ours)**",
    )
