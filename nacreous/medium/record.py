"""Files of refractiveindex.info, YAML and CSV, into dispersions of n and k."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Sequence
from typing import TypeAlias

import numpy as np
import yaml
from numpy.typing import NDArray

from nacreous.medium.dispersion import (
    ALLOWED,
    COEFFICIENTS,
    FORMULAS,
    Dispersion,
    dispersion_of_rows,
    fits,
)
from nacreous.number import said
from nacreous.problem import InputError

#: The dispersion of "n" and that of "k"; one of them may be missing.
Parts: TypeAlias = dict[str, Dispersion]

_KINDS = "formula 1 to formula 9, tabulated n, tabulated k, tabulated nk"


def parts_of_yaml(text: str) -> tuple[Parts, str]:
    """Dispersions, and where they were published."""
    try:
        record = yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))  # noqa: S506
    except (yaml.YAMLError, RecursionError, ValueError) as problem:
        line = getattr(getattr(problem, "problem_mark", None), "line", None)
        place = "" if line is None else f" in line {line + 1}"
        raise InputError(f"no YAML{place}; allowed: a file of refractiveindex.info") from None
    entries = record.get("DATA") if isinstance(record, dict) else None
    if not isinstance(entries, list):
        raise InputError("DATA is missing; allowed: a file of refractiveindex.info with DATA")
    parts: Parts = {}
    for number, entry in enumerate(entries):
        for name, dispersion in _of_entry(f"DATA[{number}]", entry).items():
            if name in parts:
                raise InputError(f"DATA[{number}] gives {name} again; allowed: once")
            parts[name] = dispersion
    return parts, " ".join(str(record.get("REFERENCES", "")).split())


def _of_entry(place: str, entry: object) -> Parts:
    kind = str(entry.get("type")) if isinstance(entry, dict) else "missing"
    words = kind.split()
    if not isinstance(entry, dict) or len(words) != 2:
        raise InputError(f"{place}: type is {said(kind)}; allowed: {_KINDS}")
    if words[0] == "tabulated" and words[1] in ("n", "k", "nk"):
        lines = (line.split("#")[0] for line in str(entry.get("data", "")).split("\n"))
        rows = _numbers(f"{place}: data", (line.split() for line in lines), words[1])
        return {
            name: dispersion_of_rows(1e3 * rows[:, 0], rows[:, 1 + i])
            for i, name in enumerate(words[1])
        }
    if words[0] == "formula" and words[1].isdecimal() and int(words[1]) in FORMULAS:
        return {"n": _of_formula(place, int(words[1]), entry)}
    raise InputError(f"{place}: type is {said(kind)}; allowed: {_KINDS}")


def _of_formula(place: str, formula: int, entry: dict[object, object]) -> Dispersion:
    """Of a formula without half a term: that would give another index and say nothing of it."""
    first, last = _row(f"{place}: wavelength_range", str(entry.get("wavelength_range")).split(), 2)
    given = entry.get("coefficients")
    cells = [] if given is None else str(given).split()
    coefficients = _row(f"{place}: coefficients", cells, len(cells))
    *others, most = COEFFICIENTS[formula]
    if len(cells) not in (*others, most):
        has = f"formula {formula} has {len(cells)} coefficient{'s' * (len(cells) != 1)}"
        allowed = f"{', '.join(map(str, others))} or {most}"
        raise InputError(f"{place}: {has}; allowed: {allowed}")
    if not 0 < first < last:
        raise InputError(
            f"{place}: wavelength_range is {first:g} to {last:g}; allowed: rising, above 0"
        )
    return Dispersion(formula, np.array([1e3 * first, 1e3 * last]), np.array(coefficients))


def parts_of_csv(text: str) -> Parts:
    """Blocks of rows, each below its header `wl,n`, `wl,k` or `wl,n,k`; wavelengths in um.

    Without a header two columns are n, three are n and k. A header that says nm is believed.
    Columns are parted by tabs, semicolons, commas or blanks; between tabs and semicolons decimals
    may have commas. `#` begins a comment.
    """
    columns: list[str] | None = None
    blocks: list[tuple[list[str], float, list[list[str]]]] = []
    for row in _rows(text):
        if not _is_float(row[0]):
            columns = [cell.lower() for cell in row[1:]]
            blocks.append((columns, _nm_per_unit(row[0]), []))
        else:
            if not blocks:
                blocks.append((["n", "k"][: max(1, len(row) - 1)], 1e3, []))
            blocks[-1][2].append(row)
    parts: Parts = {}
    for columns, nm_per_unit, lines in blocks:
        if not columns or any(name not in ("n", "k") for name in columns):
            raise InputError(f"columns are {said(columns)}; allowed: wl, then n, k or both")
        rows = _numbers("rows", lines, columns)
        for i, name in enumerate(columns):
            if name in parts:
                raise InputError(f"{name} is given twice; allowed: once")
            parts[name] = dispersion_of_rows(nm_per_unit * rows[:, 0], rows[:, 1 + i])
    return parts


def _nm_per_unit(head: str) -> float:
    """Of the first column's name: micrometres unless it says nanometres; no other unit."""
    words = re.findall(r"[^\W\d_]+", head.lower())
    in_brackets = re.findall(r"[(\[]\s*([^)\]]*?)\s*[)\]]", head.lower())
    if not {*words, *in_brackets} & {"ev", "a", "å", "thz", "hz", "cm", "mm", "energy"}:
        unit = (in_brackets or ["um"])[0]
        if unit in ("nm", "nanometer", "nanometers", "nanometre", "nanometres") or "nm" in words:
            return 1.0
        if unit in ("um", "\u00b5m", "\u03bcm", "micron", "microns") or unit.startswith("micromet"):
            return 1e3
    raise InputError(f"wavelengths are in {said(head)}; allowed: um or nm")


def _rows(text: str) -> list[list[str]]:
    """The cells of each line that has any, decimals with points."""
    lines = [line.split("#")[0].strip() for line in io.StringIO(text, newline=None)]
    separator = next((sign for sign in "\t;," if any(sign in line for line in lines)), " ")
    if separator == " ":
        return [line.split() for line in lines if line]
    try:
        rows = [[cell.strip() for cell in row] for row in csv.reader(lines, delimiter=separator)]
    except csv.Error as problem:
        raise InputError(f"no table ({problem}); allowed: rows of numbers") from None
    for row in rows:
        while row and not row[-1]:
            row.pop()
    pointed = any("." in cell and _is_float(cell) for row in rows for cell in row)
    if separator != "," and not pointed:
        rows = [[_pointed(cell) for cell in row] for row in rows]
    return [row for row in rows if row]


def _pointed(cell: str) -> str:
    """A number with its decimal comma as a point; any other cell as it is."""
    number = cell.replace(",", ".")
    return number if _is_float(number) else cell


def _numbers(place: str, lines: Iterable[list[str]], columns: Sequence[str]) -> NDArray[np.float64]:
    """Rows of a wavelength and what `columns` names, "n" or "k", each."""
    rows = []
    for number, cells in enumerate(filter(None, lines), start=1):
        where = f"{place}, row {number}"
        row = _row(where, cells, len(columns) + 1)
        if row[0] <= 0:
            raise InputError(f"{where} has wavelength {row[0]:g}; allowed: above 0")
        rows.append(row)
    if not rows:
        raise InputError(f"{place} has no rows; allowed: at least 1")
    table = np.array(rows)
    # Some published tables leave the range in a few rows, at absorption edges and by noise around
    # 0: these are refused where they are asked for. One of -k is of the other sign's convention.
    for name, values in zip(columns, table[:, 1:].T, strict=True):
        if not fits(name, values).any():
            raise InputError(
                f"{place}, row 1 has {name} = {values[0]:g}, and no row has {ALLOWED[name]}; "
                f"allowed: {name} {ALLOWED[name]}"
            )
    return table


def _row(place: str, cells: list[str], columns: int) -> list[float]:
    if len(cells) != columns:
        raise InputError(f"{place} has {len(cells)} numbers; allowed: {columns}")
    for cell in cells:
        if not _is_number(cell):
            raise InputError(f"{place} has {said(cell)}; allowed: finite numbers")
    return [_float(cell) for cell in cells]


def _is_number(cell: str) -> bool:
    # Python would also take 1_5 for 15.
    plain = cell.isascii() and "_" not in cell
    return plain and _is_float(cell) and bool(np.isfinite(_float(cell)))


def _is_float(cell: str) -> bool:
    try:
        _float(cell)
    except ValueError:
        return False
    return True


def _float(cell: str) -> float:
    """A number, whose exponent Fortran writes with a D."""
    return float(re.sub("[dD]", "e", cell))
