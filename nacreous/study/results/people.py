"""Flags of all people: who did not look, who tossed coins, whose page was not as it should be."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nacreous.study.store.flags import flags_of_people
from nacreous.study.task.flag import Flag

if TYPE_CHECKING:
    from nacreous.study.running import Running

__all__ = ["people_flags"]


def people_flags(running: Running) -> dict[int, list[Flag]]:
    """The flags of every person who has entered, by number (`nacreous.study.store.flags`)."""
    people = running.store.sessions(running.study)
    return flags_of_people(running.frozen.design, running.store.watched(running.study), people)
