"""The [[stimuli]] of a study."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import AfterValidator, Field

from nacreous.spec import preset
from nacreous.spec.complaint import Contradiction
from nacreous.spec.key import FilePath, key, quantity
from nacreous.spec.section import Section
from nacreous.spec.texts import NAME, Name, ending

_LINKS = (".toml",)
_PICTURES = (".png", ".jpg", ".jpeg", ".tif", ".tiff")

#: How many crops a pearl has. A test holds it to nacreous.paper.crop; files need no picture.
CROPS = 7


def _known(kind: str) -> AfterValidator:
    def check(name: str) -> str:
        if not FilePath(_LINKS).names_file(name) and name not in preset.names(kind):
            raise ValueError("no such preset")
        return name

    return AfterValidator(check)


_PATTERN = f"^([a-z0-9][a-z0-9.-]*|{ending(*_LINKS)})$"
_Pearl = Annotated[str, Field(pattern=_PATTERN), _known("pearl"), FilePath(_LINKS)]
_Scene = Annotated[str, Field(pattern=_PATTERN), _known("scene"), FilePath(_LINKS)]
_Picture = Annotated[str, Field(pattern=f"^{ending(*_PICTURES)}$"), FilePath(_PICTURES)]
_Override = Annotated[str, Field(pattern="^[^=\n]+=[^\n]+$", max_length=1000)]


class Stimulus(Section):
    """What is shown: a pearl to be rendered, or a picture; the whole of it or its seven crops.

    >>> Stimulus(pearl="paper", cut="seven-crops").labels
    ('1', '2', '3', '4', '5', '6', '7')
    """

    label: Name | None = key(
        None,
        "What the stimulus is called in plans and answers; participants never see it.",
        allowed=NAME,
        left_out='with cut = "seven-crops" alone: the labels are then 1 to 7',
        source="free",
    )
    pearl: _Pearl | None = key(
        None,
        "A pearl to be rendered: a preset, or a file relative to this one.",
        allowed="a pearl preset or a path ending in .toml",
        left_out="picture is given instead",
        source="**(ours)**",
        examples=preset.names("pearl"),
    )
    scene: _Scene | None = key(
        None,
        "The scene that the pearl is rendered in.",
        allowed="a scene preset or a path ending in .toml",
        left_out="the scene paper, where there is a pearl",
        source="**(ours)**",
        examples=preset.names("scene"),
    )
    overrides: Annotated[tuple[_Override, ...], Field(max_length=100)] = key(
        (),
        'Single keys of pearl or scene changed, as in "depth=0.8".',
        allowed='0 to 100 texts such as "depth=0.8"',
        source="**(ours)**; as --set of nacreous render",
        strict=False,
    )
    words: Annotated[tuple[_Override, ...], Field(max_length=20)] = key(
        (),
        'The trade\'s words that set keys of the pearl, as in "luster=Fair"; overrides go before.',
        allowed='0 to 20 texts such as "luster=Fair"',
        source="**(ours)**; as --word of nacreous render, docs/words.md",
        strict=False,
    )
    picture: _Picture | None = key(
        None,
        "A picture, relative to this file.",
        allowed=f"a path ending in {', '.join(_PICTURES)}",
        left_out="pearl is given instead",
        source="**(ours)**",
    )
    cut: Literal["whole", "seven-crops"] = key(
        "whole",
        "The whole picture, or the seven crops of figure 2, each a stimulus.",
        allowed='"whole" or "seven-crops"',
        source="paper 2.2, figure 2",
    )
    width_mm: float | None = quantity(
        None,
        "Width of the stimulus on the screen; of a crop that of the crop.",
        least=1,
        most=1000,
        unit="mm",
        left_out="display.width_mm",
        source="**(ours)**",
    )

    @property
    def labels(self) -> tuple[str, ...]:
        """The labels of the stimuli that this table stands for: one, or seven."""
        if self.cut == "whole":
            return (self.label or "",)
        stem = f"{self.label} " if self.label else ""
        return tuple(f"{stem}{number}" for number in range(1, CROPS + 1))

    def contradictions(self) -> Iterator[Contradiction]:
        """Nothing to show or two things, and keys that would be ignored."""
        if self.pearl is None and self.picture is None:
            yield Contradiction("pearl", "is missing: give it, or give picture")
        if self.pearl is not None and self.picture is not None:
            yield Contradiction("picture", "cannot stand beside {other}: show one", "pearl")
        elif self.picture is not None:
            verdict = "cannot stand beside {other}: nothing is rendered"
            for name in ("scene", "overrides", "words"):
                if getattr(self, name):
                    yield Contradiction(name, verdict, "picture")
        if self.label is None and self.cut == "whole":
            yield Contradiction("label", f"is missing; allowed: {NAME}")
