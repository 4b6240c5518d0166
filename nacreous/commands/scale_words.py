"""The words of the trade that `nacreous scale` says of things whose numbers are known."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from nacreous.problem import InputError
    from nacreous.scaling.data.table import Table
    from nacreous.scaling.report.called import Called
    from nacreous.trade import Factor

__all__ = ["called_of"]

_LABEL = "stimulus"


def called_of(place: str, labels: Collection[str]) -> dict[str, tuple[Called, ...]]:
    """Words by label, from a frozen study's folder or a table of numbers.

    A table has a row for each stimulus, with the columns stimulus and quantities of the trade's
    table, such as facet_spread_rad, or with the factor in front, such as luster.facet_spread_rad,
    where several factors have one. Raises `InputError`, also where no label is one of `labels`.
    """
    from nacreous.problem import InputError
    from nacreous.scaling.data.fault import listed
    from nacreous.study.design import open_frozen
    from nacreous.study.design.called import called_stimuli

    if Path(place).is_dir():
        frozen = open_frozen(place)
        found, named = called_stimuli(frozen), [one.label for one in frozen.stimuli]
    else:
        found = _of_table(place)
        named = list(found)
    if not set(named) & set(labels):
        raise InputError(
            f"{place}: none of its stimuli ({listed(named)}) was compared; "
            f"wanted: some of {listed(labels)}"
        )
    return found


def _of_table(place: str) -> dict[str, tuple[Called, ...]]:
    import numpy as np

    from nacreous.scaling.data.column import text_column
    from nacreous.scaling.data.fault import quoted
    from nacreous.scaling.data.label import label_of
    from nacreous.scaling.data.spreadsheet import as_given
    from nacreous.scaling.data.table import read_table

    table = read_table(place, [{_LABEL}], rows="stimuli")
    faults = table.faults()
    if _LABEL not in table.columns:
        faults.say(f"has no column {_LABEL}; it has {', '.join(table.columns)}")
    faults.stop()
    labels = [as_given(text or "") for text in text_column(table, _LABEL).to_pylist()]
    rows: dict[str, int] = {}
    bad = [
        row
        for row, label in enumerate(map(label_of, labels))
        if not label.strip() or rows.setdefault(label, row) != row
    ]
    faults.say_of_rows(
        np.array(bad, np.int64),
        lambda row: f"{_LABEL} is {quoted(labels[row])}; allowed: a label, each once",
    )
    columns = _columns(table)
    if not columns:
        faults.say("has no quantity of the trade's table; wanted: such as facet_spread_rad")
    faults.stop()
    found: dict[str, list[Called]] = {label: [] for label in rows}
    for factor, names in columns.items():
        for label, one in zip(rows, _said(table, factor, names), strict=True):
            found[label] += one
    return {label: tuple(each) for label, each in found.items()}


def _columns(table: Table) -> dict[str, dict[str, str]]:
    """The columns that hold quantities of a factor, by factor and quantity."""
    from nacreous.trade import factors

    owners = [quantity for factor in factors() for quantity in factor.quantities]
    found: dict[str, dict[str, str]] = {}
    for factor in factors():
        for quantity in factor.quantities:
            names = [f"{factor.name}.{quantity}"]
            names += [quantity] if owners.count(quantity) == 1 else []
            for name in names:
                if name in table.columns:
                    found.setdefault(factor.name, {}).setdefault(quantity, name)
    return found


def _said(table: Table, name: str, columns: dict[str, str]) -> Iterator[list[Called]]:
    """A factor's word of each row; none where a cell is empty, or not enough is known."""
    import numpy as np

    from nacreous.problem import InputError
    from nacreous.scaling.data.number_column import number_column
    from nacreous.study.design.called import called
    from nacreous.trade import word_of
    from nacreous.trade.table import factor_of

    factor, faults = factor_of(name), table.faults()
    numbers = {
        quantity: number_column(table, column, None, faults, -np.inf)
        for quantity, column in columns.items()
    }
    faults.stop()
    said: list[list[Called]] = []
    for row in range(table.rows):
        values = {quantity: float(column[row]) for quantity, column in numbers.items()}
        values = {quantity: value for quantity, value in values.items() if not np.isnan(value)}
        try:
            said.append([called(word_of(name, values), values)] if _enough(factor, values) else [])
        except InputError as problem:
            faults.say_of_rows(np.array([row]), partial(_verdict, problem))
            said.append([])
    faults.stop()
    return iter(said)


def _verdict(problem: InputError, _row: int) -> str:
    return str(problem)


def _enough(factor: Factor, values: Collection[str]) -> bool:
    """Whether a word can be told: by any quantity, or by all where words bind different ones."""
    return bool(values) and (factor.is_told_by_each or set(values) == set(factor.quantities))
