"""Records of refractiveindex.info, YAML, into dispersions of n and k."""

from __future__ import annotations

import numpy as np
import yaml

from nacreous.medium.dispersion import COEFFICIENTS, FORMULAS, Dispersion, dispersion_of_rows
from nacreous.medium.number_rows import NumberRow, Parts, numbers_of, row_of
from nacreous.number import said
from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.toml_text import DEEPEST, TooDeepError

_BEGIN = (
    yaml.BlockSequenceStartToken,
    yaml.BlockMappingStartToken,
    yaml.FlowSequenceStartToken,
    yaml.FlowMappingStartToken,
)
_END = (yaml.BlockEndToken, yaml.FlowSequenceEndToken, yaml.FlowMappingEndToken)
_KINDS = "formula 1 to formula 9, tabulated n, tabulated k, tabulated nk"


class _Once(getattr(yaml, "CSafeLoader", yaml.SafeLoader)):  # type: ignore[misc]
    """A safe loader that refuses a key given twice, of which it would keep the last in silence."""

    def construct_mapping(self, node: yaml.MappingNode, deep: bool = False) -> dict[object, object]:
        """A mapping of keys that differ."""
        lines: dict[object, int] = {}
        for key, _ in node.value:
            line = key.start_mark.line + 1
            if isinstance(key, yaml.ScalarNode) and lines.setdefault(key.value, line) != line:
                both = f"lines {lines[key.value]} and {line}"
                raise InputError(f"{printable(key.value)[:60]} is given in {both}; allowed: once")
        made: dict[object, object] = super().construct_mapping(node, deep)
        return made


def parts_of_yaml(text: str) -> tuple[Parts, str]:
    """Dispersions, and where they were published."""
    try:
        _check_depth(text)
        record = yaml.load(text, Loader=_Once)  # noqa: S506
    except InputError:
        raise
    except TooDeepError as problem:
        at = text[: problem.position].count("\n") + 1
        raise InputError(f"line {at}: {problem}") from None
    except (yaml.YAMLError, RecursionError, ValueError) as problem:
        line = getattr(getattr(problem, "problem_mark", None), "line", None)
        place = "" if line is None else f" in line {line + 1}"
        raise InputError(f"no YAML{place}; allowed: a file of refractiveindex.info") from None
    if not isinstance(record, dict):
        held = "a list" if isinstance(record, list) else "no keys"
        raise InputError(f"YAML that holds {held}; allowed: a file of refractiveindex.info")
    entries = record.get("DATA")
    if not isinstance(entries, list):
        raise InputError("DATA is missing; allowed: a file of refractiveindex.info with DATA")
    parts: Parts = {}
    for number, entry in enumerate(entries):
        for name, dispersion in _of_entry(f"DATA[{number}]", entry).items():
            if name in parts:
                raise InputError(f"DATA[{number}] gives {name} again; allowed: once")
            parts[name] = dispersion
    return parts, " ".join(str(record.get("REFERENCES", "")).split())


def _check_depth(text: str) -> None:
    """Refuse what is nested too deeply, before the parser's own calls fill the stack.

    The scanner alone is asked, which calls itself for nothing.
    """
    depth, begun = 0, False
    for token in yaml.scan(text, Loader=_Once):
        if isinstance(token, _BEGIN):
            depth += 1
        elif isinstance(token, _END):
            depth -= 1
        if depth > DEEPEST:
            raise TooDeepError(token.start_mark.index)
        begun |= isinstance(token, (*_BEGIN, yaml.ScalarToken))
        if begun and isinstance(token, yaml.DocumentStartToken):
            line = token.start_mark.line + 1
            raise InputError(
                f"line {line} begins another document (---); allowed: one, a file of "
                "refractiveindex.info"
            )


def _of_entry(place: str, entry: object) -> Parts:
    kind = str(entry.get("type")) if isinstance(entry, dict) else "missing"
    words = kind.split()
    if not isinstance(entry, dict) or len(words) != 2:
        raise InputError(f"{place}: type is {said(kind)}; allowed: {_KINDS}")
    if words[0] == "tabulated" and words[1] in ("n", "k", "nk"):
        lines = (line.split("#")[0] for line in str(entry.get("data", "")).split("\n"))
        cells = filter(None, (line.split() for line in lines))
        numbered = [NumberRow(number, row) for number, row in enumerate(cells, start=1)]
        if not numbered:
            raise InputError(f"{place}: data has no rows; allowed: at least 1")
        rows = numbers_of(f"{place}: data, ", numbered, words[1])
        return {
            name: dispersion_of_rows(1e3 * rows[:, 0], rows[:, 1 + i])
            for i, name in enumerate(words[1])
        }
    if words[0] == "formula" and words[1].isdecimal() and int(words[1]) in FORMULAS:
        return {"n": _of_formula(place, int(words[1]), entry)}
    raise InputError(f"{place}: type is {said(kind)}; allowed: {_KINDS}")


def _of_formula(place: str, formula: int, entry: dict[object, object]) -> Dispersion:
    """Of a formula without half a term: that would give another index and say nothing of it."""
    # Older copies of the database call it `range`.
    within = entry.get("wavelength_range", entry.get("range"))
    if within is None:
        raise InputError(f"{place}: wavelength_range is missing; allowed: two numbers, in um")
    first, last = row_of(f"{place}: wavelength_range", str(within).split(), 2)
    given = entry.get("coefficients")
    cells = [] if given is None else str(given).split()
    coefficients = row_of(f"{place}: coefficients", cells, len(cells))
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
