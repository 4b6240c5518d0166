"""Files of published media, and where pyElli keeps the database."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

from nacreous import medium

#: In pyElli's folder, which is found without reading pyElli: every worker reads this file.
ELLI = Path(find_spec("elli").origin).parent
DATABASE = ELLI / "database" / "refractiveindexinfo-database" / "database"


def written(folder: Path, text: str, name: str = "medium.yml") -> Path:
    file = folder / name
    file.write_text(text, encoding="utf-8")
    return file


def formula(folder: Path, number: int, coefficients: str, span_um: str) -> medium.PublishedIndex:
    text = f"REFERENCES: |\n    a <i>book</i>\nDATA:\n  - type: formula {number}\n"
    text += f"    wavelength_range: {span_um}\n    coefficients: {coefficients}\n"
    return medium.read(written(folder, text))
