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
from nacreous.named_files import FILES, moved, relative_to
from nacreous.paper.circle import Circle
from nacreous.paper.crop import Crop, cut, seven
from nacreous.paper.cutting import outline_of
from nacreous.problem import InputError
from nacreous.spec import Pearl, Scene, override
from nacreous.spec.load import shared_out
from nacreous.study.design.display import Display
from nacreous.study.design.stimulus import Stimulus
from nacreous.trade import overrides_of, with_words

__all__ = ["Picture", "Source"]

Codes = NDArray[np.uint8]

#: The most pixels a side of a stimulus **(ours)**: those of the largest screens.
_MOST_PX = 4096


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
    folder: Path

    @classmethod
    def of(cls, stimulus: Stimulus, folder: Path, where: str) -> Source:
        """Read the files; `folder` is what their paths are relative to, `where` is for messages."""
        try:
            if stimulus.picture is not None:
                return cls(stimulus, None, None, folder / stimulus.picture, folder)
            of_pearl, of_scene = shared_out(with_words(stimulus.words, stimulus.overrides))
            pearl = Pearl.load(_placed(stimulus.pearl or "paper", folder), of_pearl)
            scene = Scene.load(_placed(stimulus.scene or "paper", folder), of_scene)
            if stimulus.cut == "seven-crops" and scene.rows:
                raise InputError("scene has rows; allowed with seven crops: a scene of one pearl")
            return cls(stimulus, pearl, scene, None, folder)
        except InputError as problem:
            said = str(problem).replace("--set", "overrides").replace("--word", "words")
            lines = said.splitlines()
            raise InputError("\n".join(f"{where}: {line}" for line in lines)) from None

    def pictures(
        self, display: Display, where: str, progress: Callable[[float], None] | None
    ) -> Iterator[Picture]:
        """Render or read, and cut: one picture, or seven."""
        width_mm = self.stimulus.width_mm or display.width_mm
        try:
            if self.photograph is not None:
                codes, crops, recipe = self._read(self.photograph)
            else:
                codes, crops, recipe = self._rendered(display, progress)
            parts = [codes] if crops is None else cut(codes, crops)
            _check_sizes(parts)
        except InputError as problem:
            raise InputError(f"{where}: {problem}") from None
        for place, (label, part) in enumerate(zip(self.stimulus.labels, parts, strict=True)):
            own = recipe
            if recipe is not None and crops is not None:
                own = {**recipe, "crop": crops[place].record()}
            yield Picture(label, part, width_mm, own)

    def _read(self, photograph: Path) -> tuple[Codes, list[Crop] | None, None]:
        linear = file.read_photograph(photograph)
        codes, _ = image.Image(linear, {}).develop(gamut="clip")
        crops = None
        if self.stimulus.cut == "seven-crops":
            crops = seven(linear, outline_of(photograph, linear))
        return codes.astype(np.uint8, copy=False), crops, None

    def _rendered(
        self, display: Display, progress: Callable[[float], None] | None
    ) -> tuple[Codes, list[Crop] | None, dict[str, Any]]:
        if self.pearl is None or self.scene is None:
            raise TypeError("a source has a pearl in a scene, or a photograph")
        size_px = display.size_px
        made = image.render(self.pearl, self.scene, size_px, display.samples, progress)
        codes, _ = made.develop()
        crops = None
        if self.stimulus.cut == "seven-crops":
            circle = Circle.of_view(self.pearl, self.scene, size_px)
            crops = seven(colour.decode(codes / 255.0), circle)
        # As seen from the study's file, wherever the program ran.
        recipe: dict[str, Any] = moved(made.recipe, relative_to(self.folder))
        for name in {"settings", "versions", FILES} & recipe.keys():
            recipe[name] = json.loads(recipe[name])
        if self.stimulus.words:
            recipe["words"] = _set_by_words(self.stimulus)
        return codes.astype(np.uint8, copy=False), crops, recipe


def _set_by_words(stimulus: Stimulus) -> dict[str, dict[str, float]]:
    """The keys that each word has set with their numbers, which a later table may have otherwise.

    Without those that an override has set anew.
    """
    anew = {override.parse(setting)[0] for setting in stimulus.overrides}
    return {
        word: {key: float(value) for key, value in overrides_of(word) if key not in anew}
        for word in stimulus.words
    }


def _placed(name: str, folder: Path) -> str:
    return str(folder / name) if name.lower().endswith(".toml") else name


def _check_sizes(parts: list[Codes]) -> None:
    """Pictures that a participant's browser can hold, several at a time."""
    for part in parts:
        height_px, width_px = part.shape[:2]
        if max(height_px, width_px) > _MOST_PX:
            raise InputError(
                f"picture has {width_px} x {height_px} pixels; allowed: up to {_MOST_PX} a side"
            )
