"""A column of an export, described."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

__all__ = ["Column"]


@dataclass(frozen=True)
class Column:
    """A column: its name, what it holds, its unit and its values where they are few."""

    name: str
    description: str
    unit: str | None = None
    values: tuple[str, ...] = ()

    def property_value(self) -> dict[str, Any]:
        """As schema.org's PropertyValue."""
        made: dict[str, Any] = {
            "@type": "PropertyValue",
            "name": self.name,
            "description": self.description,
        }
        if self.unit is not None:
            made["unitText"] = self.unit
        if self.values:
            made["valueReference"] = list(self.values)
        return made
