"""The numbers and texts that a picture is made of, checked once where they come in."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from nacreous.number import array_of, said
from nacreous.problem import InputError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

__all__ = ["layers_of", "linear_of", "luminance", "texts_of"]


def linear_of(linear: ArrayLike) -> NDArray[np.float32]:
    """Float32 [row, column, rgb], or one clear message.

    >>> linear_of([[[0.5, 0.5, 0.5]]]).dtype
    dtype('float32')
    """
    array = _single("linear", linear)
    kind = getattr(linear, "dtype", None)
    if kind is not None and kind.kind in "iu" and array.max(initial=0) > 1:
        raise InputError(
            f"linear holds whole numbers up to {array.max():g}, as codes are; allowed: light, "
            "white as 1 (of a picture's file: nacreous.file.read_photograph)"
        )
    if array.ndim != 3 or array.shape[2] != 3 or not array.size:
        raise InputError(f"linear has the shape {array.shape}; allowed: [row, column, 3]")
    return array


def luminance(linear: NDArray[np.floating]) -> NDArray[np.float64]:
    """Luminance Y of linear sRGB [..., 3] (IEC 61966-2-1).

    >>> import numpy as np
    >>> luminance(np.ones(3)).round(6).tolist()
    1.0
    """
    import numpy as np

    return np.asarray(linear @ np.array([0.2126, 0.7152, 0.0722]))


def layers_of(
    layers: Mapping[str, ArrayLike], linear: NDArray[np.float32]
) -> dict[str, NDArray[np.float32]]:
    """Float32 [row, column, channel] by name, as many pixels as `linear`, or one clear message."""
    if not isinstance(layers, Mapping):
        raise InputError(f"layers are {said(layers)}; allowed: arrays by name")
    made = {}
    for name, layer in layers.items():
        array = _single(f"layer {said(name)}", layer)
        if array.ndim != 3 or array.shape[:2] != linear.shape[:2]:
            rows, columns = linear.shape[:2]
            raise InputError(
                f"layer {said(name)} has the shape {array.shape}; allowed: "
                f"[{rows}, {columns}, channel], as linear"
            )
        made[name] = array
    return made


def texts_of(recipe: Mapping[str, str] | None) -> Mapping[str, str]:
    """Texts by keyword, or one clear message."""
    if recipe is None:
        return {}
    if not isinstance(recipe, Mapping):
        raise InputError(f"recipe is {said(recipe)}; allowed: texts by keyword")
    for keyword, text in recipe.items():
        if not isinstance(keyword, str) or not isinstance(text, str):
            raise InputError(f"recipe has {said(text)} for {said(keyword)}; allowed: texts")
    return recipe


def _single(name: str, values: ArrayLike) -> NDArray[np.float32]:
    """Float32 numbers; those that are so already are not copied."""
    import numpy as np

    if isinstance(values, np.ndarray) and values.dtype == np.float32:
        return values
    return array_of(name, values).astype(np.float32)


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__
