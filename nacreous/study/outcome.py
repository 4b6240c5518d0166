"""The old name of `nacreous.study.results`, kept for one version."""

from __future__ import annotations

import warnings
from typing import Any

from nacreous.study import results


def __getattr__(name: str) -> Any:
    if name not in results.__all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    warnings.warn(
        "nacreous.study.outcome is now nacreous.study.results", DeprecationWarning, stacklevel=2
    )
    return getattr(results, name)
