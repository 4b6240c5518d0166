"""How far a picture is from the mean of one four times as fine, without grain.

    python -m tests.picture.finer akoya-rg paper 64 shininess=1

prints the largest difference of a pixel of the pearl, in shares of white.
"""

from __future__ import annotations

import sys

import numpy as np
from numpy.typing import NDArray

import nacreous as nc
from nacreous.spec import Pearl, Scene

Array = NDArray[np.float64]
FINER = 4


def weights() -> Array:
    """Of fine pixels under a coarse one: the least squares of its tent by a sum of theirs."""
    middle = (np.arange(2 * FINER) + 0.5) / FINER - 1.0
    x = np.linspace(-1.5, 1.5, 3001)
    fine = np.maximum(0.0, 1.0 - np.abs(x[:, np.newaxis] - middle) * FINER)
    coarse = np.maximum(0.0, 1.0 - np.abs(x))
    found: Array = np.linalg.lstsq(fine, coarse, rcond=None)[0]
    total: float = found.sum()
    return np.asarray(found / total, float)


def filtered(fine: Array) -> Array:
    """A picture FINER times as fine, under the filter of a coarse one."""
    for _ in range(2):
        rows = np.pad(fine, [(FINER // 2, FINER // 2), (0, 0), (0, 0)], mode="edge")
        taps = (weight * rows[i:][: fine.shape[0] : FINER] for i, weight in enumerate(weights()))
        fine = np.swapaxes(np.sum(list(taps), axis=0), 0, 1)
    return fine


def pair(pearl: Pearl, scene: Scene, size: int) -> tuple[nc.Image, Array]:
    """A picture, and the mean of a finer one in its pixels."""
    coarse, fine = (nc.render(pearl, scene, each) for each in (size, FINER * size))
    return coarse, filtered(fine.linear.astype(float))


def differences(coarse: nc.Image, mean: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Of each pixel but the outermost, of white; and whether a pearl is in it."""
    inner = np.s_[1:-1, 1:-1]
    seen = np.abs(np.clip(coarse.linear, 0, 1) - np.clip(mean, 0, 1))[inner].max(axis=2)
    return seen, coarse.layers["coverage"][..., 0][inner] > 0


def main(name: str, scene: str, size: str, *changes: str) -> None:
    """Print the largest difference."""
    keys = [(key, value) for key, _, value in (change.partition("=") for change in changes)]
    seen, pearl_there = differences(
        *pair(Pearl.load(name, [("grain", "0"), *keys]), Scene.load(scene), int(size))
    )
    print(f"{seen[pearl_there].max():.3f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
