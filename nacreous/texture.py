"""The grain of a pearl (kime-kan): from a photograph to a texture over the whole sphere.

Section 4.3 of the paper: patches of 64 x 64 pixels, Munsell hue, value and chroma, Hanning window,
Fourier transform, band-pass, inverse transform. `analyse` has that done (`crates/image/src/grain/`)
and keeps the power at each spatial frequency; `synthesise` draws from it a texture that covers a
pearl without seam or pole.

>>> texture = synthesise(GrainSpectrum.procedural(), radius_mm=4.0, seed=7)
>>> texture.at(np.array([[0.0, 0.0, 1.0]]), 0.0).shape  # towards +z: hue, value, chroma
(1, 3)
"""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING, Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core
from nacreous._core import analysed_grain, limited_grain, procedural_grain
from nacreous.deprecation import keep_former_names
from nacreous.file import read_photograph
from nacreous.number import whole_of
from nacreous.problem import InputError
from nacreous.unchanging import Unchanging, keep, key_of, ordered
from nacreous.value import value_class

if TYPE_CHECKING:
    from nacreous.spec import Pearl

__all__ = ["Analysis", "GrainSpectrum", "Texture", "analyse", "synthesise", "texture_of"]

Array = NDArray[np.float64]
Corner: TypeAlias = tuple[int, int]
#: Frequencies, density and correlation of a spectrum.
Grain: TypeAlias = tuple[Array, Array, Array]


@value_class
class GrainSpectrum:
    """How strongly hue, value and chroma vary over a pearl, and how finely.

    Hue deviates in radians (weighted by chroma), value and chroma relative to their mean; all
    means are 0. `density` is the power on the circle of one spatial frequency f, which is
    S(f) = 2 pi f P(f) of the two-dimensional P. It is linear between the frequencies given and 0
    outside; its integral is the channel's variance. What belongs together in hue, value and chroma
    is kept as one correlation for all frequencies **(ours)**.
    """

    cycles_per_mm: Array
    """Spatial frequencies [k], increasing, 2 to 4096 of them."""
    density: Array
    """Variance per cycle per millimetre [channel, k]; channels: hue, value, chroma."""
    correlation: Array = field(default_factory=lambda: np.eye(3))
    """Correlation matrix [channel, channel]."""
    source: str = "given"
    """Where it comes from, for captions: `photograph`, `procedural` ..."""

    def __post_init__(self) -> None:
        """Arrays of float64, as the renderer takes them."""
        names = ("cycles_per_mm", "density", "correlation")
        keep(self, **{name: np.ascontiguousarray(getattr(self, name), float) for name in names})

    @classmethod
    def procedural(cls) -> Self:
        """A stand-in for pearls without a photograph. Chosen by eye, **not measured**.

        >>> grain = GrainSpectrum.procedural()
        >>> grain.source, (grain.variance**0.5).round(2).tolist()
        ('procedural', [0.06, 0.1, 0.12])
        """
        return cls(*procedural_grain(), source="procedural")

    def limited(self, low_per_mm: float, high_per_mm: float) -> Self:
        """The part of the spectrum between two frequencies, as an ideal band-pass leaves it.

        >>> grain = GrainSpectrum([1, 2, 3], np.ones((3, 3))).limited(1.5, 2.5)
        >>> grain.variance.tolist()
        [1.0, 1.0, 1.0]
        """
        limited = limited_grain(self.numbers, float(low_per_mm), float(high_per_mm))
        return type(self)(*limited, source=self.source)

    @property
    def numbers(self) -> Grain:
        """Frequencies, density and correlation, as the renderer takes them."""
        return self.cycles_per_mm, self.density, self.correlation

    @property
    def variance(self) -> Array:
        """Variance [channel] of hue (rad^2), value and chroma (relative)."""
        return np.asarray(np.trapezoid(self.density, self.cycles_per_mm, axis=1))


class Texture(Unchanging):
    """Hue, value and chroma over a sphere, without seam or pole, as `synthesise` makes it.

    It never changes; it compares and hashes as its numbers, and copies and pickles as what it was
    made from, which gives the same bytes.

    >>> texture = synthesise(GrainSpectrum([1, 2, 3], np.ones((3, 3))), radius_mm=4.0)
    >>> texture.grid().shape[2]
    3
    """

    __slots__ = ("_compiled", "_made_from")

    _compiled: _core.Texture
    _made_from: tuple[str, tuple[object, ...]]

    @classmethod
    def _made(cls, maker: str, *arguments: object) -> Self:
        texture = cls.__new__(cls)
        compiled = getattr(_core, maker)(*arguments)
        keep(texture, _compiled=compiled, _made_from=(maker, arguments))
        return texture

    def __repr__(self) -> str:
        """How fine it is."""
        return f"Texture(band_limit={self.band_limit})"

    def __reduce__(self) -> tuple[object, tuple[object, ...]]:
        """By what it was made from."""
        maker, arguments = self._made_from
        return type(self)._made, (maker, *arguments)

    def __eq__(self, other: object) -> bool:
        """Same numbers everywhere."""
        return self._key() == other._key() if isinstance(other, Texture) else NotImplemented

    def __hash__(self) -> int:
        """Equal textures have equal hashes."""
        return hash(self._key())

    def __dask_tokenize__(self) -> object:
        """What Dask knows equal textures by."""
        return type(self).__qualname__, ordered(self._key())

    def _key(self) -> object:
        return key_of((self.band_limit, self.lost_variance, self.grid()))

    @property
    def band_limit(self) -> int:
        """The highest degree of its spherical harmonics."""
        return self._compiled.band_limit

    @property
    def lost_variance(self) -> list[float]:
        """Variance of hue, value and chroma that the spectrum has and the texture has not."""
        return self._compiled.lost_variance

    def at(self, directions: NDArray[np.float64], footprint_rad: float) -> NDArray[np.float32]:
        """Float32 [n, channel] towards float64 [n, xyz], for samples so far apart, an angle."""
        return self._compiled.at(directions, footprint_rad)

    def grid(self) -> NDArray[np.float32]:
        """The finest grid [row, column, channel], from pole to pole and once round."""
        return self._compiled.grid()


@value_class
class Analysis:
    """What `analyse` finds in a photograph."""

    spectrum: GrainSpectrum
    """Mean over the patches, ready for `synthesise`."""
    textures: Array
    """The paper's texture images [patch, row, column, channel] (figure 13), fading at the edges."""
    corners: tuple[Corner, ...]
    """(row, column) of each patch's first pixel."""


def analyse(
    photograph: ArrayLike,
    mm_per_pixel: float | None = None,
    side_px: int = 64,
    corners: list[Corner] | None = None,
    low: float | None = None,
    high: float | None = None,
) -> Analysis:
    """Textures of hue, value and chroma in a photograph's patches, and their spectrum (paper 4.3).

    `photograph` is linear RGB, 0..1, [row, column, 3]; `corners` are the patches' first pixels
    (row, column), found in the pearl if not given. `low` and `high` limit the band in cycles per
    mm; left out, they are 2 cycles per patch, under which lies the pearl's shading, and three
    quarters of the highest frequency the pixels carry, above which lies the camera's noise
    **(ours)**. Without `mm_per_pixel` the limits are cycles per patch, and a patch counts as 1 mm
    **(ours)**: about right for a pearl of 8 mm, 512 pixels wide. The spectrum's `source` says so.

    Raises `InputError` for a picture that is not RGB, not finite or smaller than a patch, patches
    under 8 or over 1024 pixels, outside the picture or not of relative light (10 and more), limits
    other than 0 <= low < high <= half a cycle per pixel, and what no `GrainSpectrum` may be drawn
    of: over 10,000 cycles per mm.

    >>> step = np.arange(64) / 64
    >>> grating = 0.5 + 0.05 * np.cos(2 * np.pi * 8 * step)  # 8 cycles in 64 pixels of 0.02 mm
    >>> photograph = np.tile(grating[None, :, None] * [0.9, 0.8, 0.75], (64, 1, 1))
    >>> grain = analyse(photograph, mm_per_pixel=0.02).spectrum
    >>> float(grain.cycles_per_mm[grain.density[1].argmax()])
    6.25
    """
    how = whole_of("texture: side_px", side_px, 8, 1024), mm_per_pixel, low, high
    given = None if corners is None else [(_place(row), _place(column)) for row, column in corners]
    grain, textures, found = analysed_grain(_light(photograph), how, given)
    source = "photograph" if mm_per_pixel is not None else "photograph, patch taken as 1 mm"
    return Analysis(GrainSpectrum(*grain, source=source), textures, tuple(found))


def synthesise(
    spectrum: GrainSpectrum, radius_mm: float, seed: int = 0, footprint_rad: float = 0.0
) -> Texture:
    """A seamless texture for a pearl of `radius_mm` (0.1 to 100). Same seed, same bytes.

    An isotropic Gaussian random field: degree l of its spherical harmonics has the power at
    l + 1/2 = 2 pi f R, up to degree 512, and `texture.lost_variance` says what lies outside.
    `texture.at(directions, footprint_rad)` gives float32 [n, channel] towards float64 [n, xyz] for
    samples so far apart on the surface, as an angle at the pearl's centre. footprint_rad: the least
    distance that will be asked for; what only finer samples could show is left out, and memory with
    it (all detail takes about 30 MB).

    Raises `InputError` for a spectrum that is none, a radius out of range, or a seed not in
    0..2^64 - 1.

    >>> texture = synthesise(GrainSpectrum([1, 2, 3], np.ones((3, 3))), radius_mm=4.0)
    >>> texture.band_limit
    75
    """
    seed = whole_of("texture: seed", seed, 0, 2**64 - 1)
    if spectrum.cycles_per_mm.ndim != 1 or spectrum.density.ndim != 2:
        shapes = spectrum.cycles_per_mm.shape, spectrum.density.shape
        raise InputError(f"grain spectrum: shapes are {shapes}; allowed: (k,) and (3, k)")
    return Texture._made("synthesise_texture", spectrum.numbers, radius_mm, seed, footprint_rad)


def texture_of(pearl: Pearl, footprint_rad: float = 0.0) -> Texture:
    """The texture that a pearl file asks for: of its photograph, or of the procedural stand-in.

    footprint_rad: as for `synthesise`.

    >>> from nacreous.spec import Pearl
    >>> texture_of(Pearl(diameter_mm=2.0)).band_limit
    75
    """
    photographed = pearl.texture.source != "procedural"
    measured = measured_grain(pearl) if photographed else None
    return Texture._made("texture_of", pearl.model_dump_json(), measured, footprint_rad)


def measured_grain(pearl: Pearl) -> Grain:
    """The numbers of the grain on the photograph that a pearl file names."""
    wanted = pearl.texture
    how = wanted.side_px, wanted.mm_per_pixel, wanted.low_per_mm, wanted.high_per_mm
    return _core.measured_grain(read_photograph(wanted.source), how)


def _place(value: int) -> int:
    """A row or column of a corner; whether a patch lies there is told later."""
    return whole_of("texture: a corner's row or column", value, -(2**31), 2**31 - 1)


def _light(photograph: ArrayLike) -> Array:
    """Float64 [row, column, rgb], row by row."""
    picture = np.asarray(photograph)
    if picture.ndim != 3 or picture.shape[2] != 3 or picture.dtype.kind not in "fiu":
        raise InputError(
            f"texture: the photograph is {picture.dtype} {list(picture.shape)};"
            " allowed: numbers [row, column, 3]"
        )
    return np.require(picture, np.float64, ["C", "A"])


keep_former_names(__name__, {"of_pearl": "texture_of"})


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__
