"""A figure of the paper made again: pictures, the paper's sentences, and what was measured."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

from nacreous.paper.measurement import Measurement

__all__ = ["Exhibit", "Plate", "Quotation"]


@dataclass(frozen=True)
class Plate:
    """One picture of a figure: its file, and a few words beside it."""

    path: Path
    label: str = ""
    small: bool = False
    """Only some pixels wide, and shown so that each can be seen."""


@dataclass(frozen=True)
class Quotation:
    """A sentence of the paper, our translation, and the section it stands in."""

    section: str
    japanese: str
    english: str


@dataclass(frozen=True)
class Exhibit:
    """Everything the page says about one figure; its words stand in captions.toml.

    >>> Exhibit("8", [], [], "").english
    'Angle of incidence and reflectance by view angle.'
    """

    number: str
    plates: list[Plate]
    measurements: list[Measurement]
    command: str
    """What makes it again."""
    remarks: list[str] = field(default_factory=list)
    """Plain sentences: what is shown, how, and what is ours."""

    @property
    def asked(self) -> list[Measurement]:
        """The measurements with a criterion."""
        return [measured for measured in self.measurements if measured.holds is not None]

    @property
    def japanese(self) -> str:
        """The paper's caption in Japanese."""
        return str(_captions()[self.number]["japanese"])

    @property
    def english(self) -> str:
        """The paper's caption in English."""
        return str(_captions()[self.number]["english"])

    @property
    def quotations(self) -> list[Quotation]:
        """The sentences that the figure must satisfy."""
        return [Quotation(**quoted) for quoted in _captions()[self.number]["quotations"]]

    def alt(self, plate: Plate) -> str:
        """What is to be seen on a plate, for those who cannot see it."""
        return str(_captions()[self.number]["alts"][plate.path.name])


@cache
def _captions() -> dict[str, Any]:
    return tomllib.loads(Path(__file__).with_name("captions.toml").read_text(encoding="utf-8"))
