"""Flags of all people: who did not look, who tossed coins, whose page was not as it should be."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

from nacreous.study.design.design import Design
from nacreous.study.store.coded import Coded
from nacreous.study.store.record import Session
from nacreous.study.store.watch import Watch
from nacreous.study.task.counting import is_data
from nacreous.study.task.flag import Flag
from nacreous.study.task.tasks import TASKS, columns_of_tasks

__all__ = ["WATCHED", "flags_of_people"]

#: What flags of what answers say of each other hang on, and how it is held.
_KINDS = {
    **{"number": "int64", "kind": "text", "question": "text", "response_ms": "float64"},
    **{"simulated": "bool", "excluded": "text"},
    **{column.name: "text" for column in columns_of_tasks()},
}
#: The columns of answers on which any flag hangs.
WATCHED = (*_KINDS, "received_at", "flags")


def flags_of_people(
    design: Design, parts: Iterable[Mapping[str, Sequence[Any]]], people: Sequence[Session]
) -> dict[int, list[Flag]]:
    """The flags of each of these people by number.

    parts: all answers of the study in the order of arrival, as `Store.parts` gives the columns
    `WATCHED`. Excluded people have flags too; erased ones, of whom nothing is known, have none.
    """
    task = TASKS[design.task]
    watch = Watch(design.sitting.minimum_viewing_ms, partial(task.missed, design.asked))
    data = Coded(_KINDS)
    for part in parts:
        living = _where([number is not None for number in part["number"]], part)
        watch.add(living)
        data.add(_where([is_data({"kind": kind}) for kind in living["kind"]], living))
    found: dict[int, list[Flag]] = {
        one.number: list(_screen(one.screen)) for one in people if one.erased_at is None
    }
    for number, flags in (*watch.flags(), *task.flags(design.asked, data.table()).items()):
        found.get(number, []).extend(flags)  # of who entered or was erased meanwhile, none
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
