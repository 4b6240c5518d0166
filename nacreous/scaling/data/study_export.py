"""Exports of studies, in which practice, simulated observers and excluded people stand beside data.

Which rows count is known where studies are; here an export is only told from other tables.
"""

from __future__ import annotations

from nacreous.problem import InputError
from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.nothing import is_nothing
from nacreous.scaling.data.table import Table
from nacreous.scaling.data.truth import says_true

#: What exports hold in the column `kind`, and which columns say yes or no.
_KINDS = {"training", "pair", "repeat", "catch"}
_FLAGS = ("simulated", "erased")


def refuse_study_export(table: Table) -> None:
    """Refuse a table that says of each row whether it is data, for not all its rows are.

    >>> from nacreous.scaling.data.table import table_of
    >>> refuse_study_export(table_of({"left": ["a"], "kind": ["catch"]}))
    Traceback (most recent call last):
    nacreous.problem.InputError: table: has the column kind of a study's export, which says that ...
    """
    found = [name for name in table.columns if _marks_data(table, name)]
    if found:
        named = f"column{'s' if len(found) > 1 else ''} {' and '.join(found)}"
        raise InputError(
            f"{table.place}: has the {named} of a study's export, which "
            f"say{'s' if len(found) == 1 else ''} that not every row is data; allowed: the file as "
            "`nacreous study export` wrote it, for `nacreous scale` or "
            "nacreous.study.results.exported_answers; or the rows that count, without "
            f"{'these columns' if len(found) > 1 else 'this column'}"
        )


def _marks_data(table: Table, name: str) -> bool:
    import pyarrow as pa

    column = name.strip().casefold()
    if column != "kind" and column not in _FLAGS:
        return False
    text = text_column(table, name)
    said = text.filter(pa.array(~is_nothing(text))).unique().to_pylist()
    if column == "kind":
        return bool(said) and {cell.casefold() for cell in said} <= _KINDS
    return bool(said) and all(says_true(cell) is not None for cell in said)
