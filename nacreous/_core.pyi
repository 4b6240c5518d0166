"""The compiled rooms, as mypy sees them; `just check` compares this file with the built module."""

# texture
from typing import final

import numpy as np
from numpy.typing import NDArray

@final
class Texture:
    @property
    def band_limit(self) -> int: ...
    @property
    def lost_variance(self) -> list[float]: ...
    def at(self, directions: NDArray[np.float64], footprint_rad: float) -> NDArray[np.float32]: ...
    def grid(self) -> NDArray[np.float32]: ...

def procedural_grain() -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]: ...
def synthesise_texture(
    cycles_per_mm: NDArray[np.float64],
    density: NDArray[np.float64],
    correlation: NDArray[np.float64],
    radius_mm: float,
    seed: int,
) -> Texture: ...
def synthesise_harmonics(
    coefficients: NDArray[np.complex128], rows: int
) -> NDArray[np.float64]: ...
