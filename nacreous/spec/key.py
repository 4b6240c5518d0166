"""One key of a pearl or scene file: how it is declared, and how all keys of a file are found.

A key is declared once, with its range and its source. The JSON Schema, the messages about bad
values and the tests are all made from that one declaration, so they cannot disagree.
"""

from __future__ import annotations

import types
from collections.abc import Iterator
from typing import Annotated, Any, NamedTuple, Union, get_args, get_origin

from pydantic import BaseModel, Field
from pydantic.fields import FieldInfo


class FilePath(NamedTuple):
    """Marks a text key that may name a file; such a path is relative to the file it stands in."""

    suffixes: tuple[str, ...]

    def names_file(self, text: str) -> bool:
        """Whether the text is a path, and not one of the key's other words.

        >>> FilePath((".csv",)).names_file("lamp.CSV"), FilePath((".csv",)).names_file("D65")
        (True, False)
        """
        return text.lower().endswith(self.suffixes)


def key(
    default: Any,
    meaning: str,
    *,
    allowed: str,
    source: str,
    left_out: str = "",
    unit: str = "",
    model: str = "",
    **constraints: Any,
) -> Any:
    """Declare a key of a section: the value it has when left out, its meaning, range and source.

    `allowed` is the phrase that both the schema and every complaint about the key use. `left_out`
    says where the value comes from when the default is None. `model` names the only model that has
    the key. `constraints` are pydantic's.
    """
    sentences = [meaning, f"Allowed: {allowed}.", f"Source: {source}."]
    if left_out:
        sentences.insert(2, f"Left out: {left_out}.")
    extra = {"allowed": allowed, "unit": unit, "model": model}
    return Field(
        default,
        description=" ".join([*sentences, *_belonging(model)]),
        json_schema_extra={name: text for name, text in extra.items() if text},
        **constraints,
    )


def _belonging(model: str) -> list[str]:
    return [f'Only with model = "{model}".'] if model else []


def quantity(
    default: float | types.EllipsisType | None,
    meaning: str,
    *,
    source: str,
    least: float | None = None,
    above: float | None = None,
    most: float | None = None,
    below: float | None = None,
    unit: str = "",
    left_out: str = "",
    model: str = "",
) -> Any:
    """Declare a number with its unit and range; `above` and `below` exclude the bound itself.

    >>> quantity(20.0, "Protein.", least=0, most=200, unit="nm", source="paper 3.2.1").description
    'Protein. Allowed: 0 to 200 nm. Source: paper 3.2.1.'
    """
    low = f"{_plain(least)}" if least is not None else f"above {_plain(above)}"
    high = f"to {_plain(most)}" if most is not None else f"to below {_plain(below)}"
    allowed = f"{low} {high} {unit}".rstrip()
    return key(
        default,
        meaning,
        allowed=allowed,
        source=source,
        left_out=left_out,
        unit=unit,
        model=model,
        ge=least,
        gt=above,
        le=most,
        lt=below,
    )


def _plain(number: float | None) -> str:
    """A bound as people write it: 1000000 rather than 1e+06."""
    if number is None:
        raise TypeError("a quantity needs a lower and an upper bound")
    return str(int(number)) if number == int(number) else f"{number:g}"


def section(meaning: str, *, optional: bool = False, model: str = "") -> Any:
    """Declare a table of keys; left out, it is as an empty one, or None where it is `optional`.

    `model` names the only model that has the table.
    """
    made: dict[str, Any] = {"description": " ".join([meaning, *_belonging(model)])}
    if model:
        made["json_schema_extra"] = {"model": model}
    # Checked as if it stood in the file: an instance as default would have pydantic build the
    # validator of each table's class, beside the one of the whole file.
    return Field(None, **made) if optional else Field(default_factory=dict, **made)


def alternatives(annotation: Any) -> tuple[Any, ...]:
    """The types a key may have, without None, markers and wrappers.

    >>> alternatives(float | None), alternatives(Annotated[int, "a marker"] | str)
    ((<class 'float'>,), (<class 'int'>, <class 'str'>))
    """
    if get_origin(annotation) is Annotated:
        return alternatives(get_args(annotation)[0])
    if get_origin(annotation) in (Union, types.UnionType):
        return tuple(kind for member in get_args(annotation) for kind in alternatives(member))
    return () if annotation in (None, types.NoneType) else (annotation,)


def sections_in(annotation: Any) -> tuple[type[BaseModel], ...]:
    """The sections a key holds: one, several to choose from, those of a list, or none."""
    found: list[type[BaseModel]] = []
    for kind in alternatives(annotation):
        if get_origin(kind) is tuple:
            found.extend(sections_in(get_args(kind)[0]))
        elif isinstance(kind, type) and issubclass(kind, BaseModel):
            found.append(kind)
    return tuple(found)


def is_list(annotation: Any) -> bool:
    """Whether a key holds a list of any length (and not a pair or a triple)."""
    return any(
        get_origin(kind) is tuple and get_args(kind)[-1] is Ellipsis
        for kind in alternatives(annotation)
    )


class Key(NamedTuple):
    """A key with its place: `nacre.protein_nm` in `Growth`; `lamps.0.intensity` in `Lamp`."""

    path: str
    owner: type[BaseModel]
    field: FieldInfo


def every_key(model: type[BaseModel], prefix: str = "") -> Iterator[Key]:
    """All keys below a model, tables and what they hold, in the order of the file."""
    for name, field in model.model_fields.items():
        path = f"{prefix}{name}"
        yield Key(path, model, field)
        step = "0." if is_list(field.annotation) else ""
        for inner in sections_in(field.annotation):
            yield from every_key(inner, f"{path}.{step}")
