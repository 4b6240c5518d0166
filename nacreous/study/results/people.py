"""Flags of all people: who did not look, who tossed coins, whose page was not as it should be."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from nacreous.study.results.watch import Watch
from nacreous.study.store import Coded
from nacreous.study.task.counting import is_data
from nacreous.study.task.flag import Flag
from nacreous.study.task.tasks import columns_of_tasks

if TYPE_CHECKING:
    from nacreous.study.running import Running

__all__ = ["people_flags"]

#: What flags of what answers say of each other hang on, and how it is held.
_KINDS = {
    **{"number": "int64", "kind": "text", "question": "text", "response_ms": "float64"},
    **{"simulated": "bool", "excluded": "text"},
    **{column.name: "text" for column in columns_of_tasks()},
}


def people_flags(running: Running) -> dict[int, list[Flag]]:
    """The flags of every person who has answered or checked the screen, by number.

    Excluded people have theirs too; erased ones, of whom nothing is known, have none.
    """
    store, study, design = running.store, running.study, running.frozen.design
    missed = partial(running.task.missed, design.asked)
    watch, data = Watch(design.sitting.minimum_viewing_ms, missed), Coded(_KINDS)
    for part in store.parts(study, (*_KINDS, "received_at", "flags")):
        living = _where([number is not None for number in part["number"]], part)
        watch.add(living)
        data.add(_where([is_data({"kind": kind}) for kind in living["kind"]], living))
    found: dict[int, list[Flag]] = {
        session.number: list(_screen(session.screen))
        for session in store.sessions(study)
        if session.erased_at is None
    }
    for number, flags in (*watch.flags(), *running.task.flags(design.asked, data.table()).items()):
        found.get(number, []).extend(flags)  # of who was erased since, none
    return found


def _where(kept: Sequence[bool], part: Mapping[str, Sequence[Any]]) -> Mapping[str, Sequence[Any]]:
    """Some rows of a part."""
    if all(kept):
        return part
    return {
        name: [value for value, keep in zip(values, kept, strict=True) if keep]
        for name, values in part.items()
    }


def _screen(screen: Mapping[str, Any] | None) -> Iterator[Flag]:
    """What the last check of the screen found."""
    for name in (screen or {}).get("flags", ()):
        yield Flag(f"screen-{name}", "")
