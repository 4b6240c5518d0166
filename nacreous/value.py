"""Results as values: they never change, and compare, hash, copy and pickle as their numbers.

So a result can be a key of a dict, go to another process and come back equal, and be handed on
without fear that somebody writes into it.
"""

from __future__ import annotations

import dataclasses
import math
import re
from collections.abc import Sized
from typing import Any, TypeVar, dataclass_transform

from nacreous.unchanging import key_of, ordered, seen, settled

__all__ = ["in_short", "value_class"]

T = TypeVar("T")

#: The most numbers of an array, and characters of another field, that stand in a repr **(ours)**.
_MOST_SHOWN, _LONGEST_SHOWN = 12, 300

#: Types of fields that may hold arrays.
_ARRAYS = re.compile(r"[Aa]rray|\bAny\b")


class _Shown:
    """A field whose arrays are handed out as views, so that their shape and dtype stay too."""

    def __init__(self, field: dataclasses.Field[Any]) -> None:
        self.name, self.default = field.name, field.default

    def __get__(self, owner: object, kind: type[Any]) -> Any:
        """A view, or of the class the default."""
        if owner is None:
            if self.default is dataclasses.MISSING:
                raise AttributeError(f"{kind.__name__} has no default of {self.name!r}")
            return self.default
        try:
            return seen(owner.__dict__[self.name])
        except KeyError:
            raise AttributeError(f"{kind.__name__} has no {self.name!r} yet") from None

    def __set__(self, owner: object, item: object) -> None:
        """While the value is made."""
        owner.__dict__[self.name] = item


@dataclass_transform(
    eq_default=False, frozen_default=True, field_specifiers=(dataclasses.field, dataclasses.Field)
)
def value_class(cls: type[T]) -> type[T]:
    """A frozen dataclass that is a value, its arrays, lists and dicts included.

    Arrays become read-only copies, unless they are read-only already; lists become tuples, mappings
    a `ReadOnlyMapping`. Equal are objects of one class whose fields are equal, NaN to NaN; a field
    of `compare=False` does not count. Pickled and copied are the fields, from which an object is
    made again; so a class with an `__init__` of its own takes the fields by their names.

    >>> import numpy as np
    >>> @value_class
    ... class Spectrum:
    ...     values: np.ndarray
    >>> Spectrum(np.ones(3)) == Spectrum(np.ones(3)), Spectrum(np.ones(3)) == Spectrum(np.ones(4))
    (True, False)
    >>> Spectrum(np.ones(3)).values[0] = 2
    Traceback (most recent call last):
    ValueError: assignment destination is read-only
    """
    own = cls.__dict__.get("__post_init__")

    def finish(self: Any) -> None:
        if own is not None:
            own(self)
        for name, item in list(vars(self).items()):
            if (kept := settled(item)) is not item:
                object.__setattr__(self, name, kept)

    cls.__post_init__ = finish  # type: ignore[attr-defined]
    cls.__eq__ = _equal  # type: ignore[method-assign]
    cls.__hash__ = _hash  # type: ignore[method-assign]
    cls.__dask_tokenize__ = _token  # type: ignore[attr-defined]
    if "__repr__" not in cls.__dict__:
        cls.__repr__ = in_short  # type: ignore[method-assign]
    made = dataclasses.dataclass(frozen=True, eq=False)(cls)

    def state(self: Any) -> dict[str, Any]:
        return _state(made, self)

    def set_state(self: Any, state: dict[str, Any]) -> None:
        _set_state(made, self, state)

    for field in dataclasses.fields(made):  # type: ignore[arg-type]
        if _ARRAYS.search(str(field.type)):
            setattr(made, field.name, _Shown(field))
    cls.__getstate__ = state  # type: ignore[method-assign]
    cls.__setstate__ = set_state  # type: ignore[attr-defined]
    return made


def in_short(self: Any) -> str:
    """A dataclass as its fields, of which long ones are told by how long they are.

    >>> import numpy as np
    >>> @value_class
    ... class Spectrum:
    ...     name: str
    ...     values: np.ndarray
    >>> Spectrum("E", np.ones((4, 41)))
    Spectrum(name='E', values=<float64 array, 4 x 41>)
    """
    shown = (
        f"{field.name}={_part(getattr(self, field.name))}"
        for field in dataclasses.fields(self)
        if field.repr
    )
    return f"{type(self).__qualname__.rpartition('.')[2]}({', '.join(shown)})"


def _part(item: Any) -> str:
    shape = getattr(item, "shape", None)
    if isinstance(shape, tuple) and math.prod(shape) > _MOST_SHOWN:
        return f"<{item.dtype} array, {' x '.join(map(str, shape))}>"
    text = repr(item)
    if len(text) <= _LONGEST_SHOWN:
        return text
    if isinstance(item, Sized) and not isinstance(item, str):
        return f"<{len(item)} {'items' if len(item) != 1 else 'item'}>"
    return f"{text[:_LONGEST_SHOWN]}..."


def _key(self: Any) -> tuple[Any, ...]:
    fields = (field.name for field in dataclasses.fields(self) if field.compare)
    return tuple(key_of(getattr(self, name)) for name in fields)


def _equal(self: Any, other: object) -> bool:
    """Equal fields of the same class."""
    if type(other) is not type(self):
        return NotImplemented  # type: ignore[no-any-return]
    return self is other or bool(_key(self) == _key(other))


def _hash(self: Any) -> int:
    """Equal values have equal hashes."""
    return hash((type(self), *_key(self)))


def _token(self: Any) -> tuple[Any, ...]:
    """What Dask knows equal values by."""
    kind = type(self)
    return kind.__module__, kind.__qualname__, *map(ordered, _key(self))


def _state(made: type[Any], self: Any) -> dict[str, Any]:
    """What it is made from; of a sub-class also what that keeps beside."""
    fields = (field.name for field in dataclasses.fields(made) if field.init)
    state = {name: getattr(self, name) for name in fields}
    if type(self) is made:
        return state
    bare = object.__new__(made)
    made.__init__(bare, **state)
    return state | {name: item for name, item in vars(self).items() if name not in vars(bare)}


def _set_state(made: type[Any], self: Any, state: dict[str, Any]) -> None:
    """Made and checked again, by the `__init__` that takes the fields."""
    names = {field.name for field in dataclasses.fields(made) if field.init}
    made.__init__(self, **{name: item for name, item in state.items() if name in names})
    for name in state.keys() - names:
        object.__setattr__(self, name, state[name])
