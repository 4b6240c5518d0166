"""Kinds of values that tables hold besides text and numbers, as text, or by a plain name."""

from __future__ import annotations

from typing import Any
from uuid import UUID


def plain_values(values: Any) -> Any:
    """A pandas column of periods as the times at which they begin, and of intervals as text."""
    dtype = getattr(values, "dtype", None)
    kind = getattr(getattr(dtype, "categories", None), "dtype", dtype)
    if str(dtype).startswith("period"):
        return getattr(values, "dt", values).to_timestamp()
    if str(kind).startswith("interval"):
        return [None if each != each else str(each) for each in values]
    return values


def plain_array(array: Any) -> Any:
    """An Arrow array without what only says how its values are stored; a UUID is its text."""
    import pyarrow as pa
    import pyarrow.compute as pc

    kind = array.type
    if pa.types.is_run_end_encoded(kind):
        return plain_array(pc.run_end_decode(array))
    if pa.types.is_dictionary(kind) and isinstance(kind.value_type, pa.BaseExtensionType):
        return plain_array(array.dictionary_decode())
    if not isinstance(kind, pa.BaseExtensionType):
        return array
    if kind.extension_name == "arrow.uuid":
        cells = array.storage.to_pylist()
        texts = [None if cell is None else str(UUID(bytes=cell)) for cell in cells]
        return pa.array(texts, pa.large_string())
    if kind.extension_name == "arrow.bool8":
        return pc.cast(array.storage, pa.bool_())
    flat = pa.types.is_string(array.storage.type) or pa.types.is_large_string(array.storage.type)
    return array.storage if flat else array


def kind_said(kind: Any) -> str:
    """What a column of that Arrow type holds, in plain words.

    >>> import pyarrow
    >>> kind_said(pyarrow.large_list(pyarrow.string())), kind_said(pyarrow.time32("s"))
    ('lists', 'times of day')
    """
    import pyarrow as pa

    of = pa.types
    if isinstance(kind, pa.BaseExtensionType):
        return kind_said(kind.storage_type)
    words = (
        ("times of day", (of.is_time,)),
        ("lengths of time", (of.is_duration, of.is_interval)),
        ("bytes that are no text", (of.is_binary, of.is_large_binary, of.is_fixed_size_binary)),
        ("bytes that are no text", (of.is_binary_view,)),
        ("lists", (of.is_list, of.is_large_list, of.is_fixed_size_list)),
        ("lists", (of.is_list_view, of.is_large_list_view)),
        ("records of several values", (of.is_struct, of.is_map)),
        ("values of several kinds", (of.is_union,)),
    )
    return next((word for word, asks in words if any(ask(kind) for ask in asks)), "other values")
