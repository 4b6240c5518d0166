"""The picture of a pearl: a pearl and a scene in, linear light in named parts out."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO, Literal, TypeAlias

from nacreous import _core, file
from nacreous.development import check_bits, check_unchanged, check_words
from nacreous.linear_light import layers_of, linear_of, texts_of
from nacreous.named_files import files_needed, hold_files, moved, relative_to
from nacreous.number import truth_of
from nacreous.recipe import PREFIX, Recipe, recipe
from nacreous.unchanging import Unchanging, keep, key_of, ordered, released

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, DTypeLike, NDArray

    from nacreous.recipe import Given
    from nacreous.spec import Scene
    from nacreous.texture import Grain

__all__ = ["SUFFIXES", "Image", "field_mm", "recipe_json", "render", "render_recipe"]

#: The kinds of picture file that can be written.
SUFFIXES = (".png", ".exr")


class Image(Unchanging):
    """A picture in linear light, and the recipe that it can be made from again.

    linear: float32 [row, column, rgb] in the primaries of sRGB, relative to the scene's white; may
    leave 0..1. layers: of a rendered picture, the parts "interference", "diffuse", "mirror" and
    "surroundings", which add up to linear, and "texture" (hue, value, chroma), "coverage" (of all
    pearls) and "shadow" (the share of its light that the table lacks for the pearls). recipe: texts
    "pearl" (of several different pearls "pearl.0", "pearl.1" and so on), "scene" and others. A
    picture never changes; it compares, hashes, copies and pickles as its
    numbers and its recipe. Made by hand, numbers become float32; `InputError` for what are none,
    and for other shapes.
    """

    _arrays: _Arrays | None
    _picture: _core.Picture | None
    recipe: Mapping[str, str]

    def __init__(
        self,
        linear: ArrayLike,
        layers: Mapping[str, ArrayLike],
        recipe: Mapping[str, str] | None = None,
    ) -> None:
        light = linear_of(linear)
        arrays = (light, layers_of(layers, light))
        keep(self, _arrays=arrays, _picture=None, recipe=texts_of(recipe))

    @classmethod
    def _rendered(cls, picture: _core.Picture, recipe: Mapping[str, str]) -> Image:
        """A picture whose arrays, and NumPy with them, are loaded when they are first asked for."""
        image = cls.__new__(cls)
        keep(image, _arrays=None, _picture=picture, recipe=recipe)
        return image

    def __repr__(self) -> str:
        """Its size and whose picture it is, on one line."""
        from nacreous import toml_text

        height, width = self.linear.shape[:2]
        texts = [text for key, text in self.recipe.items() if key.split(".")[0] == "pearl"]
        of = toml_text.loads(texts[0]).get("name") if len(texts) == 1 else f"{len(texts)} pearls"
        return f"Image({width} x {height}{f', {of}' if texts else ''})"

    def __array__(
        self, dtype: DTypeLike | None = None, copy: bool | None = None
    ) -> NDArray[np.float32]:
        """The picture's light, `linear`, where NumPy wants an array."""
        import numpy as np

        return np.array(self.linear, dtype, copy=copy)

    def _repr_png_(self) -> bytes:
        """The picture as notebooks show it, in sRGB."""
        return self._png((8, "srgb", "soft", False))[0]

    def __reduce__(self) -> tuple[type[Image], tuple[object, ...]]:
        """By its arrays, for other processes; each in the order of its pixels."""
        import numpy as np

        layers = {name: np.ascontiguousarray(layer) for name, layer in self.layers.items()}
        return type(self), (np.ascontiguousarray(self.linear), layers, dict(self.recipe))

    def __eq__(self, other: object) -> bool:
        """Same light, same parts, same recipe."""
        return self._key() == other._key() if isinstance(other, Image) else NotImplemented

    def __hash__(self) -> int:
        """Equal pictures have equal hashes."""
        return hash(self._key())

    def __dask_tokenize__(self) -> object:
        """What Dask knows equal pictures by."""
        return type(self).__qualname__, ordered(self._key())

    def _key(self) -> object:
        return key_of((self.linear, self.layers, self.recipe))

    @property
    def linear(self) -> NDArray[np.float32]:
        """The picture's light."""
        return self._loaded()[0].view()

    @property
    def layers(self) -> Mapping[str, NDArray[np.float32]]:
        """The parts of that light, and what they were made with."""
        return self._loaded()[1]

    def _loaded(self) -> _Arrays:
        if self._arrays is not None:
            return self._arrays
        if self._picture is None:
            raise TypeError("an image has neither arrays nor a picture")
        pixels, parts = self._picture.parts()
        pixels = released(pixels)
        layers = {name: pixels[..., first:end] for name, first, end in parts}
        first_four = list(layers.values())[:4]
        linear = released(sum(first_four[1:], first_four[0]))
        keep(self, _arrays=(linear, layers))
        return self._loaded()

    def develop(
        self,
        bits: Literal[8, 16] = 8,
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
        bits = check_bits(bits)
        if not truth_of("alpha", alpha):
            return _core.develop(self.linear, str(space), str(gamut), bits)
        from nacreous.alpha import codes_with_alpha, pearls_alone

        return codes_with_alpha(pearls_alone(self.layers), bits, str(space), str(gamut))

    def save(
        self,
        path: str | Path | BinaryIO,
        bits: Literal[8, 16] = 8,
        space: str = "srgb",
        gamut: str = "soft",
        alpha: bool = False,
    ) -> float:
        """Write the picture; the ending decides. Returns the share of pixels out of gamut.

        Into an open binary file, such as an `io.BytesIO`, goes a PNG, whose recipe names files by
        their absolute paths.

        .png: developed, with its colour profile. .exr: linear, with all layers; nothing is clipped
        and the share is 0. Both carry the recipe: pearl, scene, seed, size and versions. alpha: the
        pearls alone, cut out (docs/picture.md); without it a PNG has no alpha and an EXR's is 1.
        The file is whole or not there. Raises `InputError` for an ending or a place that cannot be.
        """
        alpha = truth_of("alpha", alpha)
        if hasattr(path, "write"):
            made, outside = self._png((bits, str(space), str(gamut), alpha))
            path.write(made)
            return outside
        place = file.check_output(file.named(path), SUFFIXES)
        suffix = place.suffix.lower()
        bits = check_bits(bits)
        check_words(str(space), str(gamut))
        how: dict[str, object] = {"bits": bits, "space": space, "gamut": gamut, "alpha": alpha}
        if suffix == ".exr":
            check_unchanged(bits, str(space), str(gamut))
            how = {"alpha": True} if alpha else {}
        texts = self._texts(how, place.parent)
        with file.atomic(place) as temporary:
            if self._picture is None or self._arrays is not None or alpha:
                return self._save_arrays(
                    temporary, suffix, (bits, str(space), str(gamut), alpha), texts
                )
            if suffix == ".exr":
                self._picture.save_exr(temporary, texts)
                return 0.0
            return self._picture.save_png(temporary, str(space), str(gamut), bits, texts)

    def _png(self, how: _How) -> tuple[bytes, float]:
        """A PNG, and the share of its pixels out of gamut; of no folder to name files from."""
        codes, outside = self.develop(*how)
        named = dict(zip(("bits", "space", "gamut", "alpha"), how, strict=True))
        return _core.png_bytes(codes, how[1], self._texts(named, None)), outside

    def _save_arrays(self, path: Path, suffix: str, how: _How, texts: _Texts) -> float:
        """Write the arrays, which may have been changed since they were rendered."""
        if suffix == ".exr":
            from nacreous.alpha import opaque, pearls_alone

            rgba = pearls_alone(self.layers) if how[3] else opaque(self.linear)
            _core.write_exr(path, [("", rgba), *self.layers.items()], texts)
            return 0.0
        codes, outside = self.develop(*how)
        _core.write_png(path, codes, how[1], texts)
        return outside

    def _texts(self, how: Mapping[str, object], folder: Path | None) -> _Texts:
        """The recipe for a file, in a folder if in any, and how light became what it holds."""
        texts = dict(self.recipe) if folder is None else moved(self.recipe, relative_to(folder))
        if how and texts:
            texts["developed"] = json.dumps(how)
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

    Same pearl, scene, size and samples: same bytes. Memory: some 90 bytes a pixel with a PNG of
    it, 300 with an OpenEXR file, 50 MB (docs/picture.md has the measurement), and up to 25 MB for
    each different grain (24 different pearls in 1024 x 1024: 460 MB).

    >>> image = render("paper", size=16, samples=4)
    >>> parts = ("interference", "diffuse", "mirror", "surroundings")
    >>> bool(abs(sum(image.layers[part] for part in parts) - image.linear).max() < 1e-6)
    True
    """
    return render_recipe(recipe(pearl, scene, size, samples), progress)


def render_recipe(made: Recipe, progress: Callable[[float], None] | None = None) -> Image:
    """Render a recipe; `progress`, and what it costs, as for `render`.

    >>> from nacreous.recipe import recipe
    >>> render_recipe(recipe("paper", "paper", 8, 4)).linear.shape
    (8, 8, 3)
    """
    report = None if progress is None else lambda rows: progress(rows / made.size)
    spectra, panoramas, photographed = _core.files_needed(made.json)
    picture = _core.render(
        made.json,
        _spectra(spectra),
        [(path, file.read_panorama(path)) for path in panoramas],
        _measured_grains(made.json, photographed),
        report,
    )
    return Image._rendered(picture, hold_files(made.texts, made.json))


def files_of(made: Recipe) -> list[str]:
    """The files that a recipe names: measured lights, panoramas, photographs.

    >>> from nacreous.recipe import recipe
    >>> files_of(recipe("paper", "paper", 8, 4))
    []
    """
    return files_needed(made.json)


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
    return recipe(pearl, scene, size, samples).json


def field_mm(
    pearl: Given | Sequence[Given] = "paper", scene: str | Path | Scene = "paper"
) -> float:
    """Width of the view at the scene's origin in mm: camera.field_mm, or one that shows all pearls.

    Arguments, and `InputError`, as for `render`.

    >>> field_mm("paper", "paper")
    12.0
    """
    return _core.field_mm(recipe_json(pearl, scene, 1, 1))


def _spectra(names: list[str]) -> list[tuple[str, list[float]]]:
    """The measured lights in files."""
    if not names:
        return []
    from nacreous.colour import spectrum_from_csv

    return [(name, spectrum_from_csv(name).tolist()) for name in names]


def _measured_grains(made: str, photographed: Sequence[int]) -> list[tuple[int, Grain]]:
    """The grain on the photograph of each pearl, by its number."""
    if not photographed:
        return []
    from nacreous.spec import Pearl
    from nacreous.texture import measured_grain

    pearls = json.loads(made)["pearls"]
    return [
        (number, measured_grain(Pearl.model_validate_json(json.dumps(pearls[number]))))
        for number in photographed
    ]


if TYPE_CHECKING:
    _Texts: TypeAlias = list[tuple[str, str]]
    _How: TypeAlias = tuple[Literal[8, 16], str, str, bool]
    _Arrays: TypeAlias = tuple[NDArray[np.float32], Mapping[str, NDArray[np.float32]]]
