"""Former names of public things, each kept for one version."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Mapping
from typing import Any

__all__ = ["keep_former_names"]


def keep_former_names(module: str, present: Mapping[str, str], public: str | None = None) -> None:
    """Let a module's former names lead to its present ones, and warn (`DeprecationWarning`).

    present: each former name with the present one. public: the package that offers both, where
    it is not the module itself. Type checkers do not see former names, so the house uses none.
    """
    place, stacklevel = (module, 2) if public is None else (public, 3)

    def find(name: str) -> Any:
        if name not in present:
            raise AttributeError(f"module {module!r} has no attribute {name!r}")
        warnings.warn(
            f"{place}.{name} is now {place}.{present[name]}",
            DeprecationWarning,
            stacklevel=stacklevel,
        )
        return getattr(sys.modules[module], present[name])

    sys.modules[module].__getattr__ = find  # type: ignore[method-assign]
