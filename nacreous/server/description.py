"""/openapi.json: the HTTP interface, described for programs."""

from __future__ import annotations

from typing import Any

from fastapi import FastAPI

from nacreous.server.requests import body_schemas

_SCHEMES = {
    "token": {
        "type": "http",
        "scheme": "bearer",
        "description": "A participant's token: fresh from /api/study, or an invitation's.",
    },
    "cookie": {"type": "apiKey", "in": "cookie", "name": "nacreous_lab"},
    "csrf": {
        "type": "apiKey",
        "in": "header",
        "name": "X-CSRF-Token",
        "description": "Told by /lab/api/login and /lab/api/me; every change needs it.",
    },
}


class Described(FastAPI):
    """An application whose description says how one shows who one is, and nothing untrue."""

    def openapi(self) -> dict[str, Any]:
        """The description, made when it is first asked for."""
        if self.openapi_schema is None:
            made = super().openapi()
            components = made.setdefault("components", {})
            components["securitySchemes"] = _SCHEMES
            schemas = components.setdefault("schemas", {})
            schemas.update(body_schemas())
            for path in made["paths"].values():
                for operation in path.values():
                    # FastAPI's own code for bad input; ours is 400.
                    operation["responses"].pop("422", None)
            for name in ("HTTPValidationError", "ValidationError"):
                schemas.pop(name, None)
            self.openapi_schema = made
        return self.openapi_schema
