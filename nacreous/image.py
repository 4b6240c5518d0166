"""The picture of a pearl: a pearl and a scene in, linear light in named parts out."""

from __future__ import annotations

import json
import math
import platform
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from nacreous import _core, colour, file, look, texture
from nacreous.arrangement import Arrangement, arrange
from nacreous.number import said
from nacreous.problem import InputError
from nacreous.spec import Growth, Pearl, Scene
from nacreous.spec.row import MOST_PEARLS

__all__ = ["SUFFIXES", "Image", "render"]

#: The kinds of picture file that can be written.
SUFFIXES = (".png", ".exr")

Spec = TypeVar("Spec", Pearl, Scene)
Given: TypeAlias = str | Path | Pearl


@dataclass(frozen=True)
class Image:
    """Rendered pearls in linear light, and the recipe they can be made from again.

    linear: float32 [row, column, rgb] in the primaries of sRGB, relative to the scene's white; may
    leave 0..1. layers: the parts "interference", "diffuse", "mirror" and "surroundings", which add
    up to linear, and "texture" (hue, value, chroma) and "coverage" (of all pearls). recipe: texts
    "pearl" (of several different pearls "pearl.0", "pearl.1" and so on), "scene" and others.
    """

    linear: NDArray[np.float32]
    layers: Mapping[str, NDArray[np.float32]]
    recipe: Mapping[str, str] = field(default_factory=dict)

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
        if bits not in (8, 16):
            raise InputError(f"bits is {said(bits)}; allowed: 8, 16")
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
        outside = 0.0
        with file.atomic(path) as temporary:
            if suffix == ".exr":
                _core.write_exr(temporary, [("", self.linear), *self.layers.items()], self._texts())
            else:
                codes, outside = self.develop(bits, space, gamut)
                _core.write_png(temporary, codes, space, self._texts())
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
    scene's rows, in turn. size: pixels a side, 1 to 8192. samples: a
    pixel, a square number, 1 to 1024. progress: called with the finished share, 0 to 1, now and
    then; what it raises stops the render, as Ctrl-C does.

    Same pearl, scene, size and samples: same bytes. Memory: 76 bytes a pixel, some 60 MB, and up to
    25 MB for each different grain (24 different pearls in 1024 x 1024: 460 MB).

    >>> image = render("paper", size=16, samples=4)
    >>> parts = ("interference", "diffuse", "mirror", "surroundings")
    >>> bool(np.abs(sum(image.layers[part] for part in parts) - image.linear).max() < 1e-6)
    True
    """
    scene = _loaded(Scene, scene)
    size, side = _size(size), _samples_side(samples)
    arrangement = arrange(_given(pearl), scene)
    report = None if progress is None else lambda rows: progress(rows / size)
    pixels = _core.render(
        _prepared(arrangement.pearls, arrangement.field_mm() / size * arrangement.nearest()),
        _surroundings(arrangement),
        size,
        side,
        report,
    )
    layers = {name: pixels[..., first:end] for name, first, end in _core.parts()}
    first_four = list(layers.values())[:4]
    linear = sum(first_four[1:], first_four[0])
    return Image(linear, layers, _recipe(arrangement, size, side * side))


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


def _size(size: int) -> int:
    if _is_whole(size) and 1 <= size <= _core.MAX_SIZE_PX:
        return int(size)
    raise InputError(f"size is {said(size)}; allowed: a whole number from 1 to {_core.MAX_SIZE_PX}")


def _samples_side(samples: int) -> int:
    side = math.isqrt(samples) if _is_whole(samples) and 1 <= samples <= 1024 else 0
    if side and side * side == samples:
        return side
    allowed = "a square number from 1 to 1024, such as 16"
    raise InputError(f"samples is {said(samples)}; allowed: {allowed}")


def _is_whole(value: object) -> bool:
    return isinstance(value, int | np.integer) and not isinstance(value, bool)


def _prepared(
    pearls: list[Pearl], pixel_mm: float
) -> list[tuple[Mapping[str, Any], _core.Texture | None]]:
    """Each pearl's look, and its grain if it shows any; pearls of the same grain share it.

    pixel_mm: the least width on a pearl that a pixel has.
    """
    grains: dict[Any, _core.Texture] = {}
    prepared: list[tuple[Mapping[str, Any], _core.Texture | None]] = []
    for pearl in pearls:
        seen, grain = look.subject_of(pearl), (pearl.texture, pearl.diameter_mm, pearl.texture_seed)
        if not any(seen[weight] for weight in look.GRAIN):
            prepared.append((seen, None))
            continue
        if grain not in grains:
            grains[grain] = texture.texture_of(pearl, 2 * pixel_mm / pearl.diameter_mm)
        prepared.append((seen, grains[grain]))
    return prepared


def _surroundings(arrangement: Arrangement) -> dict[str, Any]:
    scene = arrangement.scene
    camera, walls, table = scene.camera, scene.walls, scene.table
    return {
        "observer": scene.observer,
        "white": None if camera.white == "auto" else colour.light(camera.white),
        "camera": {
            "distance_mm": camera.distance_mm if camera.projection == "perspective" else None,
            "elevation_rad": math.radians(camera.elevation_deg),
            "azimuth_rad": math.radians(camera.azimuth_deg),
            "field_mm": arrangement.field_mm(),
            "exposure": camera.exposure,
            "glare": camera.glare,
            "glare_mm": camera.distance_mm * math.tan(math.radians(camera.glare_deg)),
        },
        "places": [place._asdict() for place in arrangement.places],
        # A lamp or window switched off has no say in what looks white either.
        "lamps": [_lamp(lamp) for lamp in scene.lamps if lamp.intensity > 0],
        "windows": [
            arrangement.frame(window)._asdict()
            | {"spectrum": colour.light(window.spectrum), "luminance": window.luminance}
            for window in scene.windows
            if window.luminance > 0
        ],
        "table": None if table.kind == "none" else _coloured(table.model_dump()),
        "walls": None if walls is None else _coloured(walls.model_dump()),
        "sky": _sky(scene),
    }


def _lamp(lamp: Any) -> dict[str, Any]:
    direction = None
    if lamp.position_mm is None:
        azimuth, elevation = math.radians(lamp.azimuth_deg), math.radians(lamp.elevation_deg)
        flat = math.cos(elevation)
        direction = (math.sin(azimuth) * flat, math.sin(elevation), math.cos(azimuth) * flat)
    return {
        "direction": direction,
        "position_mm": lamp.position_mm or (0.0, 0.0, 0.0),
        "angular_radius_rad": math.radians(lamp.angular_radius_deg),
        "spectrum": colour.light(lamp.spectrum),
        "intensity": lamp.intensity,
    }


def _sky(scene: Scene) -> dict[str, Any]:
    sky = scene.sky
    zenith = sky.zenith if sky.kind == "gradient" else sky.horizon
    return {
        "horizon": colour.linear_from_hex(sky.horizon),
        "zenith": colour.linear_from_hex(zenith),
        "panorama": None if sky.path is None else file.read_panorama(sky.path),
        "rotation_rad": math.radians(sky.rotation_deg),
        "intensity": sky.intensity,
    }


def _coloured(section: dict[str, Any]) -> dict[str, Any]:
    """The section with its colours as linear RGB."""
    return {
        key: colour.linear_from_hex(value) if key.endswith("colour") else value
        for key, value in section.items()
    }


def _recipe(arrangement: Arrangement, size: int, samples: int) -> dict[str, str]:
    """Everything that makes the picture again, as texts for its file."""
    from nacreous import __version__

    pearls = arrangement.pearls
    seeds = [p.nacre.seed if isinstance(p.nacre, Growth) else None for p in pearls]
    texture_seeds = [p.texture_seed for p in pearls]
    one = len(pearls) == 1
    versions = {
        "nacreous": __version__,
        "python": platform.python_version(),
        "numpy": np.__version__,
    }
    settings = {
        "size": size,
        "samples": samples,
        "seed": seeds[0] if one else seeds,
        "texture_seed": texture_seeds[0] if one else texture_seeds,
    }
    return {
        **{"pearl" if one else f"pearl.{i}": p.to_toml() for i, p in enumerate(pearls)},
        "scene": arrangement.scene.to_toml(),
        "settings": json.dumps(settings),
        "versions": json.dumps(versions),
    }
