"""Alpha: a picture's pearls without what is around them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from nacreous import _core
from nacreous.problem import InputError

__all__ = ["codes_with_alpha", "opaque", "pearls_alone"]

#: What pearls send to the camera.
_LIGHT = ("interference", "diffuse", "mirror")


def opaque(linear: NDArray[np.float32]) -> NDArray[np.float32]:
    """Linear light [row, column, rgb] as [row, column, rgba], without holes.

    >>> opaque(np.full((1, 1, 3), 0.5, np.float32)).tolist()
    [[[0.5, 0.5, 0.5, 1.0]]]
    """
    return np.concatenate([linear, np.ones_like(linear[..., :1])], axis=-1)


def pearls_alone(layers: Mapping[str, NDArray[np.float32]]) -> NDArray[np.float32]:
    """The pearls' light [row, column, rgba], multiplied by alpha: the share that pearls cover.

    What lens and eye spread beyond the pearls stays, as light over an alpha of 0. Raises
    `InputError` for a picture without the layers of a rendered one.

    >>> ones = np.ones((1, 1, 3), np.float32)
    >>> parts = dict.fromkeys(["interference", "diffuse", "mirror"], 0.1 * ones)
    >>> pearls_alone({**parts, "coverage": 0.5 * ones[..., :1]}).round(3).tolist()[0][0]
    [0.30000001192092896, 0.30000001192092896, 0.30000001192092896, 0.5]
    """
    missing = [name for name in (*_LIGHT, "coverage") if name not in layers]
    if missing:
        raise InputError(
            f"the picture has no layer {missing[0]}; allowed with alpha: a rendered picture"
        )
    light = layers[_LIGHT[0]] + layers[_LIGHT[1]] + layers[_LIGHT[2]]
    return np.concatenate([light, np.clip(layers["coverage"], 0, 1)], axis=-1)


def codes_with_alpha(
    rgba: NDArray[np.float32], bits: Literal[8, 16], space: str, gamut: str
) -> tuple[NDArray[np.uint8] | NDArray[np.uint16], float]:
    """Codes [row, column, rgba] of light that is multiplied by alpha, and the share out of gamut.

    Their colours are not multiplied by alpha, as PNG wants it. The share is of all pixels.

    >>> half = np.array([[[0.5, 0.5, 0.5, 0.5], [0.0, 0.0, 0.0, 0.0]]], np.float32)
    >>> codes_with_alpha(half, 8, "srgb", "clip")[0].tolist()
    [[[255, 255, 255, 128], [0, 0, 0, 0]]]
    """
    alpha = rgba[..., 3:]
    colours = np.divide(rgba[..., :3], alpha, out=np.zeros_like(rgba[..., :3]), where=alpha > 0)
    codes, outside = _core.develop(colours, space, gamut, bits)
    opacity = np.rint(alpha * np.float32(2**bits - 1)).astype(codes.dtype)
    return np.concatenate([codes, opacity], axis=-1), outside
