"""The wire as one JSON Schema, from which the pages' TypeScript is made."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from nacreous.server.app import without_study

__all__ = ["wire_schema"]

#: What a page makes of a response without JSON, as json-schema-to-typescript is told a type.
_NOTHING, _BYTES = {"tsType": "undefined"}, {"tsType": "Blob"}


def wire_schema() -> dict[str, Any]:
    """Every body and response by its name, and `Routes`: which route takes and tells which.

    >>> wire_schema()["$defs"]["Routes"]["properties"]["POST /api/screen"]["properties"]
    {'body': {'$ref': '#/$defs/Checking'}, 'told': {'$ref': '#/$defs/ScreenTold'}}
    """
    described = without_study().openapi()
    routes = {
        f"{method.upper()} {path}": _route(operation)
        for path, operations in described["paths"].items()
        for method, operation in operations.items()
    }
    schemas = described["components"]["schemas"]
    defined = {name: _plain(schemas[name]) for name in sorted(schemas)}
    meaning = "What each route takes and tells."
    return {"$defs": {**defined, "Routes": {"description": meaning, **_table(routes)}}}


def _route(operation: Mapping[str, Any]) -> dict[str, Any]:
    body = operation.get("requestBody", {}).get("content", {}).get("application/json")
    told = next(told for status, told in operation["responses"].items() if status.startswith("2"))
    content = told.get("content", {})
    json = content.get("application/json")
    otherwise = _BYTES if content else _NOTHING
    made = _table(
        {
            "body": _NOTHING if body is None else _plain(body["schema"]),
            "told": otherwise if json is None else _plain(json["schema"]),
        }
    )
    return {"description": operation["description"], **made}


def _table(properties: Mapping[str, Any]) -> dict[str, Any]:
    return {
        "type": "object",
        "properties": dict(properties),
        "required": list(properties),
        "additionalProperties": False,
    }


def _plain(schema: Any) -> Any:
    """A schema as our pages need it: no made-up titles, no examples in Python, no unknown keys.

    The server keeps keys of a screen check that it does not know; a page that sends one has made a
    slip.
    """
    if isinstance(schema, list):
        return [_plain(one) for one in schema]
    if not isinstance(schema, dict):
        return schema
    made = {key: _plain(value) for key, value in schema.items()}
    if isinstance(made.get("title"), str):
        del made["title"]
    if isinstance(made.get("description"), str):
        made["description"] = made["description"].partition("\n\n>>>")[0]
    if "$ref" in made:
        made["$ref"] = made["$ref"].replace("#/components/schemas/", "#/$defs/")
    if "properties" in made and "type" in made:
        made["additionalProperties"] = False
    return made
