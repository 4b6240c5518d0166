"""Things that nobody changes any more: read-only arrays, tuples and mappings, and what they equal.

NumPy is loaded where there is an array to look at, and `dataclasses` where one is to be made, for
the shortest way to a picture has neither.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, NoReturn, TypeGuard, TypeVar

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = [
    "ReadOnlyMapping",
    "Unchanging",
    "keep",
    "key_of",
    "ordered",
    "released",
    "seen",
    "settled",
]

K = TypeVar("K")
V = TypeVar("V", covariant=True)


class ReadOnlyMapping(Mapping[K, V]):
    """A dict that nobody changes any more.

    >>> shares = ReadOnlyMapping({"mika": 0.5})
    >>> shares["mika"], shares == {"mika": 0.5}
    (0.5, True)
    """

    __slots__ = ("_items",)

    def __init__(self, items: Mapping[K, V]) -> None:
        self._items: dict[K, V] = {key: settled(item) for key, item in items.items()}

    def __getitem__(self, key: K) -> V:
        """The item of a key."""
        item: V = seen(self._items[key])
        return item

    def __iter__(self) -> Iterator[K]:
        """The keys in their order."""
        return iter(self._items)

    def __len__(self) -> int:
        """How many items."""
        return len(self._items)

    def __eq__(self, other: object) -> bool:
        """Equal items under equal keys."""
        return key_of(self) == key_of(other) if isinstance(other, Mapping) else NotImplemented

    def __hash__(self) -> int:
        """Equal mappings have equal hashes."""
        return hash(key_of(self))

    def __reduce__(self) -> tuple[type[ReadOnlyMapping[K, V]], tuple[dict[K, V]]]:
        """By its items, for pickles of every protocol."""
        return type(self), (self._items,)

    def __repr__(self) -> str:
        """As the dict."""
        return repr(self._items)


class Unchanging:
    """What refuses that an attribute is set or deleted, as a frozen dataclass does."""

    __slots__ = ()

    def __setattr__(self, name: str, _: object) -> NoReturn:
        """Refused."""
        raise _frozen(f"cannot assign to field {name!r}")

    def __delattr__(self, name: str) -> NoReturn:
        """Refused."""
        raise _frozen(f"cannot delete field {name!r}")


def _frozen(message: str) -> AttributeError:
    from dataclasses import FrozenInstanceError

    return FrozenInstanceError(message)


def settled(item: Any) -> Any:
    """A thing that nobody can change any more, as `value_class` keeps it."""
    if is_array(item):
        return _read_only(item)
    if type(item) in (list, tuple):
        return tuple(map(settled, item))
    if isinstance(item, Mapping) and not isinstance(item, ReadOnlyMapping):
        return ReadOnlyMapping(item)
    return item


def seen(item: Any) -> Any:
    """What is handed out: of an array a view, for NumPy lets anybody set shape and dtype of one.

    >>> import numpy as np
    >>> kept = released(np.arange(6))
    >>> seen(kept).shape = (2, 3)
    >>> kept.shape
    (6,)
    """
    if type(item) is tuple:
        return tuple(map(seen, item)) if any(map(is_array, item)) else item
    return item.view() if is_array(item) else item


def released(array: NDArray[Any]) -> NDArray[Any]:
    """An array that nobody else holds, read-only where it lies, so that it need not be copied.

    What comes back cannot be made writable again.

    >>> import numpy as np
    >>> released(np.arange(6).reshape(2, 3)).flags.writeable
    False
    """
    if _can_be_unlocked(array):
        return _sealed(array)
    for held in _holders(array):
        held.flags.writeable = False
    return array


def key_of(item: Any) -> Any:
    """What equal things have in common, for comparison and hash: numbers by value, NaN as NaN."""
    if is_array(item):
        numbers = item + 0.0 if item.dtype.kind in "fc" else item  # -0.0 is 0.0
        return item.dtype.str, item.shape, numbers.tobytes()
    if isinstance(item, Mapping):
        return frozenset((key, key_of(part)) for key, part in item.items())
    if isinstance(item, (tuple, list)):
        return tuple(map(key_of, item))
    if type(item).__module__ == "numpy" and hasattr(item, "item"):  # float32(1.1) equals 1.1 there
        item = item.item()
    if isinstance(item, (float, complex)) and item != item:
        return "nan"
    return item


def ordered(key: Any) -> Any:
    """A key of `key_of` in one form: mappings in a fixed order, equal numbers of one type."""
    if isinstance(key, frozenset):
        return "mapping", *sorted(map(ordered, key), key=repr)
    if isinstance(key, tuple):
        return tuple(map(ordered, key))
    if isinstance(key, complex) and key.imag == 0:
        key = key.real
    if (isinstance(key, float) and key.is_integer()) or isinstance(key, bool):
        return int(key)
    return key + 0.0 if isinstance(key, complex) else key


def is_array(item: object) -> TypeGuard[NDArray[Any]]:
    """Whether it is an array; where NumPy was never loaded, nothing is."""
    numpy = sys.modules.get("numpy")
    return numpy is not None and isinstance(item, numpy.ndarray)


def _read_only(array: NDArray[Any]) -> NDArray[Any]:
    written = any(held.flags.writeable for held in _holders(array))
    return _locked(array) if written or _can_be_unlocked(array) else array


def _can_be_unlocked(array: NDArray[Any]) -> bool:
    """Whether NumPy would make it writable again, as it does where an array owns the memory."""
    return bool(_holders(array)[-1].flags.owndata)


def _sealed(array: NDArray[Any]) -> NDArray[Any]:
    """The same memory, seen as bytes that are there to be read."""
    import numpy as np

    if not array.size or array.dtype.hasobject or not array.flags.c_contiguous:
        return _locked(array)
    seen = array.reshape(-1).view(np.uint8).data.toreadonly()
    return np.frombuffer(seen, array.dtype).reshape(array.shape)


def _locked(array: NDArray[Any]) -> NDArray[Any]:
    """A copy on bytes, which nobody can make writable again."""
    import numpy as np

    if array.size and not array.dtype.hasobject:
        return np.frombuffer(array.tobytes(), array.dtype).reshape(array.shape)
    copy = array.copy()
    copy.flags.writeable = False
    return copy


def _holders(array: NDArray[Any]) -> list[NDArray[Any]]:
    """The array, the one whose memory it looks at, and so on."""
    ndarray = sys.modules["numpy"].ndarray
    holders = []
    held: Any = array
    while isinstance(held, ndarray):
        holders.append(held)
        held = held.base
    return holders


def keep(self: object, **fields: Any) -> None:
    """Set fields of a frozen object while it is made."""
    for name, item in fields.items():
        object.__setattr__(self, name, settled(item))
