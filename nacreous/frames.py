"""Keeps pandas out of programs that take no data frame."""

from __future__ import annotations

import sys

__all__ = ["without_pandas"]


def without_pandas() -> None:
    """Tell whoever looks for pandas from now on that it is not installed.

    No command takes a data frame, but pyarrow would import pandas, where there is any, to see
    whether it is given one, which takes longer than most commands, and 45 MB.
    """
    sys.meta_path.insert(0, _WithoutPandas())


class _WithoutPandas:
    @staticmethod
    def find_spec(name: str, path: object = None, target: object = None) -> None:
        """As Python's import asks, of every module that is not loaded yet."""
        if name == "pandas":
            raise ModuleNotFoundError("no command needs pandas", name=name)
