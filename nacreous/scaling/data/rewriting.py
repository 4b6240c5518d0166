"""Labels that are likely one: read in a wrong encoding, escaped, or a path of another system."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from html import unescape
from unicodedata import normalize
from urllib.parse import unquote

from nacreous.problem import InputError
from nacreous.scaling.data.fault import quoted

#: As what a text's bytes were read, and what they are. Of two encodings with one byte a letter
#: either reading may be meant.
_READ_AS = (
    *(("cp1252", "utf-8"), ("latin-1", "utf-8"), ("cp932", "utf-8"), ("mac_roman", "utf-8")),
    *(("cp850", "utf-8"), ("cp437", "utf-8"), ("cp1252", "cp932"), ("mac_roman", "cp932")),
)
#: Names of files, whose endings Windows and cameras write in capitals.
_FILE = re.compile(
    r"(.+\.)(png|jpe?g|gif|bmp|webp|avif|svg|tiff?|heic|exr|hdr|raw|pdf|mp4|mov|webm|avi|wav|mp3)",
    re.IGNORECASE | re.DOTALL,
)
#: What stands for a letter that an encoding does not have.
_LOST = "?\ufffd"


def check_rewritten(labels: Iterable[str], place: str) -> None:
    """Refuse a label beside what a program makes of it in another encoding, in addresses or paths.

    >>> check_rewritten(["weiß", "weiÃŸ"], "stimuli")
    Traceback (most recent call last):
    nacreous.problem.InputError: stimuli: "weiß" and "weiÃŸ" are likely one label, ...
    """
    known = dict.fromkeys(labels)
    paths: dict[str, str] = {}
    whole = {_with_lost(label): label for label in known if not _has_lost(label)}
    for label in known:
        for text, how in _readings(label):
            if text != label and text in known:
                raise _likely_one(place, text, label, f"label, the second {how}")
        same = paths.setdefault(_path(label), label)
        if same != label:
            raise _likely_one(place, same, label, "file")
        if _has_lost(label) and (other := whole.get(_with_lost(label))):
            raise _likely_one(place, other, label, "label, the second with letters lost")


def _likely_one(place: str, one: str, other: str, thing: str) -> InputError:
    return InputError(
        f"{place}: {quoted(one)} and {quoted(other)} are likely one {thing}; allowed: one way of "
        "writing it"
    )


def _readings(label: str) -> Iterator[tuple[str, str]]:
    """What the label may have been, and what was done to it."""
    if "&" in label:
        yield _as_label(unescape(label)), "as web pages escape it"
    if "%" in label:
        yield _as_label(unquote(label)), "as web addresses escape it"
    if label.isascii():
        return
    for wrong, right in _READ_AS:
        for text in (label, f"{label}\u00a0"):  # whose end counts as space, and is left out
            try:
                yield _as_label(text.encode(wrong).decode(right)), "read in a wrong encoding"
            except UnicodeError:
                continue


def _as_label(text: str) -> str:
    return normalize("NFC", text.strip())


def _path(label: str) -> str:
    """A path as it is on every system, its ending in small letters."""
    path = label.replace("\\", "/").removeprefix("./")
    file = _FILE.fullmatch(path)
    return file[1] + file[2].lower() if file else path


def _has_lost(label: str) -> bool:
    return any(letter in label for letter in _LOST)


def _with_lost(label: str) -> str:
    """The label with ? for every letter that ASCII does not have."""
    return label.encode("ascii", errors="replace").decode("ascii")
