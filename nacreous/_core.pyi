"""The compiled rooms, as mypy sees them; `just check` compares this file with the built module."""

# file
from os import PathLike

import numpy as np
from numpy.typing import NDArray

def write_png(
    path: str | PathLike[str],
    pixels: NDArray[np.uint8] | NDArray[np.uint16],
    space: str,
    text: list[tuple[str, str]],
) -> None: ...
def write_exr(
    path: str | PathLike[str],
    planes: list[tuple[str, NDArray[np.float32]]],
    text: list[tuple[str, str]],
) -> None: ...
def read_photograph(path: str | PathLike[str]) -> NDArray[np.float32]: ...
def read_panorama(path: str | PathLike[str]) -> NDArray[np.float32]: ...
def read_png_text(path: str | PathLike[str]) -> list[tuple[str, str]]: ...
