"""The declarations of pearl and scene keys as the viewer reads them, and the types of whole specs.

The viewer checks files in the browser by the very declarations that the command line has. What a
JSON Schema does not say goes beside it: the endings of keys that name files, which keys may stay
open, the checks in code that a text passes, and which tables have rules between their keys.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, get_args, get_origin

from pydantic import AfterValidator, BaseModel, BeforeValidator
from pydantic.fields import FieldInfo

from nacreous.spec import Pearl, Scene, json_schema
from nacreous.spec.key import FilePath, every_key
from nacreous.spec.section import Section

#: The largest whole number that every number of a browser holds exactly.
_EXACT = 2**53 - 1
#: What runs code of ours on a value; the viewer has the same by the function's name.
_CHECKS = (AfterValidator, BeforeValidator)


def tables() -> dict[str, Any]:
    """The JSON Schema of every table of pearl and scene files, by its class's name."""
    found: dict[str, Any] = {}
    for model in (Pearl, Scene):
        schema = json_schema(model)
        inner = schema.pop("$defs", {})
        del schema["$schema"]
        for name, table in {**inner, model.__name__: schema}.items():
            if found.setdefault(name, table) != table:
                raise ValueError(f"{name} means two things")
    return {name: found[name] for name in sorted(found)}


def declared() -> dict[str, Any]:
    """The tables with what else the viewer needs, without sources and repeated phrases."""
    models = _models()
    return {name: _table(table, models[name]) for name, table in tables().items()}


def complete() -> dict[str, Any]:
    """The JSON Schema of specs in which every key stands, with null where it is open."""
    models = _models()
    made = {name: _whole(table, models[name]) for name, table in tables().items()}
    return {"$defs": made}


def _models() -> dict[str, type[BaseModel]]:
    found: dict[str, type[BaseModel]] = {"Pearl": Pearl, "Scene": Scene}
    for model in (Pearl, Scene):
        found.update({key.owner.__name__: key.owner for key in every_key(model)})
    return found


def _table(table: dict[str, Any], model: type[BaseModel]) -> dict[str, Any]:
    keys = table["properties"]
    return {
        "keys": {name: _key(keys[name], field) for name, field in model.model_fields.items()},
        "ruled": getattr(model, "contradictions", None) is not Section.contradictions,
    }


def _key(schema: dict[str, Any], field: FieldInfo) -> dict[str, Any]:
    """A key's schema with its meaning alone, its default in full, and what a schema leaves out."""
    made = {name: _exact(part) for name, part in schema.items() if name != "description"}
    meaning = schema["description"].partition(" Allowed: ")[0]
    made["meaning"] = meaning.partition(" Only with model")[0]
    if is_open(field):
        made["open"] = True
    marks = list(_marks(field))
    if files := [
        ending for mark in marks if isinstance(mark, FilePath) for ending in mark.suffixes
    ]:
        made["files"] = files
    if checks := [mark.func.__name__ for mark in marks if isinstance(mark, _CHECKS)]:
        made["checks"] = checks
    # The schema forgets it behind a check that comes first.
    for pattern in (found for mark in marks if (found := getattr(mark, "pattern", None))):
        made["pattern"] = pattern
    return made


def _exact(part: Any) -> Any:
    """A bound beyond what every number of a browser holds, as text."""
    return str(part) if isinstance(part, int) and abs(part) > _EXACT else part


def is_open(field: FieldInfo) -> bool:
    """Whether the key may be without a value, which is then found elsewhere.

    >>> is_open(Pearl.model_fields["depth"]), is_open(Scene.model_fields["pitch_mm"])
    (False, True)
    """
    return field.default is None


def _marks(field: FieldInfo) -> Iterator[Any]:
    """What is annotated to a key, to the kinds of value that it may have, and to their items."""
    yield from field.metadata
    yield from _inside(field.annotation)


def _inside(annotation: Any) -> Iterator[Any]:
    if get_origin(annotation) is Annotated:
        yield from annotation.__metadata__
    for part in get_args(annotation):
        yield from _inside(part)


def _whole(table: dict[str, Any], model: type[BaseModel]) -> dict[str, Any]:
    fields = model.model_fields
    keys = {
        name: _nullable(_bare(key), is_open(fields[name]))
        for name, key in table["properties"].items()
    }
    other = {name for name, key in table["properties"].items() if "model" in key}
    return {
        "type": "object",
        "title": table["title"],
        "properties": keys,
        "required": [name for name in keys if name not in other],
        "additionalProperties": False,
    }


def _nullable(schema: dict[str, Any], can_be_open: bool) -> dict[str, Any]:
    return {"anyOf": [schema, {"type": "null"}]} if can_be_open else schema


def _bare(schema: Any) -> Any:
    """A schema's types alone; a whole number that a browser's number may not hold has two."""
    if isinstance(schema, list):
        return [_bare(part) for part in schema]
    if not isinstance(schema, dict):
        return schema
    if schema.get("type") == "integer" and schema.get("maximum", 0) > _EXACT:
        return {"tsType": "number | bigint"}
    kept = (
        "$ref",
        "type",
        "enum",
        "anyOf",
        "oneOf",
        "items",
        "prefixItems",
        "minItems",
        "maxItems",
    )
    return {name: _bare(schema[name]) for name in kept if name in schema}
