"""The JSON Schemas behind the pages' TypeScript; prints them as JSON, by the name of the file.

`./just types` hands them to typescript.mjs beside this file. Each goes with its SHA-256, which
the TypeScript then bears, so that a test sees without Node.js whether it is current.
"""

from __future__ import annotations

import hashlib
import json
import sys
from typing import Any

from nacreous.server.wire import wire_schema
from nacreous.spec import Pearl, Scene, json_schema


def schemas() -> dict[str, dict[str, Any]]:
    """A schema for each file of TypeScript, all its types in "$defs"."""
    return {"wire": wire_schema(), "spec": spec_schema()}


def spec_schema() -> dict[str, Any]:
    """Pearl and scene files with all their tables."""
    found: dict[str, Any] = {}
    for model in (Pearl, Scene):
        schema = json_schema(model)
        tables = schema.pop("$defs", {})
        del schema["$schema"]
        for name, table in {**tables, model.__name__: schema}.items():
            if found.setdefault(name, table) != table:
                raise ValueError(f"{name} means two things")
    return {"$defs": {name: found[name] for name in sorted(found)}}


def fingerprint(schema: dict[str, Any]) -> str:
    """SHA-256 of a schema, in hexadecimal."""
    return hashlib.sha256(json.dumps(schema).encode()).hexdigest()


if __name__ == "__main__":
    made = {
        name: {"sha256": fingerprint(schema), "schema": schema}
        for name, schema in schemas().items()
    }
    json.dump(made, sys.stdout)
