"""A file that is not there, and the one beside it that was probably meant."""

from __future__ import annotations

import os
from contextlib import suppress
from os import PathLike
from pathlib import Path

from nacreous.printable import printable
from nacreous.problem import InputError

#: Names looked at in a folder, so that one of a million files costs no more than a moment.
_MOST_NAMES = 10_000


def missing(path: str | PathLike[str], wanted: str = "") -> InputError:
    """The message that a path does not exist, with the name beside it that is nearest.

    >>> str(missing("no such folder/pearl.toml", "a pearl file"))
    'no such folder/pearl.toml: does not exist; wanted: a pearl file'
    """
    with suppress(OSError, ValueError):  # no link, or no name that one can have
        leads = printable(str(Path(path).readlink()))
        return InputError(f"{printable(os.fspath(path))}: is a link that leads nowhere, to {leads}")
    near = beside(path)
    hints = [f"; wanted: {wanted}" if wanted else "", f"; did you mean {near}?" if near else ""]
    return InputError(f"{printable(os.fspath(path))}: does not exist{''.join(hints)}")


def beside(path: str | PathLike[str]) -> str | None:
    """The path of a file or folder in the same folder whose name is nearest, or None.

    The same name in other letters, small or capital, comes first: `mine.toml` for `Mine.toml`; then
    the same name with an ending: `mine.toml` for `mine`.

    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     _ = Path(folder, "mine.toml").touch()
    ...     [Path(beside(f"{folder}/{name}")).name for name in ("mine", "mien.toml")]
    ['mine.toml', 'mine.toml']
    """
    place = Path(path)
    try:
        with os.scandir(place.parent) as entries:
            names = [entry.name for entry, _ in zip(entries, range(_MOST_NAMES), strict=False)]
    except (OSError, ValueError):  # no folder either, or no name that a folder can have
        return None
    near = _nearest(place.name, sorted(names))
    return None if near is None else str(place.with_name(near))


def _nearest(name: str, names: list[str]) -> str | None:
    from difflib import get_close_matches

    word = name.lower()
    by_name = {other.lower(): other for other in names}
    if word in by_name:
        return by_name[word]
    by_stem = {Path(other).stem.lower(): other for other in names}
    if word in by_stem:
        return by_stem[word]
    for known in (by_name, {} if Path(name).suffix else by_stem):
        near = get_close_matches(word, list(known), n=1, cutoff=0.7)
        if near:
            return known[near[0]]
    return None
