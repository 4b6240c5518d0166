"""Folders of outputs that belong together: all files of a run, or none."""

from __future__ import annotations

import json
import os
import secrets
import shutil
from collections.abc import Collection, Iterator
from contextlib import contextmanager
from os import PathLike
from pathlib import Path

from nacreous.problem import InputError

__all__ = ["whole"]


_TEMPORARY = ".nacreous-"


@contextmanager
def whole(
    path: str | PathLike[str], names: Collection[str], record: str, maker: str
) -> Iterator[Path]:
    """Fill the folder `path` with files so that either all of them appear in it or none.

    Yields a temporary folder to be filled with files of the given `names`. At the end they are
    moved into place; after any exception, Ctrl-C included, the temporary folder is removed and
    `path` is as it was. `path` may be missing or empty or hold an earlier run by the same maker:
    only files of these names, and among them the JSON file `record` whose "made_by" is `maker`. A
    folder that was missing appears in one step; in one that was there the files are moved one by
    one, each whole.

    Raises `InputError` for any other folder, and where none can be written.

    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as parent:
    ...     with whole(f"{parent}/out", ["run.json"], "run.json", "nacreous test") as folder:
    ...         _ = (folder / "run.json").write_text('{"made_by": "nacreous test"}')
    ...     sorted(file.name for file in Path(parent, "out").iterdir())
    ['run.json']
    """
    try:
        target = Path(os.path.realpath(path))
        _check(path, target, names, record, maker)
        temporary = _create(path, target)
    except (OSError, ValueError) as problem:
        raise (
            problem if isinstance(problem, InputError) else _unwritable(path, problem)
        ) from problem
    try:
        yield temporary
        _move(temporary, target)
    except OSError as problem:
        # An error about some other file is not ours to translate.
        if problem.filename is None or str(problem.filename).startswith(str(temporary)):
            raise _unwritable(path, problem) from problem
        raise
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def _check(
    path: str | PathLike[str], target: Path, names: Collection[str], record: str, maker: str
) -> None:
    if not target.exists():
        return
    if not target.is_dir():
        raise InputError(f"{path}: is a file; wanted: a folder, empty or not there yet")
    # What a killed run left behind is ours.
    found = {entry.name for entry in target.iterdir() if not entry.name.startswith(_TEMPORARY)}
    strange = sorted(found - set(names))
    if strange or (found and not _made_by(target / record, maker)):
        what = f"holds {strange[0]!a}" if strange else f"holds files but no {record} of {maker}"
        raise InputError(f"{path}: {what}; wanted: an empty folder, or one that {maker} made")


def _made_by(record: Path, maker: str) -> bool:
    try:
        if not record.is_file():  # nobody waits for a pipe
            return False
        content = json.loads(record.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return False
    return isinstance(content, dict) and content.get("made_by") == maker


def _create(path: str | PathLike[str], target: Path) -> Path:
    """A folder from which files can be moved to `target` without copying."""
    place = target if target.exists() else target.parent
    if not place.is_dir():
        raise InputError(f"{path}: the folder {place} does not exist")
    temporary = place / f"{_TEMPORARY}{secrets.token_hex(4)}"
    temporary.mkdir()
    return temporary


def _move(temporary: Path, target: Path) -> None:
    if not target.exists():
        temporary.rename(target)
        return
    # The folder itself stays: someone may be standing in it.
    for file in sorted(temporary.iterdir()):
        file.replace(target / file.name)


def _unwritable(path: str | PathLike[str], problem: OSError | ValueError) -> InputError:
    number = problem.errno if isinstance(problem, OSError) else None
    return InputError(f"{path}: cannot be written ({os.strerror(number) if number else problem})")
