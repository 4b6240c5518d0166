"""Complaints: what pydantic found, said in one plain line for each problem.

`pearl.toml: nacre.protein_nm is -3; allowed: 0 to 200 nm`
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator, Mapping
from difflib import get_close_matches
from typing import Any, Literal, NamedTuple, get_args, get_origin

from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails

from nacreous.printable import printable
from nacreous.spec.key import alternatives, every_key, is_list, sections_in

#: A list of 5000 bad numbers is one mistake, not 5000.
MOST_LINES = 20


class Contradiction(NamedTuple):
    """Two keys of one section that cannot both be right.

    `{other}` in the verdict stands for the other key, which is then named with its full path.
    """

    key: str
    verdict: str
    other: str = ""


def complaints(
    error: ValidationError,
    model: type[BaseModel],
    values: Mapping[str, Any],
    place: Callable[[str], str],
) -> list[str]:
    """One line for each problem of `values`: place, key, value and what is allowed.

    `place` gives, for a dotted key, the words in front: the file's name, or `--set`.
    """
    verdicts: dict[str, str] = {}
    for detail in error.errors(include_url=False):
        for path, verdict in _verdicts(detail, model, values):
            verdicts.setdefault(path, verdict)
    # A list without one good entry also counts as empty: its entries say enough.
    lists = {path.rpartition(".")[0] for path in verdicts}
    found = [
        f"{place(path)}: {path} {verdict}"
        for path, verdict in verdicts.items()
        if path not in lists
    ]
    if len(found) > MOST_LINES:
        found[MOST_LINES:] = [f"... and {len(found) - MOST_LINES} more problems"]
    return found


def nearest(word: str, choices: list[str]) -> str | None:
    """The choice that a mistyped word most probably meant, or None.

    >>> nearest("protien_nm", ["protein_nm", "protein", "seed"])
    'protein_nm'
    """
    by_lower = {choice.lower(): choice for choice in choices}
    close = get_close_matches(word.lower(), list(by_lower), n=1, cutoff=0.6)
    return by_lower[close[0]] if close else None


def shown(value: Any, longest: int = 60) -> str:
    r"""A value as it would stand in the file, on one line and never long.

    >>> shown(True), shown("a\nb"), shown([1.5, 2]), shown({"a": 1}), shown(float("nan"))
    ('true', '"a\\nb"', '[1.5, 2]', 'a table', 'nan')
    """
    if value is None:
        return "nothing"
    if isinstance(value, Mapping | BaseModel):
        return "a table"
    if isinstance(value, list | tuple):
        text = "[" + ", ".join(shown(item) for item in value[:longest]) + "]"
        return text if len(text) <= longest else f"a list of {len(value)}"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        value = value if len(value) <= longest else value[: longest - 3] + "..."
        return printable(json.dumps(value, ensure_ascii=False))
    try:
        text = str(value)
    except ValueError:  # a whole number of more digits than Python agrees to print
        return "a number of thousands of digits"
    return printable(text if len(text) <= longest else text[: longest - 3] + "...")


def shown_key(key: str) -> str:
    """A key as it would stand in the file: bare where it can be."""
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else shown(key)


class _Place(NamedTuple):
    """Where a problem lies: the key's path, its declaration, and the sections it stands in."""

    path: list[str | int]
    field: FieldInfo
    owners: tuple[type[BaseModel], ...]

    @property
    def dotted(self) -> str:
        return ".".join(str(part) for part in self.path)


def _locate(model: type[BaseModel], loc: tuple[int | str, ...]) -> _Place:
    """Follow pydantic's location through the sections, without its marks for kinds of value."""
    path: list[str | int] = []
    field = FieldInfo(annotation=model)  # the file as a whole
    owners: tuple[type[BaseModel], ...] = (model,)
    for part in loc:
        chosen = tuple(owner for owner in owners if owner.__name__.lower() == str(part).lower())
        if chosen:
            owners = chosen
        elif isinstance(part, int) and is_list(field.annotation):
            path.append(part)  # the numbers of a pair or a triple are shown together
        elif owners and part in owners[0].model_fields:
            field = owners[0].model_fields[part]
            owners = sections_in(field.annotation)
            path.append(part)
        else:
            break
    return _Place(path, field, owners)


def _verdicts(
    detail: ErrorDetails, model: type[BaseModel], values: Mapping[str, Any]
) -> Iterator[tuple[str, str]]:
    """Each key that a problem concerns, and what is wrong with it."""
    loc = detail["loc"]
    if detail["type"] == "extra_forbidden":
        at = _locate(model, loc[:-1])
        unknown = str(loc[-1])
        prefix = f"{at.dotted}." if at.path else ""
        yield prefix + shown_key(unknown), _unknown_key(unknown, at.owners[0], model)
        return
    at = _locate(model, loc)
    if detail["type"] == "contradiction":
        prefix = f"{at.dotted}." if at.path else ""
        for key, verdict, other in detail["ctx"]["found"]:
            yield prefix + key, verdict.replace("{other}", prefix + other)
    elif detail["type"] == "missing" and loc[-1:] == tuple(at.path[-1:]):  # no item of a triple
        yield at.dotted, f"is missing; allowed: {_allowed(at.field)}"
    else:
        yield at.dotted, _bad_value(_value_at(values, at.path, detail["input"]), at)


def _value_at(values: Any, path: list[str | int], otherwise: Any) -> Any:
    """The value as it was given; pydantic's own record of it may be only a part."""
    for part in path:
        try:
            values = getattr(values, str(part)) if isinstance(values, BaseModel) else values[part]
        except (KeyError, IndexError, TypeError, AttributeError):
            return otherwise
    return values


def _unknown_key(unknown: str, owner: type[BaseModel], model: type[BaseModel]) -> str:
    here = list(owner.model_fields)
    near = nearest(unknown, here)
    if near is None:  # right word, wrong table?
        elsewhere = {every.path.rpartition(".")[2]: every.path for every in every_key(model)}
        near = elsewhere.get(unknown)
    hint = f"did you mean {near}?" if near else f"keys here: {', '.join(here)}"
    return f"is not a key here; {hint}"


def _bad_value(value: Any, at: _Place) -> str:
    annotation = at.field.annotation
    inside_list = is_list(annotation) and isinstance(at.path[-1], int)
    kinds = alternatives(annotation)
    if inside_list:
        kinds = alternatives(get_args(kinds[0])[0])
    words = [f"is {shown(value)}"]
    if not any(_fits(value, kind) for kind in kinds):
        words.append(f"wanted: {' or '.join(dict.fromkeys(_in_words(kind) for kind in kinds))}")
    if not (inside_list and sections_in(annotation)) and _has_range(at.field):
        words.append(f"allowed: {_allowed(at.field)}")
    choices = [*(at.field.examples or []), *(arg for kind in kinds for arg in get_args(kind))]
    texts = [choice for choice in choices if isinstance(choice, str)]
    near = nearest(value, texts) if isinstance(value, str) else None
    if near:
        words.append(f'did you mean "{near}"?')
    return "; ".join(words)


def _has_range(field: FieldInfo) -> bool:
    """Whether the key has a value of its own, and is not a table alone."""
    return isinstance(field.json_schema_extra, dict) and "allowed" in field.json_schema_extra


def _allowed(field: FieldInfo) -> str:
    extra = field.json_schema_extra
    allowed = extra.get("allowed") if isinstance(extra, dict) else None
    return str(allowed or "a table of keys")


def _in_words(kind: Any) -> str:
    if kind is float:
        return "a number"
    if kind is int:
        return "a whole number"
    if get_origin(kind) is tuple:
        return f"a list of {_entries(kind)}"
    return "text in quotes" if kind is str or get_origin(kind) is Literal else "a table of keys"


def _entries(kind: Any) -> str:
    if sections_in(kind):
        return "tables"
    return "texts" if alternatives(get_args(kind)[0]) == (str,) else "numbers"


def _fits(value: Any, kind: Any) -> bool:
    """Whether the value is of the right kind at all, so that only its size is wrong."""
    if kind is float:
        return isinstance(value, int | float) and not isinstance(value, bool)
    if kind is int:
        return isinstance(value, int) and not isinstance(value, bool)
    if get_origin(kind) is tuple:
        return isinstance(value, list | tuple)
    if kind is str or get_origin(kind) is Literal:
        return isinstance(value, str)
    return isinstance(value, Mapping | BaseModel)
