"""Flags of all people: who did not look, who tossed coins, whose page was not as it should be."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from nacreous.study.design.design import Design
from nacreous.study.memory import give_back
from nacreous.study.store.coded import Coded
from nacreous.study.store.record import Session
from nacreous.study.store.watch import Watch
from nacreous.study.task.counting import DATA
from nacreous.study.task.flag import Flag
from nacreous.study.task.tasks import TASKS, columns_of_tasks

if TYPE_CHECKING:
    import pyarrow as pa

__all__ = ["flags_of_people"]

#: What flags of what answers say of each other hang on, and how it is held.
_KINDS = {
    **{"number": "int32", "kind": "text", "question": "text", "response_ms": "float64"},
    **{"simulated": "bool", "excluded": "text"},
    **{column.name: "text" for column in columns_of_tasks()},
}


def flags_of_people(
    design: Design, parts: Iterable[pa.Table], people: Sequence[Session]
) -> dict[int, list[Flag]]:
    """The flags of each of these people by number.

    parts: all answers of the study in the order of arrival, as `Store.watched` gives them. Excluded
    people have flags too; erased ones, of whom nothing is known, have none.
    """
    task = TASKS[design.task]
    watch = Watch(design.sitting.minimum_viewing_ms, partial(task.missed, design.asked))
    data = Coded(_KINDS)
    by_session = {one.id: one for one in people}
    for part in parts:
        living = _of_living(part, by_session)
        watch.add(living)
        data.add(_columns(_data(living)))
    found: dict[int, list[Flag]] = {
        one.number: list(_screen(one.screen)) for one in people if one.erased_at is None
    }
    give_back()
    for number, flags in (*watch.flags(), *task.flags(design.asked, data.table()).items()):
        found.get(number, []).extend(flags)  # of who entered or was erased meanwhile, none
    give_back()
    return found


def _of_living(part: pa.Table, people: Mapping[str, Session]) -> pa.Table:
    """The answers of people who are not erased, with their number and why they are excluded."""
    import pyarrow as pa
    import pyarrow.compute as pc

    session = part["session"].combine_chunks()
    known = [people.get(one) for one in session.dictionary.to_pylist()]
    number = pa.array([one and one.number for one in known], pa.int32())
    excluded = pa.array([one and one.excluded_reason for one in known], pa.string())
    told = part.append_column("number", number.take(session.indices)).append_column(
        "excluded", excluded.take(session.indices).dictionary_encode()
    )
    return told.filter(pc.is_valid(told["number"]))


def _data(part: pa.Table) -> pa.Table:
    """The answers that are data for a scale, whoever gave them."""
    import pyarrow as pa
    import pyarrow.compute as pc

    return part.filter(pc.is_in(part["kind"].cast(pa.string()), pa.array(DATA, pa.string())))


def _columns(part: pa.Table) -> dict[str, Any]:
    return dict(zip(part.column_names, part.columns, strict=True))


def _screen(screen: Mapping[str, Any] | None) -> Iterator[Flag]:
    """What the last check of the screen found."""
    for name in (screen or {}).get("flags", ()):
        yield Flag(f"screen-{name}", "")
