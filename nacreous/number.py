"""Numbers from outside, checked once: what they are, or one clear message.

NumPy is loaded by the checks that need it: whoever asks for `said` alone may do without.
"""

from __future__ import annotations

import re
import reprlib
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from nacreous.problem import InputError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

#: The most characters of a value in a message **(ours)**.
_LONGEST_SAID = 200
#: What tables and their columns have.
_FRAMES = ("__arrow_c_stream__", "__arrow_c_array__", "iloc")


def row_of(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """A one-dimensional float64 array of the values, or one clear message."""
    import numpy as np

    row = np.atleast_1d(array_of(name, values))
    if row.ndim > 1:
        raise InputError(f"{name} has {row.ndim} dimensions; allowed: 1")
    return row


def array_of(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """A float64 array of the values, in their shape, or one clear message."""
    import numpy as np

    try:
        array = np.asarray(values)
    except (TypeError, ValueError):  # lists of different lengths
        array = np.array(None)
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise InputError(f"{name} has masked values; allowed: numbers, such as values.filled(0)")
    if array.dtype.kind not in "iuf":  # text, truth values and complex numbers would be converted
        raise InputError(f"{name} is {said(values)}; allowed: numbers")
    if array.dtype == np.float64 and array.flags.aligned:
        return array  # as np.require says too, three times as slowly
    return np.require(array, np.float64, "A")


def number_of(name: str, value: object) -> float:
    """A finite or infinite float, or one clear message."""
    import numpy as np

    value = alone(value)
    if isinstance(value, (int, float, np.integer, np.floating)) and not isinstance(value, bool):
        try:
            return float(value)
        except OverflowError:  # a whole number of hundreds of digits
            pass
    raise InputError(f"{name} is {said(value)}; allowed: a number")


def whole_of(name: str, value: object, least: int, most: int) -> int:
    """A whole number in a range, ends included, or one clear message.

    Floats are refused though they be whole, as `range(5.0)` and NumPy's `default_rng(5.0)` do: of
    two seeds beyond 2^53 they may make one.

    >>> whole_of("columns", 2.5, 2, 100)
    Traceback (most recent call last):
    nacreous.problem.InputError: columns is 2.5; allowed: a whole number, 2 to 100
    """
    import numpy as np

    value = alone(value)
    if isinstance(value, int | np.integer) and not isinstance(value, bool):
        number = int(value)
        if least <= number <= most:
            return number
    raise InputError(f"{name} is {said(value)}; allowed: a whole number, {least} to {most}")


def seed_of(seed: object) -> int:
    """A seed: a whole number from 0 to 2^63 - 1."""
    return whole_of("seed", seed, 0, 2**63 - 1)


def within(name: str, value: object, least: float, most: float) -> float:
    """A number in a range, ends included, or one clear message."""
    number = number_of(name, value)
    if not least <= number <= most:
        raise InputError(f"{name} is {number:g}; allowed: {least:g} to {most:g}")
    return number


def index_of(name: str, value: object) -> complex:
    """A complex index, or one clear message."""
    import numpy as np

    value = alone(value)
    if isinstance(value, (int, float, complex, np.number)) and not isinstance(value, bool):
        try:
            return complex(value)
        except OverflowError:
            pass
    raise InputError(f"{name} is {said(value)}; allowed: a number n or a complex number n + ik")


def alone(value: Any) -> Any:
    """What an array without dimensions holds, as NumPy's own functions take it."""
    import numpy as np

    return value[()] if isinstance(value, np.ndarray) and value.ndim == 0 else value


def truth_of(name: str, value: object) -> bool:
    """Yes or no, and no word or number that Python would take for either.

    >>> truth_of("alpha", "no")
    Traceback (most recent call last):
    nacreous.problem.InputError: alpha is 'no'; allowed: True, False
    """
    if isinstance(value, bool):
        return value
    if type(value).__module__ == "numpy" and type(truth := alone(value)).__name__.startswith(
        "bool"
    ):
        return bool(truth)
    raise InputError(f"{name} is {said(value)}; allowed: True, False")


def said(value: object) -> str:
    """A value as Python writes it, on one line and never long; a table by how much it holds.

    >>> said([{"left": "a", "right": "b"}] * 12)
    'a list of 12 dicts'
    """
    if (size := _rows_said(value)) is not None:
        return size
    try:
        text = re.sub(r"\s*\n\s*", " ", reprlib.repr(value))
    except ValueError:  # a whole number of more digits than Python agrees to print
        return "a number of thousands of digits"
    return text if len(text) <= _LONGEST_SAID else f"{text[: _LONGEST_SAID - 3]}..."


def _rows_said(value: Any) -> str | None:
    """A frame or a column of pandas, Polars or pyarrow, or a list of rows; None of all else."""
    if isinstance(value, list | tuple):
        dicts = len(value) > 0 and isinstance(value[0], Mapping)
        return f"a {type(value).__name__} of {_counted(len(value), 'dict')}" if dicts else None
    framed = any(hasattr(value, name) for name in _FRAMES)
    if isinstance(value, type) or not framed or not hasattr(value, "__len__"):
        return None
    kind = type(value).__name__
    return f"{'an' if kind[0] in 'AEIOU' else 'a'} {kind} of {_counted(len(value), 'row')}"


def _counted(count: int, what: str) -> str:
    return f"{count} {what}{'' if count == 1 else 's'}"
