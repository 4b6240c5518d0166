"""/openapi.json: the HTTP interface, described for programs."""

from __future__ import annotations

from fastapi import FastAPI

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


def describe(app: FastAPI) -> None:
    """Let the description say how one shows who one is, and nothing that is not so."""
    made = app.openapi()
    made.setdefault("components", {})["securitySchemes"] = _SCHEMES
    for path in made["paths"].values():
        for operation in path.values():
            # FastAPI's own code for bad input; ours is 400.
            operation["responses"].pop("422", None)
    for name in ("HTTPValidationError", "ValidationError"):
        made["components"].get("schemas", {}).pop(name, None)
    app.openapi_schema = made
