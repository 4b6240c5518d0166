"""The picture of a pearl: a pearl and a scene in, linear light in named parts out."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from numbers import Integral
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias, TypeVar

from nacreous import _core, file
from nacreous.number import said
from nacreous.problem import InputError
from nacreous.recipe import PREFIX, SUFFIXES, Bits, recipe_texts
from nacreous.rows import Filled, fill
from nacreous.spec import Pearl, Scene
from nacreous.spec.row import MOST_PEARLS

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from nacreous.texture import Grain

__all__ = ["SUFFIXES", "Image", "field_mm", "recipe_json", "render"]

Spec = TypeVar("Spec", Pearl, Scene)
Given: TypeAlias = str | Path | Pearl


class Image:
    """A picture in linear light, and the recipe that it can be made from again.

    linear: float32 [row, column, rgb] in the primaries of sRGB, relative to the scene's white; may
    leave 0..1. layers: of a rendered picture, the parts "interference", "diffuse", "mirror" and
    "surroundings", which add up to linear, and "texture" (hue, value, chroma), "coverage" (of all
    pearls) and "shadow" (the share of its light that the table lacks for the pearls). recipe: texts
    "pearl" (of several different pearls "pearl.0", "pearl.1" and so on), "scene" and others.
    """

    def __init__(
        self,
        linear: NDArray[np.float32],
        layers: Mapping[str, NDArray[np.float32]],
        recipe: Mapping[str, str] | None = None,
    ) -> None:
        self._arrays: _Arrays | None = (linear, layers)
        self._picture: _core.Picture | None = None
        self.recipe: Mapping[str, str] = recipe or {}

    @classmethod
    def _rendered(cls, picture: _core.Picture, recipe: Mapping[str, str]) -> Image:
        """A picture whose arrays, and NumPy with them, are loaded when they are first asked for."""
        image = cls.__new__(cls)
        image._arrays, image._picture, image.recipe = None, picture, recipe
        return image

    def __repr__(self) -> str:
        """Its size and what is in it, on one line."""
        height, width = self.linear.shape[:2]
        return f"Image({width} x {height} pixels, layers: {', '.join(self.layers) or 'none'})"

    def _repr_png_(self) -> bytes:
        """The picture as notebooks show it, in sRGB."""
        return _core.png_bytes(self.develop()[0], "srgb", self._texts())

    def __reduce__(self) -> tuple[type[Image], tuple[object, ...]]:
        """By its arrays, so that it goes from process to process."""
        return type(self), (self.linear, dict(self.layers), dict(self.recipe))

    @property
    def linear(self) -> NDArray[np.float32]:
        """The picture's light."""
        return self._loaded()[0]

    @property
    def layers(self) -> Mapping[str, NDArray[np.float32]]:
        """The parts of that light, and what they were made with."""
        return self._loaded()[1]

    def _loaded(self) -> _Arrays:
        if self._arrays is None:
            if self._picture is None:
                raise TypeError("an image has neither arrays nor a picture")
            pixels, parts = self._picture.parts()
            layers = {name: pixels[..., first:end] for name, first, end in parts}
            first_four = list(layers.values())[:4]
            self._arrays = sum(first_four[1:], first_four[0]), layers
        return self._arrays

    def develop(
        self,
        bits: Bits = 8,
        space: str = "srgb",
        gamut: str = "soft",
        alpha: bool = False,
    ) -> tuple[NDArray[np.uint8] | NDArray[np.uint16], float]:
        """Codes [row, column, rgb] for a screen, and the share of pixels that were out of gamut.

        space: "srgb" or "display-p3". gamut: "soft" keeps hue and bends saturation and highlights,
        "clip" cuts each channel (formulas: `nacreous.colour`). alpha: the pearls alone, as codes
        [row, column, rgba], colours not multiplied by how much of the pixel the pearls cover.

        >>> codes, outside = render("paper", size=8, samples=1).develop(alpha=True)
        >>> codes.dtype, codes.shape
        (dtype('uint8'), (8, 8, 4))
        """
        _check_bits(bits)
        if not alpha:
            return _core.develop(self.linear, str(space), str(gamut), bits)
        from nacreous.alpha import codes_with_alpha, pearls_alone

        return codes_with_alpha(pearls_alone(self.layers), bits, str(space), str(gamut))

    def save(
        self,
        path: str | Path,
        bits: Bits = 8,
        space: str = "srgb",
        gamut: str = "soft",
        alpha: bool = False,
    ) -> float:
        """Write the picture; the ending decides. Returns the share of pixels out of gamut.

        .png: developed, with its colour profile. .exr: linear, with all layers; nothing is clipped
        and the share is 0. Both carry the recipe: pearl, scene, seed, size and versions. alpha: the
        pearls alone, cut out (docs/picture.md); without it a PNG has no alpha and an EXR's is 1.
        The file is whole or not there. Raises `InputError` for an ending or a place that cannot be.
        """
        suffix = file.check_output(path, SUFFIXES).suffix.lower()
        _check_bits(bits)
        outside = 0.0
        with file.atomic(path) as temporary:
            if self._picture is None or self._arrays is not None or alpha:
                outside = self._save_arrays(
                    temporary, suffix, (bits, str(space), str(gamut), alpha)
                )
            elif suffix == ".exr":
                self._picture.save_exr(temporary, self._texts())
            else:
                texts = self._texts(bits, space, gamut, alpha)
                outside = self._picture.save_png(temporary, str(space), str(gamut), bits, texts)
        return outside

    def _save_arrays(self, path: Path, suffix: str, how: tuple[Bits, str, str, bool]) -> float:
        """Write the arrays, which may have been changed since they were rendered."""
        if suffix == ".exr":
            from nacreous.alpha import opaque, pearls_alone

            rgba = pearls_alone(self.layers) if how[3] else opaque(self.linear)
            _core.write_exr(path, [("", rgba), *self.layers.items()], self._texts())
            return 0.0
        codes, outside = self.develop(*how)
        _core.write_png(path, codes, how[1], self._texts(*how))
        return outside

    def _texts(self, *how: object) -> list[tuple[str, str]]:
        """The recipe, and of a PNG how it was developed."""
        texts = dict(self.recipe)
        if how and texts:
            names = ("bits", "space", "gamut", "alpha")
            texts["developed"] = json.dumps(dict(zip(names, how, strict=True)))
        return [(PREFIX + name, text) for name, text in texts.items()]


def render(
    pearl: Given | Sequence[Given] = "paper",
    scene: str | Path | Scene = "paper",
    size: int = 512,
    samples: int = 16,
    progress: Callable[[float], None] | None = None,
) -> Image:
    """Render a pearl, or several, in a scene (paper, section 4).

    pearl, scene: models, files, or presets' names. Of several pearls each takes the next "*" in the
    scene's rows, in turn. size: pixels a side, 1 to 8192. samples: the most a pixel takes, a square
    number, 1 to 1024; where the first are alike, it takes fewer. progress: called with the finished
    share, 0 to 1, now and then; what it raises stops the render, as Ctrl-C does.

    Same pearl, scene, size and samples: same bytes. Memory: 76 bytes a pixel, some 60 MB, and up to
    25 MB for each different grain (24 different pearls in 1024 x 1024: 460 MB).

    >>> image = render("paper", size=16, samples=4)
    >>> parts = ("interference", "diffuse", "mirror", "surroundings")
    >>> bool(abs(sum(image.layers[part] for part in parts) - image.linear).max() < 1e-6)
    True
    """
    filled = fill(_given(pearl), _loaded(Scene, scene))
    size, samples = _whole("size", size), _whole("samples", samples)
    report = None if progress is None else lambda rows: progress(rows / size)
    recipe = _json(filled, size, samples)
    spectra, panoramas, photographed = _core.files_needed(recipe)
    picture = _core.render(
        recipe,
        _spectra(spectra),
        [(path, file.read_panorama(path)) for path in panoramas],
        _measured_grains({number: filled.pearls[number] for number in photographed}),
        report,
    )
    return Image._rendered(picture, recipe_texts(filled, size, samples))


def recipe_json(
    pearl: Given | Sequence[Given] = "paper",
    scene: str | Path | Scene = "paper",
    size: int = 512,
    samples: int = 16,
) -> str:
    """Everything that makes a picture, complete, as the JSON that every renderer of ours takes.

    Arguments as for `render`. Each key of the pearls and of the scene stands in it, with null where
    it is left out and the renderer finds its value; rows name pearls by number. Contents of files
    (measured lights, panoramas, photographs) are handed over beside it.

    >>> import json
    >>> sorted(json.loads(recipe_json("akoya-rg", "booth", size=64)))
    ['pearls', 'samples', 'scene', 'size']
    """
    filled = fill(_given(pearl), _loaded(Scene, scene))
    return _json(filled, _whole("size", size), _whole("samples", samples))


def field_mm(
    pearl: Given | Sequence[Given] = "paper", scene: str | Path | Scene = "paper"
) -> float:
    """Width of the view at the scene's origin in mm: camera.field_mm, or one that shows all pearls.

    Arguments, and `InputError`, as for `render`.

    >>> field_mm("paper", "paper")
    12.0
    """
    return _core.field_mm(recipe_json(pearl, scene, 1, 1))


def _json(filled: Filled, size: int, samples: int) -> str:
    pearls = ", ".join(pearl.model_dump_json() for pearl in filled.pearls)
    scene = filled.scene.model_dump_json()
    return f'{{"pearls": [{pearls}], "scene": {scene}, "size": {size}, "samples": {samples}}}'


def _given(pearl: Given | Sequence[Given]) -> list[Pearl]:
    if isinstance(pearl, str | Path | Pearl) or not isinstance(pearl, Sequence):
        return [_loaded(Pearl, pearl)]
    if not 1 <= len(pearl) <= MOST_PEARLS:
        raise InputError(f"pearl is a list of {len(pearl)}; allowed: 1 to {MOST_PEARLS} pearls")
    return [_loaded(Pearl, one) for one in pearl]


def _loaded(model: type[Spec], given: str | Path | Spec) -> Spec:
    if isinstance(given, model):
        return given
    if isinstance(given, str | Path):
        return model.load(given)
    kind = model.preset_kind
    raise InputError(f"{kind} is {said(given)}; allowed: a {kind}, a file or a preset's name")


def _whole(name: str, value: int) -> int:
    """A whole number within its range; that samples is a square is for the renderer to see."""
    most, allowed = _COUNTS[name]
    if isinstance(value, Integral) and not isinstance(value, bool) and 1 <= value <= most:
        return int(value)
    raise InputError(f"{name} is {said(value)}; allowed: {allowed}")


_COUNTS = {
    "size": (_core.MAX_SIZE_PX, f"a whole number from 1 to {_core.MAX_SIZE_PX}"),
    "samples": (_core.MAX_SAMPLES, f"a square number from 1 to {_core.MAX_SAMPLES}, such as 16"),
}


def _spectra(names: list[str]) -> list[tuple[str, list[float]]]:
    """The measured lights in files."""
    if not names:
        return []
    from nacreous.colour import spectrum_from_csv

    return [(name, spectrum_from_csv(name).tolist()) for name in names]


def _measured_grains(photographed: Mapping[int, Pearl]) -> list[tuple[int, Grain]]:
    """The grain on the photograph of each pearl, by its number."""
    if not photographed:
        return []
    from nacreous.texture import measured_grain

    return [(number, measured_grain(pearl)) for number, pearl in photographed.items()]


def _check_bits(bits: int) -> None:
    if bits not in (8, 16):
        raise InputError(f"bits is {said(bits)}; allowed: 8, 16")


if TYPE_CHECKING:
    _Arrays: TypeAlias = tuple[NDArray[np.float32], Mapping[str, NDArray[np.float32]]]
