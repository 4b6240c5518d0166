"""Flags of all people of a study that runs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nacreous.study.store.flags import flags_of_people
from nacreous.study.task.flag import Flag

if TYPE_CHECKING:
    from nacreous.study.running import Running

__all__ = ["people_flags"]


def people_flags(running: Running) -> dict[int, list[Flag]]:
    """The flags of every person who has entered, by number (`nacreous.study.store.flags`)."""
    rows = running.store.answers(running.study)
    people = running.store.sessions(running.study)
    return flags_of_people(running.frozen.design, rows, people)
