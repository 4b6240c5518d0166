"""What `nacreous scale` says where nobody is known as person."""

from __future__ import annotations

import shlex
from typing import Any


def of_people(data: Any) -> list[str]:
    """That nobody is known as person where that is so, and which column may say it."""
    from nacreous.scaling import Answers
    from nacreous.scaling.data.fault import listed
    from nacreous.scaling.data.program import may_name_people

    if not isinstance(data, Answers) or data.person is not None:
        return []
    line = "nobody is known as person, so each answer counts as another person's"
    if not data.groups:
        return [line]
    perhaps = next(filter(may_name_people, data.groups), "NAME")
    named = shlex.quote(f"person={perhaps}")
    return [f"{line}; columns here: {listed(data.groups)}; name one by --column {named}"]
