"""What somebody is given who has finished."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["Ending"]


@dataclass(frozen=True)
class Ending:
    """A completion code, and the address to go back to; None where the study has none."""

    code: str | None
    return_url: str | None
