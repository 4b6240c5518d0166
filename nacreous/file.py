"""Files in and out: outputs that are whole or absent, and pictures that users bring.

Readers name the file, the problem and what is allowed in one line (`InputError`), before they
decode anything that is beyond the limits: 16384 pixels a side, 64 megapixels, 512 MiB.
"""

from __future__ import annotations

import os
import stat
import unicodedata
from collections.abc import Collection, Iterable, Iterator, Sequence
from contextlib import contextmanager
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from nacreous import _core
from nacreous.missing import missing
from nacreous.number import said
from nacreous.problem import InputError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = [
    "atomic",
    "check_ordinary",
    "check_output",
    "named",
    "read_bytes",
    "read_panorama",
    "read_photograph",
    "read_png_text",
    "read_text",
    "require_apart",
]


@contextmanager
def atomic(path: str | PathLike[str], *, private: bool = False) -> Iterator[Path]:
    """Write a file so that, whatever happens, `path` is the old file or the whole new one.

    Yields the path of a temporary file in the same folder, with the same ending, to be written by
    whatever means. At the end it is flushed to the disk and takes the place of `path`; after any
    exception, Ctrl-C included, it is removed. A new file has the permissions that the umask
    leaves, a replaced one keeps its own, and a symbolic link keeps pointing where it did. A
    `private` file is for its owner alone (0600), even while it is written, whatever it replaces.

    Raises `InputError` if `path` cannot be written: the folder is missing or closed, `path` is a
    directory or a device, or the disk is full.

    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     with atomic(f"{folder}/pearl.txt") as temporary:
    ...         _ = temporary.write_text("lustre")
    ...     Path(folder, "pearl.txt").read_text()
    'lustre'
    """
    target = _target(path)
    temporary = _beside(path, target)
    ours = True
    try:
        try:
            # Within: a signal that comes as soon as the file is there finds it to be removed.
            _create(temporary, 0o600 if private else 0o666)
        except OSError as problem:
            ours = False
            raise _unwritable(path, problem) from problem
        yield temporary
        with temporary.open("rb+") as stream:
            os.fsync(stream.fileno())
        if target.exists() and not private:
            temporary.chmod(stat.S_IMODE(target.stat().st_mode))
        temporary.replace(target)
    except BaseException as problem:
        if ours:
            temporary.unlink(missing_ok=True)
        # An error about some other file, which the body read, is not ours to translate.
        if isinstance(problem, OSError) and problem.filename in (None, str(temporary)):
            raise _unwritable(path, problem) from problem
        raise


def check_output(path: str | PathLike[str], suffixes: Collection[str]) -> Path:
    """Return `path` if a file of one of these endings can be written there; ask before long work.

    `suffixes` are lower case with their dot; capitals in `path` are accepted. The folder is tried
    by creating, and removing, a file in it. Raises `InputError` otherwise.

    >>> check_output("pearl.gif", [".png", ".exr"])
    Traceback (most recent call last):
    nacreous.problem.InputError: pearl.gif: the ending is .gif; allowed: .png, .exr
    """
    output = named(path)
    if not os.fspath(path).strip():
        raise InputError(f"the output is empty; allowed: a file that ends in {', '.join(suffixes)}")
    target = _target(path)
    if output.suffix.lower() not in suffixes:
        given = output.suffix or "missing"
        raise InputError(f"{output}: the ending is {given}; allowed: {', '.join(suffixes)}")
    temporary = _beside(path, target)
    try:
        _create(temporary)
    except OSError as problem:
        raise _unwritable(path, problem) from problem
    finally:
        temporary.unlink(missing_ok=True)
    return output


def require_apart(
    outputs: Sequence[str | PathLike[str]], inputs: Iterable[str | PathLike[str] | int]
) -> None:
    """Refuse outputs that are one of the inputs, or each other, by whatever name or link.

    An input may be the number of an open file, such as 0 for standard input; those that are no
    files here, as a preset's name, count as none. Raises `InputError`.

    >>> require_apart(["a.csv", "a.csv"], [])
    Traceback (most recent call last):
    nacreous.problem.InputError: a.csv: is the same file as the output a.csv; allowed: another name
    """
    taken = [(f"the output {path}", path) for path in outputs]
    read = [("standard input" if path == 0 else f"the input {path}", path) for path in inputs]
    for place, output in enumerate(outputs):
        for what, other in read + taken[:place]:
            if _same_file(output, other):
                raise InputError(f"{output}: is the same file as {what}; allowed: another name")


def read_photograph(path: str | PathLike[str]) -> NDArray[np.float32]:
    """Read a photograph (PNG, JPEG or TIFF; 8 or 16 bits; grey or RGB) as linear light.

    Returns linear-light sRGB, float32 [row, column, rgb] in 0..1. Samples are taken as sRGB
    (IEC 61966-2-1) unless the file carries an ICC profile of up to 16 MB, or a PNG the chunks cICP,
    or gAMA and cHRM, from which they are converted to sRGB; of several the first counts: cICP, the
    profile, sRGB, gAMA and cHRM. Colours outside sRGB are clipped. Alpha is ignored; where a TIFF
    has colours multiplied by it, they are divided. The orientation noted by the camera is applied.

    Raises `InputError` for everything that is no such picture or beyond the limits, a profile that
    cannot be read, PQ and HLG, and kinds of TIFF by what they have.

    >>> read_photograph("no such nacre.jpg")
    Traceback (most recent call last):
    nacreous.problem.InputError: no such nacre.jpg: does not exist
    """
    return _core.read_photograph(_there(path))


def read_panorama(path: str | PathLike[str]) -> NDArray[np.float32]:
    """Read a panorama (Radiance .hdr or OpenEXR .exr) as linear light.

    Returns linear-light sRGB, float32 [row, column, rgb], 0 or more and unbounded above. Primaries
    that an OpenEXR file states are converted; values below zero become zero. Raises `InputError`
    for NaN or infinity, and for everything that is no such picture or beyond the limits.

    >>> read_panorama("sky.hdr")
    Traceback (most recent call last):
    nacreous.problem.InputError: sky.hdr: does not exist
    """
    return _core.read_panorama(_there(path))


def read_png_text(path: str | PathLike[str]) -> dict[str, str]:
    """Read the texts in a PNG by keyword: in our pictures the recipe they can be made from again.

    Raises `InputError` for a file that is no whole PNG.

    >>> import numpy as np
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     pixels = np.zeros((1, 1, 3), np.uint8)
    ...     _core.write_png(f"{folder}/a.png", pixels, "srgb", [("nacreous:seed", "7")])
    ...     read_png_text(f"{folder}/a.png")
    {'nacreous:seed': '7'}
    """
    return dict(_core.read_png_text(_there(path)))


def read_bytes(path: str | PathLike[str], most_mb: int) -> bytes:
    """All that a file holds, or `InputError` where it cannot be read or is larger.

    >>> read_bytes("no such lamp.csv", 1)
    Traceback (most recent call last):
    nacreous.problem.InputError: no such lamp.csv: does not exist
    """
    place = check_ordinary(path)
    try:
        with place.open("rb") as file:
            content = file.read(most_mb * 1_000_000 + 1)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    if len(content) > most_mb * 1_000_000:
        raise InputError(f"{path}: more than {most_mb} MB; allowed: up to {most_mb} MB")
    return content


def read_text(path: str | PathLike[str], most_mb: int) -> str:
    r"""All that a table holds: UTF-16 where it says so, else UTF-8, else Latin-1; lines end in \n.

    >>> read_text("no such lamp.csv", 1)
    Traceback (most recent call last):
    nacreous.problem.InputError: no such lamp.csv: does not exist
    """
    content = read_bytes(path, most_mb)
    marked = content[:2] in (b"\xff\xfe", b"\xfe\xff")
    for encoding in ["utf-16"] if marked else ["utf-8-sig", "latin-1"]:
        try:
            text = content.decode(encoding).replace("\r\n", "\n").replace("\r", "\n")
        except UnicodeDecodeError:
            continue
        # In Latin-1 every byte is a letter, or a control character that no text has.
        if not any(unicodedata.category(letter) == "Cc" for letter in set(text) - set("\t\n\r\f")):
            return text
    raise InputError(f"{path}: not text; allowed: a table in UTF-8, UTF-16 or Latin-1")


def check_ordinary(path: str | PathLike[str]) -> Path:
    """A path at which an ordinary file lies, not a folder, and no pipe, for which one would wait.

    Raises `InputError` otherwise.

    >>> check_ordinary(".")
    Traceback (most recent call last):
    nacreous.problem.InputError: .: is a folder; wanted: a file
    """
    place = named(path)
    try:
        mode = place.stat().st_mode
    except (FileNotFoundError, NotADirectoryError):
        raise missing(path) from None
    except OSError as problem:
        raise InputError(f"{path}: cannot be read: {problem.strerror}") from None
    if stat.S_ISDIR(mode):
        raise InputError(f"{path}: is a folder; wanted: a file")
    if not stat.S_ISREG(mode):
        raise InputError(f"{path}: is no ordinary file; wanted: one")
    return place


def named(path: object) -> Path:
    """A path that a file can have, or one clear message.

    >>> named(None)
    Traceback (most recent call last):
    nacreous.problem.InputError: path is None; allowed: the path of a file
    """
    if not isinstance(path, str | PathLike) or "\0" in os.fspath(path):
        raise InputError(f"path is {said(path)}; allowed: the path of a file")
    return Path(path)


def _same_file(one: str | PathLike[str], other: str | PathLike[str] | int) -> bool:
    """Whether both names lead to one file, which need not be there yet."""
    try:
        known = os.fstat(other) if isinstance(other, int) else Path(other).stat()
        return os.path.samestat(Path(one).stat(), known)
    except (OSError, ValueError):
        return not isinstance(other, int) and os.path.realpath(one) == os.path.realpath(other)


def _there(path: str | PathLike[str]) -> str | PathLike[str]:
    """The path, unless nothing is there."""
    if not os.access(named(path), os.F_OK):  # behind links
        raise missing(path)
    return path


def _target(path: str | PathLike[str]) -> Path:
    """Return the file that a write to `path` concerns, behind all symbolic links."""
    try:
        target = Path(os.path.realpath(path))
        mode = target.stat().st_mode if target.exists() else stat.S_IFREG
    except (OSError, ValueError) as problem:
        raise _unwritable(path, problem) from problem
    if stat.S_ISDIR(mode):
        raise InputError(f"{path}: is a folder; allowed: a file in it, by its name")
    if not stat.S_ISREG(mode):
        # Replacing it would turn, say, /dev/null into a file.
        raise InputError(f"{path}: is not an ordinary file, and cannot be replaced by one")
    return target


def _beside(path: str | PathLike[str], target: Path) -> Path:
    """An unused name, hidden, in the folder of `target`."""
    if not target.parent.is_dir():
        raise InputError(f"{path}: the folder {target.parent} does not exist")
    # The name is short, for the target's own may be as long as names can be.
    return target.with_name(f".nacreous-{os.urandom(4).hex()}{target.suffix[:16]}")


def _create(temporary: Path, mode: int = 0o666) -> None:
    """An empty file, less the umask, as every program creates its files; never over another."""
    os.close(os.open(temporary, os.O_CREAT | os.O_EXCL | os.O_WRONLY, mode))


def _unwritable(path: str | PathLike[str], problem: OSError | ValueError) -> InputError:
    number = problem.errno if isinstance(problem, OSError) else None
    return InputError(f"{path}: cannot be written ({os.strerror(number) if number else problem})")


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__
