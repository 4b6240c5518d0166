"""Attributes of stimuli, such as physical parameters: a number for each stimulus and attribute."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.number import number_of, said
from nacreous.problem import InputError
from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.fault import listed, nearest, quoted
from nacreous.scaling.data.header import name_of
from nacreous.scaling.data.label import check_visible, label_of
from nacreous.scaling.data.number_column import number_column
from nacreous.scaling.data.table import read_table, table_of
from nacreous.value import value_class

__all__ = ["AttributeTable", "check_columns", "products"]

Array = NDArray[np.float64]

#: A column counts as a sum of others if what is left of it is no more than this.
_NOTHING = 1e-8
_LARGEST = 1e100


@value_class
class AttributeTable:
    """Finite numbers, one a stimulus and attribute.

    stimuli  labels; names  attributes; values  float64 [stimulus, attribute]
    """

    stimuli: tuple[str, ...]
    names: tuple[str, ...]
    values: Array

    @classmethod
    def of(cls, attributes: Any, stimulus: str = "stimulus") -> AttributeTable:
        """From label -> {attribute: number}, or a table with a column of labels, or its file.

        Raises `InputError` for cells that are no finite number, labels that come twice, and
        attributes that one stimulus has and another has not.

        >>> AttributeTable.of({"a": {"lustre": 1}, "b": {"lustre": 2.5}}).values.tolist()
        [[1.0], [2.5]]
        """
        if isinstance(attributes, AttributeTable):
            return attributes
        if isinstance(attributes, Mapping) and any(
            isinstance(row, Mapping) for row in attributes.values()
        ):
            return cls._of_rows(attributes)
        return cls._of_columns(attributes, stimulus)

    @classmethod
    def _of_rows(cls, rows: Mapping[Any, Any]) -> AttributeTable:
        first = next(iter(rows.values()))
        names = tuple(label_of(str(name)) for name in first) if isinstance(first, Mapping) else ()
        if not names:
            raise InputError("attributes has none; allowed: 1 attribute or more a stimulus")
        check_visible(names, "attributes")
        values = np.empty((len(rows), len(names)))
        for index, (label, row) in enumerate(rows.items()):
            place = f"attributes[{quoted(label)}]"
            if not isinstance(row, Mapping):
                raise InputError(f"{place} is {said(row)}; allowed: attribute -> number")
            cells = {label_of(str(name)): value for name, value in row.items()}
            if cells.keys() != set(names):
                odd = sorted(cells.keys() ^ set(names))
                raise InputError(f"{place} has {listed(cells)}, not the same as others: {odd[0]}")
            for column, name in enumerate(names):
                values[index, column] = _finite(f"{place}[{quoted(name)}]", cells[name])
        return cls(tuple(label_of(str(label)) for label in rows), names, values)

    @classmethod
    def _of_columns(cls, attributes: Any, stimulus: str) -> AttributeTable:
        is_path = isinstance(attributes, str | PathLike)
        table = read_table(attributes) if is_path else table_of(attributes)
        stimulus = name_of(stimulus)
        if stimulus not in table.columns:
            near = nearest(stimulus, table.columns)
            hint = f"did you mean {near}?" if near else f"columns here: {listed(table.columns)}"
            raise InputError(f"{table.place}: has no column {stimulus}; {hint}")
        labels = tuple(text_column(table, stimulus).to_pylist())
        names = tuple(name for name in table.columns if name != stimulus)
        check_visible(names, "attributes")
        faults = table.faults()
        if not names:
            faults.say(f"has no column but {stimulus}; allowed: 1 attribute or more")
        columns = [number_column(table, name, None, faults, -np.inf) for name in names]
        faults.stop()
        for row, label in enumerate(labels):
            place = f"{table.place}: row {table.numbers[row]}"
            if label is None:
                raise InputError(f"{place}: {stimulus} is empty; allowed: a label")
            if label in labels[:row]:
                raise InputError(f"{place}: {stimulus} is {quoted(label)} again; allowed: once")
            for name, column in zip(names, columns, strict=True):
                _finite(f"{place}: {name}", float(column[row]))
        return cls(labels, names, np.column_stack(columns))

    def rows_of(self, stimuli: Sequence[str]) -> Array:
        """Values of these stimuli in their order, float64 [stimulus, attribute]."""
        missing = [label for label in stimuli if label not in self.stimuli]
        if missing:
            raise InputError(
                f"attributes lack the stimuli {listed(missing)}; allowed: a row for each of the "
                f"{len(stimuli)} that were judged"
            )
        return self.values[[self.stimuli.index(label) for label in stimuli]]

    def terms_of(self, terms: Sequence[str] | None) -> tuple[tuple[str, ...], ...]:
        """Terms as tuples of attributes: "lustre:grain" is a product; None is all of them."""
        if terms is None:
            return tuple((name,) for name in self.names)
        if isinstance(terms, str) or not isinstance(terms, Sequence) or not terms:
            raise InputError(f"terms is {said(terms)}; allowed: a list of {listed(self.names)}")
        found: list[tuple[str, ...]] = []
        for term in terms:
            parts = tuple(label_of(part) for part in str(term).split(":"))
            for name in parts:
                if name not in self.names:
                    near = nearest(name, self.names)
                    hint = f"did you mean {near}?" if near else f"allowed: {listed(self.names)}"
                    raise InputError(f"terms: {quoted(name)} is no attribute; {hint}")
            if sorted(parts) in [sorted(other) for other in found]:
                raise InputError(f"terms has {quoted(term)} again; allowed: each once")
            found.append(parts)
        return tuple(found)


def products(values: Array, names: Sequence[str], terms: Sequence[tuple[str, ...]]) -> Array:
    """Columns of terms, float64 [stimulus, term]: products of their attributes' columns."""
    place = {name: column for column, name in enumerate(names)}
    return np.column_stack(
        [values[:, [place[name] for name in term]].prod(axis=1) for term in terms]
    )


def check_columns(columns: Array, terms: Sequence[str]) -> None:
    """Refuse a column that is the same for all stimuli, or a sum of earlier ones, by its name."""
    rows = len(columns)
    if len(terms) > rows - 1:
        raise InputError(
            f"there are {len(terms)} terms for {rows} stimuli; allowed: up to {rows - 1}"
        )
    centred = columns - columns.mean(axis=0)
    sizes = np.linalg.norm(centred, axis=0)
    for j, name in enumerate(terms):
        if sizes[j] <= _NOTHING * max(float(np.abs(columns[:, j]).max()), 1e-300):
            value = columns[0, j]
            raise InputError(f"{name} is {value:g} for every stimulus; allowed: a term that varies")
    unit = centred / sizes
    for j in range(1, len(terms)):
        parts, *_ = np.linalg.lstsq(unit[:, :j], unit[:, j], rcond=None)
        if np.linalg.norm(unit[:, j] - unit[:, :j] @ parts) <= _NOTHING:
            others = listed(terms[k] for k in range(j) if abs(parts[k]) > 1e-6)
            raise InputError(
                f"{terms[j]} says nothing that {others} do not say; allowed: terms of which none "
                "is a sum of others"
            )


def _finite(place: str, value: object) -> float:
    number = number_of(place, value)
    if not abs(number) <= _LARGEST:
        raise InputError(f"{place} is {number:g}; allowed: a finite number")
    return number
