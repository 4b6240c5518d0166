"""A figure of the paper made again: pictures, the paper's sentences, and what was measured."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from nacreous.paper.measurement import Measurement

__all__ = ["Exhibit", "Plate", "Quotation"]


@dataclass(frozen=True)
class Quotation:
    """A sentence of the paper, our translation, and where it stands."""

    japanese: str
    english: str
    section: str


@dataclass(frozen=True)
class Plate:
    """One picture of a figure: its file, and what is to be seen for those who cannot see it."""

    path: Path
    alt: str
    label: str = ""
    small: bool = False
    """Shown at its own size: a crop of a few pixels more than a picture."""


@dataclass(frozen=True)
class Exhibit:
    """Everything the page says about one figure."""

    number: str
    japanese: str
    english: str
    """The captions of the paper."""
    quotations: list[Quotation]
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
