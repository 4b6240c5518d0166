"""The JSON Schema of pearl and scene files, for editors and for other programs."""

from __future__ import annotations

from typing import Any

from pydantic.json_schema import GenerateJsonSchema, JsonSchemaValue
from pydantic_core import core_schema

from nacreous.spec.specfile import SpecFile


class _Manual(GenerateJsonSchema):
    """pydantic's schema as a manual: no made-up titles, and no null, which TOML does not have."""

    def field_title_should_be_set(self, schema: Any) -> bool:
        return False

    def nullable_schema(self, schema: core_schema.NullableSchema) -> JsonSchemaValue:
        return self.generate_inner(schema["schema"])

    def model_schema(self, schema: core_schema.ModelSchema) -> JsonSchemaValue:
        made = super().model_schema(schema)
        made["description"] = " ".join(made["description"].partition("\n\n")[0].split())
        return made

    def default_schema(self, schema: core_schema.WithDefaultSchema) -> JsonSchemaValue:
        made = super().default_schema(schema)
        if made.get("default", ...) is None:
            del made["default"]
        return made


def json_schema(model: type[SpecFile]) -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of a pearl or scene file.

    Every key has its meaning, range, source and default; "allowed" is the phrase of the messages.

    >>> from nacreous.spec import Pearl
    >>> json_schema(Pearl)["properties"]["depth"]["maximum"]
    1
    """
    schema = model.model_json_schema(schema_generator=_Manual)
    return {"$schema": _Manual.schema_dialect, **schema}
