"""The pictures of stimuli, rendered or read, whole or in crops."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous import colour, file, image
from nacreous.paper.circle import Circle
from nacreous.paper.crop import Crop, cut, seven
from nacreous.paper.outline import estimate
from nacreous.problem import InputError
from nacreous.spec import Pearl, Scene
from nacreous.spec.load import shared_out
from nacreous.study.design.display import Display
from nacreous.study.design.stimulus import Stimulus

__all__ = ["Picture", "Source"]

Codes = NDArray[np.uint8]


@dataclass(frozen=True)
class Picture:
    """The pixels of one stimulus, uint8 sRGB [row, column, rgb], and what makes them again."""

    label: str
    codes: Codes
    width_mm: float
    recipe: dict[str, Any] | None


@dataclass(frozen=True)
class Source:
    """A table of [[stimuli]] with all that it names found and read, before anything is rendered."""

    stimulus: Stimulus
    pearl: Pearl | None
    scene: Scene | None
    photograph: Path | None

    @classmethod
    def of(cls, stimulus: Stimulus, folder: Path, where: str) -> Source:
        """Read the files; `folder` is what their paths are relative to, `where` is for messages."""
        try:
            if stimulus.picture is not None:
                return cls(stimulus, None, None, folder / stimulus.picture)
            of_pearl, of_scene = shared_out(stimulus.overrides)
            pearl = Pearl.load(_placed(stimulus.pearl or "paper", folder), of_pearl)
            return cls(
                stimulus,
                pearl,
                Scene.load(_placed(stimulus.scene or "paper", folder), of_scene),
                None,
            )
        except InputError as problem:
            lines = str(problem).replace("--set", "overrides").splitlines()
            raise InputError("\n".join(f"{where}: {line}" for line in lines)) from None

    def pictures(
        self, display: Display, where: str, progress: Callable[[float], None] | None
    ) -> Iterator[Picture]:
        """Render or read, and cut: one picture, or seven."""
        try:
            codes, circle, recipe = self._whole(display, progress)
            width_mm = self.stimulus.width_mm or display.width_mm
            if self.stimulus.cut == "whole":
                yield Picture(self.stimulus.labels[0], codes, width_mm, recipe)
                return
            linear = colour.decode(codes / 255.0)
            crops = seven(linear, circle or estimate(linear.astype(np.float32))[0])
        except InputError as problem:
            raise InputError(f"{where}: {problem}") from None
        for label, crop, part in zip(self.stimulus.labels, crops, cut(codes, crops), strict=True):
            yield Picture(label, part, width_mm, _cut_recipe(recipe, crop))

    def _whole(
        self, display: Display, progress: Callable[[float], None] | None
    ) -> tuple[Codes, Circle | None, dict[str, Any] | None]:
        """The whole picture, the pearl's outline where geometry gives it, and the recipe."""
        if self.photograph is not None:
            linear = file.read_photograph(self.photograph)
            codes, _ = image.Image(linear, {}).develop(gamut="clip")
            return codes.astype(np.uint8, copy=False), None, None
        if self.pearl is None or self.scene is None:
            raise TypeError("a source has a pearl in a scene, or a photograph")
        size_px = display.size_px
        made = image.render(self.pearl, self.scene, size_px, display.samples, progress)
        codes, _ = made.develop()
        circle = Circle.of_camera(self.scene.camera, self.pearl.diameter_mm, size_px)
        recipe: dict[str, Any] = dict(made.recipe)
        for name in ("settings", "versions"):
            recipe[name] = json.loads(recipe[name])
        return codes.astype(np.uint8, copy=False), circle, recipe


def _placed(name: str, folder: Path) -> str:
    return str(folder / name) if name.lower().endswith(".toml") else name


def _cut_recipe(recipe: dict[str, Any] | None, crop: Crop) -> dict[str, Any] | None:
    return None if recipe is None else {**recipe, "crop": crop.record()}
