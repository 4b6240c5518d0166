"""Which answers count: decided here and nowhere else.

Export, report, the lab's page, `nacreous scale` and adaptive plans all ask here.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, get_args

__all__ = ["DATA", "HEEDED", "KINDS", "Kind", "counts", "is_data"]

#: Why a trial is shown. "pair" is any trial that is asked for the first time, of whatever task; the
#: word is older than the other tasks, and stands in stores.
Kind = Literal["training", "pair", "repeat", "catch"]
KINDS: tuple[str, ...] = get_args(Kind)
#: Those that are data for a scale.
DATA: tuple[Kind, ...] = ("pair", "repeat")
#: What of an answer decides whether it counts. An export holds them; a table without is none.
HEEDED = ("kind", "excluded", "simulated")


def is_data(row: Mapping[str, Any]) -> bool:
    """Whether an answer is data for a scale, whoever gave it: training and catches are not.

    >>> [kind for kind in KINDS if is_data({"kind": kind})]
    ['pair', 'repeat']
    """
    return row["kind"] in DATA


def counts(row: Mapping[str, Any], *, simulated: bool = False) -> bool:
    """Whether an answer counts: data of somebody who is neither excluded nor withdrew.

    People's and simulated observers' never count together; `simulated` says which are wanted. An
    erased person's count as before.

    >>> row = {"kind": "pair", "excluded": None, "simulated": False}
    >>> counts(row), counts({**row, "excluded": "withdrew"}), counts(row, simulated=True)
    (True, False, False)
    """
    return is_data(row) and row["excluded"] is None and bool(row["simulated"]) == simulated
