"""Workbooks and packed files in place of a table, by how they begin or by their ending."""

from __future__ import annotations

#: By how a file begins what it is, and what makes a table of it.
_UNPACK = "(unpack it first)"
_SAVE = "(save it as CSV UTF-8)"
_BEGIN = {
    b"\xd0\xcf\x11\xe0": ("a workbook", _SAVE),
    b"\x1f\x8b": ("packed by gzip", _UNPACK),
    b"BZh91AY": ("packed by bzip2", _UNPACK),
    b"\xfd7zXZ\0": ("packed by xz", _UNPACK),
    b"\x28\xb5\x2f\xfd": ("packed by zstd", _UNPACK),
    b"7z\xbc\xaf": ("packed by 7-Zip", _UNPACK),
    b"Rar!\x1a\x07": ("packed by RAR", _UNPACK),
}
_ZIP = b"PK\x03\x04"
#: How the name of the first file in a ZIP ends; workbooks are ZIPs too, of other files.
_TABLES = (b".csv", b".tsv", b".txt", b".parquet", b"/")
_OF_WORKBOOKS = (b"xl/", b"_rels/", b"docprops/")

_ENDINGS = {
    _UNPACK: (".gz", ".zip", ".bz2", ".xz", ".zst", ".7z", ".rar", ".tar", ".tgz"),
    _SAVE: (".xlsx", ".xls", ".xlsm", ".xlsb", ".ods", ".numbers"),
    "(export it as CSV)": (".sav", ".zsav", ".dta", ".rds", ".rdata", ".sas7bdat", ".mat"),
}


def packed(content: bytes) -> tuple[str, str] | None:
    """What a workbook or a packed file is, and what makes a table of it; None of any other.

    >>> packed(bytes.fromhex("1f8b08"))
    ('packed by gzip', '(unpack it first)')
    """
    if content.startswith(_ZIP):
        length = int.from_bytes(content[26:28], "little")
        name = content[30 : 30 + length].lower()
        table = name.endswith(_TABLES) and not name.startswith(_OF_WORKBOOKS)
        return ("packed as ZIP", _UNPACK) if table else ("a workbook", _SAVE)
    return next((said for begin, said in _BEGIN.items() if content.startswith(begin)), None)


def advice(ending: str) -> str:
    """What makes a table of a file with this ending, with a blank before it; "" where unknown.

    >>> advice(".xlsx"), advice(".pdf")
    (' (save it as CSV UTF-8)', '')
    """
    found = (said for said, endings in _ENDINGS.items() if ending.lower() in endings)
    return "".join(f" {said}" for said in found)
