"""Experimenters: a name and a password, then a cookie, and a second word for every change."""

from __future__ import annotations

import hashlib
import hmac
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Response
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request

from nacreous.server.origin import SAFE
from nacreous.server.refusal import BODIES, PROBLEMS, Refusal
from nacreous.server.requests import LoggingIn, body_of, body_schema
from nacreous.server.responses import WhoTold
from nacreous.server.service import Service, address, service_of
from nacreous.study.store import UnknownToken

COOKIE = "nacreous_lab"
_PATH = "/lab"

#: How one shows who one is, for the description of a route.
READS: dict[str, Any] = {"security": [{"cookie": []}]}
CHANGES: dict[str, Any] = {"security": [{"cookie": [], "csrf": []}]}

router = APIRouter(prefix="/lab/api", tags=["experimenters"], responses=PROBLEMS)


def csrf_of(token: str) -> str:
    """What a change must carry: it follows from the cookie, which no other site can read."""
    return hashlib.sha256(f"nacreous csrf {token}".encode()).hexdigest()


def experimenter(request: Request) -> str:
    """The name of who is logged in. Reads the store: for threads alone.

    A change must bring the word that login told.
    """
    token = request.cookies.get(COOKIE)
    if not token:
        raise UnknownToken("nobody is logged in; wanted: a login")
    name = service_of(request).store.login_of(token)
    request.state.name = name
    if request.method not in SAFE:
        given = request.headers.get("x-csrf-token", "")
        if not hmac.compare_digest(given.encode(), csrf_of(token).encode()):
            raise Refusal(403, "not-allowed", "X-CSRF-Token is missing or wrong; log in again")
    return name


#: For routes of experimenters alone.
Who = Annotated[str, Depends(experimenter)]


@router.post("/login", responses=BODIES, openapi_extra=body_schema(LoggingIn))
async def login(request: Request, response: Response) -> WhoTold:
    """Log in. Five tries a minute from one address, ten in fifteen minutes for one name."""
    service = service_of(request)
    wanted = await body_of(request, LoggingIn)
    tries = (("logins of an address", address(request.scope)), ("logins of a name", wanted.name))
    # Counted before, for many could come at once, and given back to who was right.
    for limit, who in tries:
        service.rates.take(limit, who)
    token = await run_in_threadpool(service.store.login, wanted.name, wanted.password)
    for limit, who in tries:
        service.rates.give_back(limit, who)
    _set_cookie(service, request, response, token)
    return WhoTold(name=wanted.name, csrf=csrf_of(token))


@router.get("/me", openapi_extra=READS)
def me(request: Request, name: Who) -> WhoTold:
    """Who is logged in, after a page was loaded again."""
    return WhoTold(name=name, csrf=csrf_of(request.cookies[COOKIE]))


@router.post("/logout", status_code=204, openapi_extra=CHANGES)
def logout(request: Request, response: Response, _who: Who) -> None:
    """Log out: the cookie is worthless from now on."""
    service_of(request).store.logout(request.cookies[COOKIE])
    _set_cookie(service_of(request), request, response, "")


def _set_cookie(service: Service, request: Request, response: Response, token: str) -> None:
    """Until the browser is closed; without a token, no longer than now."""
    response.set_cookie(
        COOKIE,
        token,
        max_age=None if token else 0,
        path=_PATH,
        httponly=True,
        samesite="strict",
        secure=service.is_https(request.scope),
    )
