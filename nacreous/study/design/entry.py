"""The [entry] of a study: what is kept of the address by which people come, and of their slots."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from nacreous.spec.complaint import Contradiction, shown
from nacreous.spec.key import key, quantity
from nacreous.spec.section import Section

#: A parameter's name in an address; upper and lower case are told apart, as platforms do.
Parameter = Annotated[str, Field(pattern="^[A-Za-z][A-Za-z0-9_-]{0,39}$")]
PARAMETER = "1 to 40 of A to Z, a to z, 0 to 9, - and _, the first a letter"
#: What the page's own address asks for, and what a return address says in place of a code.
TAKEN = ("simulate", "CODE")


class Entry(Section):
    """How people come to a study.

    >>> Entry(parameters=["PROLIFIC_PID"]).parameters
    ('PROLIFIC_PID',)
    """

    parameters: Annotated[tuple[Parameter, ...], Field(max_length=12)] = key(
        (),
        "The parameters of the address, as in ?PROLIFIC_PID=..., that are kept with a person; no "
        "others are.",
        allowed=f"0 to 12 different names, each {PARAMETER}",
        source="**(ours)**",
        strict=False,
    )
    idle_hours: float = quantity(
        1.0,
        "For how long the slot of somebody who does not go on is kept; then it is given again.",
        least=0.1,
        most=1000,
        unit="h",
        source="**(ours)**",
    )

    def contradictions(self) -> Iterator[Contradiction]:
        """A name twice, or one that means something else already."""
        if len(set(self.parameters)) < len(self.parameters):
            yield Contradiction("parameters", f"are {shown(self.parameters)}; allowed: each once")
        for name in TAKEN:
            if name in self.parameters:
                yield Contradiction("parameters", f"name {shown(name)}; allowed: other names")
