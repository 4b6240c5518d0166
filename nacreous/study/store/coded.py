"""Columns that grow part by part, each text kept once: millions of answers in little memory."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import pyarrow as pa

__all__ = ["Coded"]


class Coded:
    """Columns by name; kinds: "text", kept as an Arrow dictionary, or an Arrow type by its name.

    >>> columns = Coded({"left": "text", "trial": "int64"})
    >>> columns.add({"left": ["a", "b"], "trial": [0, 1]})
    >>> columns.add({"left": ["b", None], "trial": [2, 3]})
    >>> columns.table()["left"].to_pylist()
    ['a', 'b', 'b', None]
    """

    def __init__(self, kinds: Mapping[str, str]) -> None:
        self._kinds = dict(kinds)
        self._codes: dict[str, dict[str, int]] = {
            name: {} for name, kind in kinds.items() if kind == "text"
        }
        self._parts: dict[str, list[Any]] = {name: [] for name in kinds}

    def add(self, part: Mapping[str, Sequence[Any] | pa.ChunkedArray]) -> None:
        """More rows; other columns of the part are left out. Arrow's are of the kinds' types."""
        import pyarrow as pa

        for name, kind in self._kinds.items():
            if kind == "text":
                self._parts[name].append(_indices(part[name], self._codes[name]))
            else:
                held, of = part[name], pa.type_for_alias(kind)
                more = held.chunks if isinstance(held, pa.ChunkedArray) else [pa.array(held, of)]
                self._parts[name].extend(more)

    def table(self) -> pa.Table:
        """All rows, each column in one piece; nothing can be added after."""
        import pyarrow as pa

        return pa.table({name: self._column(name) for name in self._kinds})

    def _column(self, name: str) -> Any:
        import pyarrow as pa

        parts, kind = self._parts.pop(name), self._kinds[name]
        if kind != "text":
            return pa.chunked_array(parts, pa.type_for_alias(kind)).combine_chunks()
        rows = np.concatenate([np.zeros(0, np.int16), *parts])
        del parts  # which are as large once more
        indices = pa.array(rows, mask=rows < 0 if rows.min(initial=0) < 0 else None)
        return pa.DictionaryArray.from_arrays(indices, pa.array(self._codes[name], pa.string()))


def _indices(texts: Any, codes: dict[str, int]) -> NDArray[np.int16] | NDArray[np.int32]:
    """The code of each text, -1 of None; one that is new gets the next. Few take two bytes each."""
    import pyarrow as pa

    if isinstance(texts, pa.ChunkedArray):
        found = texts.combine_chunks()
    else:
        found = pa.array(texts, pa.string()).dictionary_encode()
    own = [codes.setdefault(text, len(codes)) for text in found.dictionary.to_pylist()]
    places = np.asarray(found.indices.fill_null(len(own)), np.int64)
    if len(codes) <= np.iinfo(np.int16).max:
        return np.array([*own, -1], np.int16)[places]
    return np.array([*own, -1], np.int32)[places]
