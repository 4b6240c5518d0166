"""The compiled rooms, as mypy sees them; `just check` compares this file with the built module."""

from collections.abc import Callable
from os import PathLike
from typing import TypeAlias, final

import numpy as np
from numpy.typing import NDArray

# body
def pigments() -> list[str]: ...
def pigment_absorption(name: str) -> NDArray[np.float64]: ...
def kubelka_munk(
    scattering_per_mm: float,
    absorption_per_mm: NDArray[np.float64],
    thickness_mm: float,
    background: NDArray[np.float64],
) -> NDArray[np.float64]: ...
def smooth_reflectance(rgb: tuple[float, float, float]) -> NDArray[np.float64]: ...

# colour
def spectrum_wavelength_nm() -> NDArray[np.float64]: ...
def illuminant_spectrum(name: str) -> NDArray[np.float64]: ...
def spectrum_from_csv(text: str, place: str) -> NDArray[np.float64]: ...
def xyz_from_spectrum(
    spectra: NDArray[np.float64], illuminant: NDArray[np.float64], observer: str
) -> NDArray[np.float64]: ...
def lab_from_xyz(
    xyz: NDArray[np.float64], white_xyz: tuple[float, float, float]
) -> NDArray[np.float64]: ...
def xyz_from_lab(
    lab: NDArray[np.float64], white_xyz: tuple[float, float, float]
) -> NDArray[np.float64]: ...
def delta_e_2000(
    first: NDArray[np.float64], second: NDArray[np.float64]
) -> NDArray[np.float64]: ...
def rgb_from_xyz(xyz: NDArray[np.float64], space: str) -> NDArray[np.float64]: ...
def xyz_from_rgb(rgb: NDArray[np.float64], space: str) -> NDArray[np.float64]: ...
def encode_rgb(rgb: NDArray[np.float64]) -> NDArray[np.float64]: ...
def decode_rgb(encoded: NDArray[np.float64]) -> NDArray[np.float64]: ...
def adapt_xyz(
    xyz: NDArray[np.float64],
    from_white: tuple[float, float, float],
    to_white: tuple[float, float, float],
) -> NDArray[np.float64]: ...
def map_to_gamut(rgb: NDArray[np.float64], method: str, space: str) -> NDArray[np.float64]: ...
def out_of_gamut_share(rgb: NDArray[np.float64]) -> float: ...
def hvc_from_rgb(rgb: NDArray[np.float64]) -> NDArray[np.float64]: ...
def rgb_from_hvc(hvc: NDArray[np.float64]) -> NDArray[np.float64]: ...
def hvc_from_xyz(xyz: NDArray[np.float64]) -> NDArray[np.float64]: ...
def xyz_from_hvc(hvc: NDArray[np.float64]) -> NDArray[np.float64]: ...
def munsell_notation(hvc: NDArray[np.float64]) -> list[str]: ...

# file
def write_png(
    path: str | PathLike[str],
    pixels: NDArray[np.uint8] | NDArray[np.uint16],
    space: str,
    text: list[tuple[str, str]],
) -> None: ...
def png_bytes(
    pixels: NDArray[np.uint8] | NDArray[np.uint16], space: str, text: list[tuple[str, str]]
) -> bytes: ...
def write_exr(
    path: str | PathLike[str],
    planes: list[tuple[str, NDArray[np.float32]]],
    text: list[tuple[str, str]],
) -> None: ...
def read_photograph(path: str | PathLike[str]) -> NDArray[np.float32]: ...
def read_panorama(path: str | PathLike[str]) -> NDArray[np.float32]: ...
def read_png_text(path: str | PathLike[str]) -> list[tuple[str, str]]: ...
def read_exr_text(path: str | PathLike[str]) -> list[tuple[str, str]]: ...

# film
@final
class Film:
    def __new__(
        cls,
        media: list[tuple[str, _Medium]],
        medium: list[int],
        thickness_nm: list[float],
    ) -> Film: ...
    def amplitudes(
        self, angle_rad: NDArray[np.float64], wavelength_nm: NDArray[np.float64]
    ) -> tuple[NDArray[np.complex128], NDArray[np.float64]]: ...
    def on_plate(
        self,
        thickness_nm: float,
        behind: _Medium,
        angle_rad: NDArray[np.float64],
        wavelength_nm: NDArray[np.float64],
    ) -> NDArray[np.float64]: ...
    def depth(
        self,
        polarisation: str,
        depth_nm: NDArray[np.float64],
        angle_rad: NDArray[np.float64],
        wavelength_nm: NDArray[np.float64],
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]: ...

# measure
def measure(
    linear: NDArray[np.float32],
    white: tuple[float, float, float],
    circle: tuple[float, float, float] | None,
    mm_per_pixel: float | None,
    clipped_at: float | None,
    opacity: NDArray[np.float32] | None,
) -> str: ...

# nacre
_Medium: TypeAlias = (
    complex
    | tuple[complex, complex]
    | str
    | tuple[NDArray[np.float64], NDArray[np.complex128], NDArray[np.complex128]]
)

@final
class Stack:
    def __new__(
        cls,
        thickness_nm: NDArray[np.float64],
        protein_nm: float,
        aragonite: _Medium,
        protein: _Medium,
        ambient: _Medium,
        substrate: _Medium,
    ) -> Stack: ...
    def __len__(self) -> int: ...
    def thickness_nm(self) -> NDArray[np.float64]: ...
    def total_um(self) -> float: ...
    def outer(self, depth_um: float) -> tuple[int, float, float]: ...

def media() -> list[str]: ...

# optics
def energies(
    stack: Stack,
    angle_rad: NDArray[np.float64],
    wavelength_nm: NDArray[np.float64],
    polarisation: str,
    precision: str,
) -> NDArray[np.float64]: ...
def ensemble(
    stacks: list[Stack],
    angle_rad: NDArray[np.float64],
    wavelength_nm: NDArray[np.float64],
    polarisation: str,
    precision: str,
    columns: int,
    tables: NDArray[np.float64],
) -> NDArray[np.float64]: ...
def fresnel(
    n_i: complex, n_t: complex, angle_rad: NDArray[np.float64]
) -> tuple[list[NDArray[np.complex128]], list[NDArray[np.float64]]]: ...
def illuminant(
    stack: Stack,
    angle_rad: NDArray[np.float64],
    wavelength_nm: NDArray[np.float64],
    coherence_nm: float,
    threshold: float,
    diffuse_loss: float,
) -> NDArray[np.float64]: ...
def resonances(
    stack: Stack,
    angle_rad: NDArray[np.float64],
    wavelength_nm: NDArray[np.float64],
    polarisation: str,
) -> tuple[NDArray[np.uint64], NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]: ...

# iridescence
def iridescence(
    stack: Stack, illuminant: NDArray[np.float64], observer: str, polarisation: str
) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
def interference_iridescence(
    stack: Stack,
    illuminant: NDArray[np.float64],
    observer: str,
    coherence_nm: float,
    threshold: float,
    diffuse_loss: float,
) -> NDArray[np.float64]: ...

# image
MAX_SIZE_PX: int

def develop(
    linear: NDArray[np.float32], space: str, gamut: str, bits: int
) -> tuple[NDArray[np.uint8] | NDArray[np.uint16], float]: ...

# pearl, by its JSON
def stack_of_nacre(nacre: str) -> tuple[Stack, bool]: ...
def grow(growth: str) -> tuple[NDArray[np.uint32], NDArray[np.float64]]: ...
def film_columns(pearl: str, outer_um: float | None) -> list[NDArray[np.float64]]: ...
def body_reflectance(pearl: str, of_layers_mm: float) -> NDArray[np.float64]: ...
def resolved_keys(pearl: str) -> dict[str, float]: ...
def shape_dimensions(pearl: str) -> tuple[float, float, float, float, int]: ...
def texture_seed(pearl: str) -> int: ...

# render
MAX_SAMPLES: int
_Grain: TypeAlias = tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]

@final
class Picture:
    @property
    def size_px(self) -> int: ...
    def parts(self) -> tuple[NDArray[np.float32], list[tuple[str, int, int]]]: ...
    def save_png(
        self,
        path: str | PathLike[str],
        space: str,
        gamut: str,
        bits: int,
        text: list[tuple[str, str]],
    ) -> float: ...
    def save_exr(self, path: str | PathLike[str], text: list[tuple[str, str]]) -> None: ...

def field_mm(recipe: str) -> float: ...
def files_needed(recipe: str) -> tuple[list[str], list[str], list[int]]: ...
def render(
    recipe: str,
    spectra: list[tuple[str, list[float]]],
    panoramas: list[tuple[str, NDArray[np.float32]]],
    grains: list[tuple[int, _Grain]],
    report: Callable[[int], object] | None,
) -> Picture: ...

# scaling
@final
class PairModel:
    def __new__(
        cls,
        link: str,
        stimuli: int,
        left: NDArray[np.int64],
        right: NDArray[np.int64],
        answers: NDArray[np.float64],
        ties: bool,
        order: bool,
        prior: float | None,
        design: NDArray[np.float64] | None,
    ) -> PairModel: ...
    def __reduce__(self) -> tuple[type[PairModel], tuple[object, ...]]: ...
    def components(self) -> NDArray[np.uint32]: ...
    def existence(self) -> str: ...
    def fit(self) -> tuple[NDArray[np.float64], NDArray[np.float64], float, int]: ...
    def information(
        self, parameters: NDArray[np.float64], expected: bool
    ) -> NDArray[np.float64]: ...
    def log_likelihood(self, parameters: NDArray[np.float64]) -> float: ...
    def probabilities(self, lead: NDArray[np.float64], width: float) -> NDArray[np.float64]: ...
    def scores(
        self, answers: PersonalAnswers, parameters: NDArray[np.float64]
    ) -> NDArray[np.float64]: ...
    def bootstrap(
        self,
        parameters: NDArray[np.float64],
        answers: PersonalAnswers | None,
        samples: int,
        seed: int,
        studentised: bool,
        report: Callable[[int], object] | None,
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], int]: ...

@final
class PersonalAnswers:
    def __new__(
        cls,
        stimuli: int,
        left: NDArray[np.int64],
        right: NDArray[np.int64],
        outcome: NDArray[np.int8],
        person: NDArray[np.int64],
        people: int,
    ) -> PersonalAnswers: ...

def log_normal_cdf(x: NDArray[np.float64]) -> NDArray[np.float64]: ...
def spread_of_people(
    people: int,
    pair: NDArray[np.int64],
    end: NDArray[np.int64],
    person: NDArray[np.int64],
    value: NDArray[np.float64],
    metric: NDArray[np.float64],
    deals: int,
    seed: int,
    report: Callable[[int], object] | None,
) -> NDArray[np.float64]: ...

# texture
_Light: TypeAlias = NDArray[np.float32] | NDArray[np.float64]
_Measuring: TypeAlias = tuple[int, float | None, float | None, float | None]

@final
class Texture:
    @property
    def band_limit(self) -> int: ...
    @property
    def lost_variance(self) -> list[float]: ...
    def at(self, directions: NDArray[np.float64], footprint_rad: float) -> NDArray[np.float32]: ...
    def grid(self) -> NDArray[np.float32]: ...

def procedural_grain() -> _Grain: ...
def limited_grain(grain: _Grain, low_per_mm: float, high_per_mm: float) -> _Grain: ...
def measured_grain(light: _Light, how: _Measuring) -> _Grain: ...
def analysed_grain(
    light: _Light, how: _Measuring, corners: list[tuple[int, int]] | None
) -> tuple[_Grain, NDArray[np.float64], list[tuple[int, int]]]: ...
def synthesise_texture(
    grain: _Grain, radius_mm: float, seed: int, footprint_rad: float
) -> Texture: ...
def texture_of(pearl: str, measured: _Grain | None, footprint_rad: float) -> Texture: ...
def synthesise_harmonics(
    coefficients: NDArray[np.complex128], rows: int
) -> NDArray[np.float64]: ...
