"""The server as one ASGI application."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path

from fastapi import FastAPI
from fastapi.exceptions import RequestValidationError
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response

import nacreous
from nacreous.server import analysis, lab, login, pages, participant
from nacreous.server.description import Described
from nacreous.server.middleware import GuardMiddleware
from nacreous.server.service import Service
from nacreous.server.worker import Worker
from nacreous.study.running import Running


def create_app(
    running: Running,
    *,
    url: str | None = None,
    built: Path | None = None,
    worker: Worker | None = None,
    hosts: Collection[str] = (),
) -> FastAPI:
    """The application that serves a running study.

    url: where people reach it, if not where it listens. built: where the pages are, if
    not beside this package. worker: a process for what takes seconds. hosts:
    names that are the server's beside localhost, the address a request came in at, and that of
    `url`; a request that names another is refused. Raises `InputError` where the pages are not
    there, and for what is no host.
    """
    app = without_study()
    service = Service(running, url, worker, hosts)
    app.state.service = service
    app.state.pages = pages.Pages(built or pages.FOLDER)
    app.add_middleware(GuardMiddleware, service=service)
    return app


def without_study() -> FastAPI:
    """The routes alone, which can be described and serve nothing yet."""
    app = Described(
        title="Nacreous, a study",
        description="Participants answer with a token, experimenters with a cookie.",
        version=nacreous.__version__,
        docs_url=None,
        redoc_url=None,
        redirect_slashes=False,
        exception_handlers={HTTPException: _raised, RequestValidationError: _raised},
    )
    for part in (participant, login, lab, analysis, pages):
        app.include_router(part.router)
    return app


async def _raised(_request: Request, problem: Exception) -> Response:
    """All problems are told alike."""
    raise problem
