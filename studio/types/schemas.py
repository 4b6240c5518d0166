"""What the pages' generated files are made from; prints it as JSON, by the name of the file.

`./just types` hands it to typescript.mjs beside this file: JSON Schemas, of which TypeScript is
made, and declarations, which are written as they are. Each schema goes with its SHA-256, which
the TypeScript then bears, so that a test sees without Node.js whether it is current.
"""

from __future__ import annotations

import hashlib
import json
import sys
from typing import Any

import declared

from nacreous.server.wire import wire_schema


def schemas() -> dict[str, dict[str, Any]]:
    """A schema for each file of TypeScript, all its types in "$defs"."""
    return {
        "shared/wire": wire_schema(),
        "shared/spec": {"$defs": declared.tables()},
        "viewer/specs/complete": declared.complete(),
    }


def fingerprint(schema: dict[str, Any]) -> str:
    """SHA-256 of a schema, in hexadecimal."""
    return hashlib.sha256(json.dumps(schema).encode()).hexdigest()


if __name__ == "__main__":
    made: dict[str, Any] = {
        f"{name}.ts": {"sha256": fingerprint(schema), "schema": schema}
        for name, schema in schemas().items()
    }
    made["viewer/specs/declared.json"] = {"values": declared.declared()}
    json.dump(made, sys.stdout)
