"""Text in the encodings that spreadsheets and programs of experiments write, as UTF-8.

What could be read in two ways is refused, and the option named that decides it.
"""

from __future__ import annotations

import codecs

from nacreous.problem import InputError
from nacreous.scaling.data.fault import nearest

#: Encodings that may be named, with Python's name of each.
ENCODINGS = {
    "utf-8": "utf-8-sig",
    "utf-16": "utf-16",
    "shift-jis": "cp932",
    "euc-jp": "euc_jp",
    "iso-2022-jp": "iso2022_jp",
    "windows-1250": "cp1250",
    "windows-1251": "cp1251",
    "windows-1252": "cp1252",
    "latin-1": "latin-1",
    "mac-roman": "mac_roman",
    "gb18030": "gb18030",
    "big5": "big5",
    "euc-kr": "euc_kr",
}

_MARKS = (
    (codecs.BOM_UTF8, "utf-8-sig", "UTF-8"),
    (codecs.BOM_UTF32_LE, "utf-32", "UTF-32"),  # begins as UTF-16 does, so it is asked first
    (codecs.BOM_UTF32_BE, "utf-32", "UTF-32"),
    (codecs.BOM_UTF16_LE, "utf-16", "UTF-16"),
    (codecs.BOM_UTF16_BE, "utf-16", "UTF-16"),
)
#: How ISO-2022-JP changes to kanji; its bytes are ASCII with escapes, which no table holds.
_TO_KANJI = (b"\x1b$B", b"\x1b$@")
_WORKBOOKS = (b"PK\x03\x04", b"\xd0\xcf\x11\xe0")

#: Texts that are no tables, by how they begin, in small letters.
_OTHERS = {
    "a web page or XML": (b"<!doctype", b"<html", b"<?xml"),
    "JSON": (b"[{", b'{"', b"[["),
}

#: What Western European text holds beyond ASCII, as Windows-1252 writes it. Japanese in Shift-JIS,
#: read so, holds other characters nearly always, such as the U+0192 and U+201A before each kana.
_WESTERN = {chr(code) for code in range(0xA0, 0x100)} - set("¤¦¨¬¯¶¸") | set("ŒœŠšŽžŸ‘’“”–—…€•™")


def utf8_of(place: str, content: bytes, encoding: str | None = None) -> bytes:
    """The content as UTF-8 without a mark at its beginning.

    encoding: a key of `ENCODINGS`. Without, a byte order mark decides, then the zeros of UTF-16,
    then UTF-8, then Shift-JIS where Western European text would make no sense. Raises `InputError`
    for everything else, for NUL characters, and for workbooks.
    """
    if content.startswith(_WORKBOOKS):
        raise InputError(f"{place}: is a workbook; allowed: a table as text (save it as CSV UTF-8)")
    name, shown = _encoding(place, content, encoding)
    if name == "utf-16" and b"\0" not in content:  # a line of names has commas in it, or tabs
        raise InputError(f"{place}: is not UTF-16 text; allowed: UTF-16, as was said or marked")
    if name == "utf-8" and content.isascii():
        text = content
    else:
        try:
            text = content.decode(name).encode()
        except UnicodeError as problem:
            raise InputError(_undecoded(place, content, problem, shown)) from problem
    begin = text[:200].lstrip(b"\xef\xbb\xbf \t\r\n").lower()
    for kind, marks in _OTHERS.items():
        if begin.startswith(marks):
            raise InputError(f"{place}: is {kind}; allowed: a table as text (save it as CSV)")
    if b"\0" in text:
        line = _line(text, text.index(b"\0"))
        raise InputError(f"{place}: line {line} holds a NUL character; allowed: text (remove it)")
    return text


def _encoding(place: str, content: bytes, given: str | None) -> tuple[str, str]:
    """Python's name of the encoding, and the one to be shown."""
    if given is not None:
        known = str(given).lower().replace("_", "-")
        known = {"utf8": "utf-8", "utf16": "utf-16", "sjis": "shift-jis", "cp932": "shift-jis"}.get(
            known, known
        )
        if known not in ENCODINGS:
            near = nearest(known, ENCODINGS)
            hint = f"did you mean {near}?" if near else f"allowed: {', '.join(ENCODINGS)}"
            raise InputError(f"encoding is {str(given)!a}; {hint}")
        return ENCODINGS[known], known
    for mark, name, shown in _MARKS:
        if content.startswith(mark):
            return name, shown
    if any(mark in content for mark in _TO_KANJI):
        return "iso2022_jp", "ISO-2022-JP"
    if b"\0" in content[:65536]:
        return _of_zeros(place, content)
    try:
        codecs.decode(content, "utf-8")
    except UnicodeDecodeError as problem:
        if _is_shift_jis(content):
            return "cp932", "Shift-JIS"
        raise InputError(_undecoded(place, content, problem, "UTF-8")) from problem
    return "utf-8", "UTF-8"


def _of_zeros(place: str, content: bytes) -> tuple[str, str]:
    """UTF-16 without a mark: every other byte of a line of column names is 0."""
    begin = content[:64]
    if begin[1::2].count(0) > len(begin) // 4 and 0 not in begin[0::2]:
        return "utf-16-le", "UTF-16"
    if begin[0::2].count(0) > len(begin) // 4 and 0 not in begin[1::2]:
        return "utf-16-be", "UTF-16"
    try:
        content.decode("utf-8")
    except UnicodeDecodeError:
        raise InputError(f"{place}: is no text; allowed: a table as CSV") from None
    return "utf-8", "UTF-8"


def _is_shift_jis(content: bytes) -> bool:
    """Whether this is Japanese, and neither Western European text nor half-width kana.

    Half-width kana are single bytes, which any other encoding has as well.
    """
    try:
        japanese = content.decode("cp932")
    except UnicodeDecodeError:
        return False
    if any("\uff61" <= letter <= "\uff9f" or "\ue000" <= letter <= "\uf8ff" for letter in japanese):
        return False
    western = content.decode("cp1252", errors="replace")
    return not {letter for letter in western if not letter.isascii()} <= _WESTERN


def _undecoded(place: str, content: bytes, problem: UnicodeError, shown: str) -> str:
    at = problem.start if isinstance(problem, UnicodeDecodeError) else 0
    line = _line(content, at)
    if shown != "UTF-8":
        return f"{place}: line {line} is not {shown} text; allowed: {shown}, as was said or marked"
    return (
        f"{place}: line {line} is not UTF-8 text; allowed: UTF-8 (save it as such), or name its "
        "encoding, such as encoding='windows-1252' or 'shift-jis'"
    )


def _line(content: bytes, position: int) -> int:
    before = content[:position].replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    return before.count(b"\n") + 1
