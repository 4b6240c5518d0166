"""Text in the encodings that spreadsheets and programs of experiments write, as UTF-8.

What could be read in two ways is refused, and the option named that decides it.
"""

from __future__ import annotations

import codecs
import re

from nacreous.problem import InputError
from nacreous.scaling.data.fault import nearest
from nacreous.scaling.data.packed import packed

#: Encodings that may be named, with Python's name of each.
ENCODINGS = {
    "utf-8": "utf-8-sig",
    "utf-16": "utf-16",
    "utf-32": "utf-32",
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
#: Other names for them, as programs and the Internet's registry have them.
_ALIASES = {
    "utf8": "utf-8",
    "utf-8-sig": "utf-8",
    "utf16": "utf-16",
    "utf32": "utf-32",
    "sjis": "shift-jis",
    "ms932": "shift-jis",
    "windows-31j": "shift-jis",
    "cp932": "shift-jis",
    "cp1250": "windows-1250",
    "cp1251": "windows-1251",
    "cp1252": "windows-1252",
    "ansi": "windows-1252",
    "latin1": "latin-1",
    "iso-8859-1": "latin-1",
    "macintosh": "mac-roman",
    "macroman": "mac-roman",
    "gbk": "gb18030",
    "gb2312": "gb18030",
}

#: The encoding that is told by what the text would be in it, and by nothing else.
_GUESS = "Shift-JIS"
_MARKS = (
    (codecs.BOM_UTF8, "utf-8-sig", "UTF-8"),
    (codecs.BOM_UTF32_LE, "utf-32", "UTF-32"),  # begins as UTF-16 does, so it is asked first
    (codecs.BOM_UTF32_BE, "utf-32", "UTF-32"),
    (codecs.BOM_UTF16_LE, "utf-16", "UTF-16"),
    (codecs.BOM_UTF16_BE, "utf-16", "UTF-16"),
)
#: How ISO-2022-JP changes to kanji; its bytes are ASCII with escapes, which no table holds.
_TO_KANJI = (b"\x1b$B", b"\x1b$@")
#: Texts that are no tables, by how they begin, in small letters.
_OTHERS = {
    "a web page or XML": (b"<!doctype", b"<html", b"<?xml"),
    "JSON": (b"[{", b'{"', b"[["),
}

#: What Western European text holds beyond ASCII, as Windows-1252 writes it. Japanese in Shift-JIS,
#: read so, holds other characters nearly always, such as the U+0192 and U+201A before each kana.
_WESTERN = {chr(code) for code in range(0xA0, 0x100)} - set("¤¦¨¬¯¶¸") | set("ŒœŠšŽžŸ‘’“”–—…€•™")


#: What is not ASCII, with the letters right before and behind it.
_IN_A_WORD = re.compile(r"(?:(?<=([A-Za-z]))|(?<![A-Za-z]))([^\x00-\x7f]+)(?=([a-z]?))")


def utf8_of(place: str, content: bytes, encoding: str | None = None) -> bytes:
    """The content as UTF-8 without a mark at its beginning.

    encoding: a key of `ENCODINGS`. Without, a byte order mark decides, then the zeros of UTF-16,
    then UTF-8, then Shift-JIS where Western European text would make no sense. Raises `InputError`
    for everything else, for NUL characters, and for workbooks and packed files.
    """
    if other := packed(content):
        raise InputError(f"{place}: is {other[0]}; allowed: a table as text {other[1]}")
    name, shown = _encoding(place, content, encoding)
    shown = shown.upper() if shown.startswith("utf") else shown
    # A line of names has commas in it, or tabs.
    if name.startswith(("utf-16", "utf-32")) and b"\0" not in content:
        raise InputError(f"{place}: is not {shown} text; allowed: {shown}, as was said or marked")
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


def guessed_encoding(content: bytes) -> str | None:
    """The encoding as which `utf8_of` reads this, where nothing in it says so; else None.

    >>> guessed_encoding("光沢,巻き".encode("cp932")), guessed_encoding("光沢,巻き".encode())
    ('Shift-JIS', None)
    """
    try:
        _, shown = _encoding("", content, None)
    except InputError:
        return None
    return shown if shown == _GUESS else None


def _encoding(place: str, content: bytes, given: str | None) -> tuple[str, str]:
    """Python's name of the encoding, and the one to be shown."""
    if given is not None:
        known = str(given).lower().replace("_", "-")
        known = _ALIASES.get(known, known)
        if known not in ENCODINGS:
            near = nearest(known, ENCODINGS)
            hint = f"did you mean {near}?" if near else f"allowed: {', '.join(ENCODINGS)}"
            raise InputError(f"encoding is {str(given)!a}; {hint}")
        return _ordered(content, ENCODINGS[known]), known
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
            return "cp932", _GUESS
        raise InputError(_undecoded(place, content, problem, "UTF-8")) from problem
    return "utf-8", "UTF-8"


def _ordered(content: bytes, name: str) -> str:
    """UTF-16 and UTF-32 in the order of their bytes, where no mark says it."""
    if name not in ("utf-16", "utf-32") or any(content.startswith(mark) for mark, *_ in _MARKS):
        return name
    size = 2 if name == "utf-16" else 4
    lead = [content[at:64:size].count(0) for at in (0, size - 1)]
    return f"{name}-be" if lead[0] > lead[1] else f"{name}-le"


def _of_zeros(place: str, content: bytes) -> tuple[str, str]:
    """UTF-16 or UTF-32 without a mark: of each letter of a line of names all but one byte is 0."""
    begin = content[:64]
    for name, zeros in (("utf-32-le", (2, 3)), ("utf-32-be", (0, 1))):
        if len(content) % 4 == 0 and not any(any(begin[at::4]) for at in zeros):
            return name, "UTF-32"
    if begin[1::2].count(0) > len(begin) // 4 and 0 not in begin[0::2]:
        return "utf-16-le", "UTF-16"
    if begin[0::2].count(0) > len(begin) // 4 and 0 not in begin[1::2]:
        return "utf-16-be", "UTF-16"
    wide = [name for name in ("utf-16-le", "utf-16-be") if _is_table_in(name, content)]
    if len(wide) == 1:
        return wide[0], "UTF-16"
    try:
        content.decode("utf-8")
    except UnicodeDecodeError:
        raise InputError(f"{place}: is no text; allowed: a table as CSV") from None
    return "utf-8", "UTF-8"


def _is_table_in(name: str, content: bytes) -> bool:
    """Whether these bytes are lines with separators in them, as names in Japanese are too.

    In the other order of bytes there are neither.
    """
    try:
        text = content.decode(name)
    except UnicodeDecodeError:
        return False
    line = re.split("[\r\n]", text.lstrip("\r\n"), maxsplit=1)
    return len(line) > 1 and "\0" not in text and any(mark in line[0] for mark in ",;\t|")


def _is_shift_jis(content: bytes) -> bool:
    """Whether this is Japanese, and neither Western European text nor half-width kana.

    Half-width kana are single bytes, which any other encoding has as well. A letter with an accent
    takes the one behind it with it: of Mac Roman's Hélène and Éclat H四熟e and ツlat are left.
    """
    try:
        japanese = content.decode("cp932")
    except UnicodeDecodeError:
        return False
    if any("\uff61" <= letter <= "\uff9f" or "\ue000" <= letter <= "\uf8ff" for letter in japanese):
        return False
    runs = list(_IN_A_WORD.finditer(japanese))
    beside = any(run[1] or run[3] for run in runs)
    if any(run[1] and run[3] for run in runs) or (beside and not any(map(_is_sure, runs))):
        return False
    western = content.decode("cp1252", errors="replace")
    return not {letter for letter in western if not letter.isascii()} <= _WESTERN


def _is_sure(run: re.Match[str]) -> bool:
    """Whether accents hardly make this: hiragana, three letters, or two away from Latin ones."""
    hiragana = any("\u3041" <= letter <= "\u3096" for letter in run[2])
    return hiragana or len(run[2]) > (2 if run[1] or run[3] else 1)


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
