"""The picture of a pearl: a pearl and a scene in, linear light in named parts out."""

from __future__ import annotations

import json
import platform
from collections.abc import Callable, Mapping, Sequence
from numbers import Integral
from pathlib import Path
from typing import TYPE_CHECKING, Literal, TypeAlias, TypeVar

from nacreous import _core, file
from nacreous.number import said
from nacreous.problem import InputError
from nacreous.rows import Filled, fill
from nacreous.spec import Growth, Pearl, Scene
from nacreous.spec.row import MOST_PEARLS
from nacreous.value import Unchanging, keep, key_of, released

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from nacreous.texture import Grain

__all__ = ["SUFFIXES", "Image", "field_mm", "recipe_json", "render"]

#: The kinds of picture file that can be written.
SUFFIXES = (".png", ".exr")

Spec = TypeVar("Spec", Pearl, Scene)
Given: TypeAlias = str | Path | Pearl


class Image(Unchanging):
    """A picture in linear light, and the recipe that it can be made from again.

    linear: float32 [row, column, rgb] in the primaries of sRGB, relative to the scene's white; may
    leave 0..1. layers: of a rendered picture, the parts "interference", "diffuse", "mirror" and
    "surroundings", which add up to linear, and "texture" (hue, value, chroma) and "coverage" (of
    all pearls). recipe: texts "pearl" (of several different pearls "pearl.0", "pearl.1" and so on),
    "scene" and others. A picture never changes; it compares, hashes, copies and pickles as its
    numbers and its recipe.
    """

    _arrays: _Arrays | None
    _picture: _core.Picture | None
    recipe: Mapping[str, str]

    def __init__(
        self,
        linear: NDArray[np.float32],
        layers: Mapping[str, NDArray[np.float32]],
        recipe: Mapping[str, str] | None = None,
    ) -> None:
        keep(self, _arrays=(linear, layers), _picture=None, recipe=recipe or {})

    @classmethod
    def _rendered(cls, picture: _core.Picture, recipe: Mapping[str, str]) -> Image:
        """A picture whose arrays, and NumPy with them, are loaded when they are first asked for."""
        image = cls.__new__(cls)
        keep(image, _arrays=None, _picture=picture, recipe=recipe)
        return image

    def __repr__(self) -> str:
        """Its size and what is in it."""
        return f"Image(linear {self.linear.shape}, layers: {', '.join(self.layers) or 'none'})"

    def __reduce__(self) -> tuple[type[Image], tuple[object, ...]]:
        """By its arrays, so that it goes from process to process."""
        return type(self), (self.linear, dict(self.layers), dict(self.recipe))

    def __eq__(self, other: object) -> bool:
        """Same light, same parts, same recipe."""
        return self._key() == other._key() if isinstance(other, Image) else NotImplemented

    def __hash__(self) -> int:
        """Equal pictures have equal hashes."""
        return hash(self._key())

    def _key(self) -> object:
        return key_of((self.linear, self.layers, self.recipe))

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
            released(pixels)
            layers = {name: pixels[..., first:end] for name, first, end in parts}
            first_four = list(layers.values())[:4]
            linear = released(sum(first_four[1:], first_four[0]))
            keep(self, _arrays=(linear, layers))
            return linear, layers
        return self._arrays

    def develop(
        self,
        bits: Literal[8, 16] = 8,
        space: str = "srgb",
        gamut: str = "soft",
    ) -> tuple[NDArray[np.uint8] | NDArray[np.uint16], float]:
        """Codes [row, column, rgb] for a screen, and the share of pixels that were out of gamut.

        space: "srgb" or "display-p3". gamut: "soft" keeps hue and bends saturation and highlights,
        "clip" cuts each channel (formulas: `nacreous.colour`).

        >>> codes, outside = render("paper", size=8, samples=1).develop()
        >>> codes.dtype, codes.shape
        (dtype('uint8'), (8, 8, 3))
        """
        _check_bits(bits)
        return _core.develop(self.linear, str(space), str(gamut), bits)

    def save(
        self,
        path: str | Path,
        bits: Literal[8, 16] = 8,
        space: str = "srgb",
        gamut: str = "soft",
    ) -> float:
        """Write the picture; the ending decides. Returns the share of pixels out of gamut.

        .png: developed, with its colour profile. .exr: linear, with all layers; nothing is clipped
        and the share is 0. Both carry the recipe: pearl, scene, seed, size and versions. The file
        is whole or not there. Raises `InputError` for an ending or a place that cannot be.
        """
        suffix = file.check_output(path, SUFFIXES).suffix.lower()
        _check_bits(bits)
        outside = 0.0
        with file.atomic(path) as temporary:
            if self._picture is None or self._arrays is not None:
                outside = self._save_arrays(temporary, suffix, (bits, str(space), str(gamut)))
            elif suffix == ".exr":
                self._picture.save_exr(temporary, self._texts())
            else:
                texts = self._texts()
                outside = self._picture.save_png(temporary, str(space), str(gamut), bits, texts)
        return outside

    def _save_arrays(self, path: Path, suffix: str, how: tuple[Literal[8, 16], str, str]) -> float:
        """Write the arrays, which may have been changed since they were rendered."""
        if suffix == ".exr":
            _core.write_exr(path, [("", self.linear), *self.layers.items()], self._texts())
            return 0.0
        codes, outside = self.develop(*how)
        _core.write_png(path, codes, how[1], self._texts())
        return outside

    def _texts(self) -> list[tuple[str, str]]:
        return [(f"nacreous:{name}", text) for name, text in self.recipe.items()]


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
    return Image._rendered(picture, _recipe(filled, size, samples))


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
    11.5
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


def _recipe(filled: Filled, size: int, samples: int) -> dict[str, str]:
    """Everything that makes the picture again, as texts for its file."""
    from nacreous import __version__

    pearls = filled.pearls
    seeds = [p.nacre.seed if isinstance(p.nacre, Growth) else None for p in pearls]
    texture_seeds = [_core.texture_seed(p.model_dump_json()) for p in pearls]
    one = len(pearls) == 1
    settings = {
        "size": size,
        "samples": samples,
        "seed": seeds[0] if one else seeds,
        "texture_seed": texture_seeds[0] if one else texture_seeds,
    }
    return {
        **{"pearl" if one else f"pearl.{i}": p.to_toml() for i, p in enumerate(pearls)},
        "scene": filled.scene.to_toml(),
        "settings": json.dumps(settings),
        "versions": json.dumps({"nacreous": __version__, "python": platform.python_version()}),
    }


def _check_bits(bits: int) -> None:
    if bits not in (8, 16):
        raise InputError(f"bits is {said(bits)}; allowed: 8, 16")


if TYPE_CHECKING:
    _Arrays: TypeAlias = tuple[NDArray[np.float32], Mapping[str, NDArray[np.float32]]]
