"""The one way in for answers: a table's rows checked, or every fault named by row and column."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any, TypedDict

import numpy as np
from numpy.typing import NDArray

from nacreous.number import truth_of
from nacreous.scaling.data.choice import outcomes_of
from nacreous.scaling.data.column import (
    Grouping,
    check_labels,
    codes_of,
    group_column,
    text_column,
)
from nacreous.scaling.data.count import counts_of
from nacreous.scaling.data.discarded import without_discarded
from nacreous.scaling.data.exclusion import excluded
from nacreous.scaling.data.fault import Faults, listed, quoted
from nacreous.scaling.data.label import check_number, labels_of
from nacreous.scaling.data.likeness import check_alike
from nacreous.scaling.data.nothing import refuse_errors, refuse_nothing
from nacreous.scaling.data.number_column import seconds_column
from nacreous.scaling.data.pair_columns import has_pairs
from nacreous.scaling.data.practice import marked
from nacreous.scaling.data.question import of_question
from nacreous.scaling.data.repeat import refuse_repeats
from nacreous.scaling.data.roles import Names, columns_of, has_long, has_winners
from nacreous.scaling.data.rounded import refuse_rounded
from nacreous.scaling.data.study_export import refuse_study_export
from nacreous.scaling.data.table import Table
from nacreous.scaling.data.tie_column import (
    refuse_other_ties,
    refuse_tie_words,
    tie_column,
    ties_of,
)
from nacreous.scaling.data.time_column import time_column
from nacreous.scaling.data.trials import refuse_unanswered, unanswered, with_pairs
from nacreous.scaling.data.uncounted import REASONS, counted_by_reason
from nacreous.scaling.data.wide import long_of


class Fields(TypedDict):
    """The fields of `Answers`, checked."""

    stimuli: tuple[str, ...]
    left: NDArray[np.int64]
    right: NDArray[np.int64]
    outcome: NDArray[np.int8]
    people: tuple[str, ...]
    person: NDArray[np.int64] | None
    groups: Mapping[str, Grouping]
    response_s: NDArray[np.float64] | None
    time: NDArray[np.float64] | None
    sided: bool
    left_out: int
    unanswered: int
    uncounted: Mapping[str, int]
    encoding_guessed: str | None


def fields_of(
    table: Table,
    names: Names,
    *,
    stimuli: Iterable[object] | None,
    repeats: bool,
    sided: bool,
    skip_unanswered: bool,
    question: str | None = None,
) -> Fields:
    """Check a table's rows and return what `Answers` holds."""
    repeats, sided = truth_of("repeats", repeats), truth_of("sided", sided)
    skip_unanswered = truth_of("skip_unanswered", skip_unanswered)
    refuse_study_export(table)
    rows = table.rows
    table = without_discarded(table, skip_unanswered)
    discarded = rows - table.rows
    table, column, unpaired = _trials(table, names)
    table, uncounted = _counting(table, column, question)
    if "count" in column:
        table = table.take(counts_of(table, column["count"], table.faults()) > 0)
    won = "winner" in column
    paired = table.rows
    if skip_unanswered and not won:
        kept = np.ones(paired, bool)
        kept[unanswered(table, column, names)] = False
        table = table.take(kept)
    skipped = paired - table.rows + discarded
    faults = table.faults()
    if table.rows == 0:
        faults.say(f"has no row with a pair and an answer{_besides(uncounted)}; allowed: 1 or more")
    faults.stop()
    labels, left, right = _stimuli(table, column, stimuli, faults)
    people, person = _people(table, column, faults)
    time = time_column(table, column["time"], "time", faults) if "time" in column else None
    trial = time_column(table, column["trial"], "trial", faults) if "trial" in column else None
    response_s = _response(table, column, faults)
    if not won:
        refuse_unanswered(table, column, names, faults)
    faults.stop()
    tied = tie_column(table, column.values())
    outcome = _outcomes(table, column, names, labels, (left, right), tied, faults)
    if not repeats:
        refuse_repeats(table, _telling(table, person, left, right, time, trial), person, faults)
    faults.stop()
    others = [name for name in table.columns if name not in {*column.values(), tied}]
    if won and tied is None:
        refuse_tie_words(table, others)
    counts = counts_of(table, column["count"], faults) if "count" in column else None
    groups = {name: group_column(table, name) for name in others}
    for name, group in groups.items():
        refuse_errors(
            name, group.levels, group.code, faults, allowed="what was meant, or an empty cell"
        )
    faults.stop()
    fields = Fields(
        stimuli=labels,
        left=left,
        right=right,
        outcome=outcome,
        people=people,
        person=person,
        groups=groups,
        response_s=response_s,
        time=trial if time is None else time,
        sided=sided and not won,
        left_out=unpaired + skipped,
        unanswered=skipped,
        uncounted=uncounted,
        encoding_guessed=table.encoding_guessed,
    )
    return fields if counts is None else _counted(fields, counts)


def _outcomes(
    table: Table,
    column: dict[str, str],
    names: Names,
    labels: tuple[str, ...],
    shown: tuple[NDArray[np.int64], NDArray[np.int64]],
    tied: str | None,
    faults: Faults,
) -> NDArray[np.int8]:
    """int8 [row], 1 where the left one was chosen or won, -1 the right one, 0 neither.

    tied: the column that says which answers are ties, where there is one.
    """
    if "winner" in column:
        outcome = np.ones(table.rows, np.int8)
        if tied is not None:
            outcome[ties_of(table, tied)] = 0
        return outcome
    outcome = outcomes_of(table, column["chosen"], names, labels, *shown, faults)
    if tied is not None:
        refuse_other_ties(table, tied, column["chosen"], outcome, faults)
    faults.stop()
    return outcome


def _counted(fields: Fields, counts: NDArray[np.int64]) -> Fields:
    """Each answer as often as its row says."""
    row = np.repeat(np.arange(len(counts)), counts)
    counted = fields.copy()
    counted["left"], counted["right"] = fields["left"][row], fields["right"][row]
    counted["outcome"] = fields["outcome"][row]
    person, response_s, time = fields["person"], fields["response_s"], fields["time"]
    counted["person"] = None if person is None else person[row]
    counted["response_s"] = None if response_s is None else response_s[row]
    counted["time"] = None if time is None else time[row]
    counted["groups"] = {
        name: replace(group, code=group.code[row]) for name, group in fields["groups"].items()
    }
    return counted


def _trials(table: Table, names: Names) -> tuple[Table, dict[str, str], int]:
    """The rows with a pair, one an answer, the columns by role, and how many rows had no pair."""
    faults = table.faults()
    if not (has_long(table, names) or has_winners(table, names)) and has_pairs(table):
        table = long_of(table, names, faults)
        faults.stop()
        names.pop("person", None)  # which is called person now
        if names.get("count"):
            names.pop("count")  # which is done with
    column = columns_of(table, names, faults)
    faults.stop()
    paired = with_pairs(table, column)
    return paired, column, table.rows - paired.rows


def _counting(
    table: Table, column: dict[str, str], question: str | None
) -> tuple[Table, dict[str, int]]:
    """The rows that count, and how many others do not, by a key of `REASONS`."""
    asked = of_question(table, question, list(column.values()))
    other = {} if asked.all() else {"question": int((~asked).sum())}
    table = table if asked.all() else table.take(asked)
    _, why = marked(table, column)
    out = excluded(table, column.values())
    why = [old or ("marked" if new else None) for old, new in zip(why, out.tolist(), strict=True)]
    kept = np.array([reason is None for reason in why], bool)
    return (table if kept.all() else table.take(kept)), other | counted_by_reason(why)


def _besides(uncounted: Mapping[str, int]) -> str:
    """How many answers there are that do not count, and why."""
    told = ", ".join(f"{count} {REASONS[reason]}" for reason, count in uncounted.items())
    return f" that counts (left out: {told})" if told else ""


def _telling(
    table: Table,
    person: NDArray[np.int64] | None,
    left: NDArray[np.int64],
    right: NDArray[np.int64],
    time: NDArray[np.float64] | None,
    trial: NDArray[np.float64] | None,
) -> list[NDArray[Any]]:
    """The columns by which answers are told apart; none where two alike may be two people's."""
    if person is not None:
        return [each for each in (person, left, right, time, trial) if each is not None]
    if time is None:
        return []
    return [codes_of(text_column(table, name))[1] for name in table.columns]


def _stimuli(
    table: Table, column: dict[str, str], given: Iterable[object] | None, faults: Faults
) -> tuple[tuple[str, ...], NDArray[np.int64], NDArray[np.int64]]:
    import pyarrow as pa

    sides = ("winner", "loser") if "winner" in column else ("left", "right")
    shown = [column[side] for side in sides]
    texts = [text_column(table, name) for name in shown]
    labels = None if given is None else labels_of(given)
    for name, text in zip(shown, texts, strict=True):
        check_labels(table, name, text, faults)
        refuse_nothing(name, text, faults, {"none", *(labels or ())})  # a dish without a sauce
    found, both = codes_of(pa.concat_arrays(texts))
    left, right = both[: table.rows], both[table.rows :]
    for name, code in zip(shown, (left, right), strict=True):
        refuse_errors(name, found, code, faults, labels or ())
        refuse_rounded(name, found, code, faults, labels or ())
    itself = np.flatnonzero((left == right) & (left >= 0))
    faults.say_of_rows(
        itself,
        lambda row: f"{quoted(found[left[row]])} is paired with itself; allowed: {_two(both, row)}",
    )
    faults.stop()
    check_alike(found, table.place)
    if labels is None:
        check_number(found, table.place)
        return found, left, right
    place = {label: index for index, label in enumerate(labels)}
    order = np.array([place.get(label, -1) for label in found], np.int64)
    for name, code in zip(shown, (left, right), strict=True):
        faults.say_of_rows(
            np.flatnonzero(order[code] < 0),
            lambda row, name=name, code=code: (  # type: ignore[misc]
                f"{name} is {quoted(found[code[row]])}; allowed: {listed(labels)}"
            ),
        )
    faults.stop()
    return labels, order[left], order[right]


def _two(both: NDArray[np.int64], row: int) -> str:
    """What is allowed for a pair of one; a first row with a label of its own tells of columns."""
    if row or (both == both[0]).sum() > 2:
        return "two stimuli"
    return "two stimuli (remove the row, if it says the units or kinds of the columns)"


def _people(
    table: Table, column: dict[str, str], faults: Faults
) -> tuple[tuple[str, ...], NDArray[np.int64] | None]:
    if "person" not in column:
        return (), None
    text = text_column(table, column["person"])
    check_labels(table, column["person"], text, faults)
    refuse_nothing(column["person"], text, faults)
    people, person = codes_of(text)
    refuse_errors(column["person"], people, person, faults)
    refuse_rounded(column["person"], people, person, faults)
    faults.stop()
    check_alike(people, table.place)
    return people, person


def _response(table: Table, column: dict[str, str], faults: Faults) -> NDArray[np.float64] | None:
    for role, per_s in (("response_s", 1.0), ("response_ms", 1000.0)):
        if role in column:
            return seconds_column(table, column[role], role, faults, per_s)
    return None
