"""Exports of studies, in which practice, simulated observers and excluded people stand beside data.

Which rows count is known where studies are; here an export is only told from other tables.
"""

from __future__ import annotations

from nacreous.problem import InputError
from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.table import Table

#: What exports hold in these columns, in small letters and as spreadsheets write it.
_WORDS = {
    "kind": {"training", "pair", "repeat", "catch"},
    "simulated": {"true", "false", "0", "1", "0.0", "1.0"},
    "erased": {"true", "false"},
}


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
    words = _WORDS.get(name.strip().casefold())
    if words is None:
        return False
    found = text_column(table, name).unique().to_pylist()
    cells = {(cell or "").strip().casefold() for cell in found}
    return cells <= {*words, ""} and cells != {""}
