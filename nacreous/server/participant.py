"""What a participant's browser asks: entering, consent, screen, answers, the end."""

from __future__ import annotations

import asyncio
import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Annotated, Any

from fastapi import APIRouter, Path, Response
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request

from nacreous.server.refusal import BODIES, MISSING, PROBLEMS
from nacreous.server.requests import Answering, Checking, Entering, body_of, body_schema
from nacreous.server.responses import ReceiptTold, ScreenTold, SittingTold, StudyTold
from nacreous.server.service import Service, address, service_of
from nacreous.server.sitting import sitting_of
from nacreous.study.store import NotAllowed, Session, UnknownToken

_BEARER: dict[str, Any] = {"security": [{"token": []}]}

router = APIRouter(prefix="/api", tags=["participant"], responses=PROBLEMS)


def token_of(request: Request) -> str:
    """The token that a request carries."""
    given = re.fullmatch("(?i:bearer) +([A-Za-z0-9_-]{1,200})", _authorization(request))
    if given is None:
        raise UnknownToken("token is missing; wanted: Authorization: Bearer TOKEN")
    return given[1]


def _authorization(request: Request) -> str:
    return request.headers.get("authorization", "").strip()


def session_of(service: Service, request: Request) -> Session:
    """Who asks. Reads the store: for threads alone."""
    session = service.running.session_of(token_of(request))
    request.state.session = session.id
    return session


@contextmanager
def changing(request: Request) -> Iterator[tuple[Service, Session]]:
    """Who asks for a change of themselves; what is remembered of them is forgotten after it."""
    service = service_of(request)
    try:
        yield service, session_of(service, request)
    finally:
        service.sessions.forget(token_of(request))


# First of all routes, for it is asked the most, and routes are tried in turn.
@router.put(
    "/answers/{trial}", responses=BODIES, openapi_extra={**_BEARER, **body_schema(Answering)}
)
async def answer(request: Request, trial: Annotated[int, Path(ge=0, le=2**31 - 1)]) -> ReceiptTold:
    """Answer a trial. The receipt says that it is on the disk; the same again is welcome."""
    service = service_of(request)
    token = token_of(request)
    wanted = await body_of(request, Answering)
    session = await service.sessions.find(token)
    request.state.session = session.id
    # The plan is in memory since the session was read: nothing here waits but for the receipt.
    waiting = service.running.hand_in(session, trial, wanted.response)
    receipt = await asyncio.wrap_future(waiting)
    return ReceiptTold(trial=trial, received_at=receipt.received_at, again=receipt.again)


@router.get("/study")
def study(request: Request) -> StudyTold:
    """What the study is about, to whoever has not entered."""
    return service_of(request).told()


@router.post(
    "/enter",
    status_code=201,
    responses={200: {"model": SittingTold}, **BODIES},
    openapi_extra={**_BEARER, **body_schema(Entering)},
)
async def enter(request: Request, response: Response) -> SittingTold:
    """Enter with a fresh token or an invitation's; the same token again is the same person."""
    service = service_of(request)
    token = token_of(request)
    wanted = await body_of(request, Entering)
    service.rates.take("entries of an address", address(request.scope))

    def work() -> tuple[bool, SittingTold]:
        try:
            service.running.session_of(token)
            again = True
        except UnknownToken:
            again = False
        session = service.running.enter(
            token, wanted.language, dict(wanted.groups), dict(wanted.parameters)
        )
        request.state.session = session.id
        return again, sitting_of(service, session)

    again, told = await run_in_threadpool(work)
    if again:
        response.status_code = 200
    return told


@router.get("/sitting", openapi_extra=_BEARER)
def sitting(request: Request) -> SittingTold:
    """Where the participant is, to begin or to go on."""
    service = service_of(request)
    return sitting_of(service, session_of(service, request))


@router.post("/consent", status_code=204, openapi_extra=_BEARER)
def consent(request: Request) -> None:
    """The participant agrees; no answer is taken before."""
    with changing(request) as (service, session):
        service.store.consent(session.id)


@router.post("/screen", responses=BODIES, openapi_extra={**_BEARER, **body_schema(Checking)})
async def screen(request: Request) -> ScreenTold:
    """What the screen is like; the last check counts."""
    token_of(request)
    wanted = await body_of(request, Checking)

    def work() -> ScreenTold:
        with changing(request) as (service, session):
            flags = service.running.screen(session, wanted.content)
            refused = service.running.refused(session_of(service, request))
            return ScreenTold(flags=list(flags), refused=refused)

    return await run_in_threadpool(work)


@router.post("/finish", status_code=204, openapi_extra=_BEARER)
def finish(request: Request) -> None:
    """Every trial is answered, which the server knows by the last answer; twice does no harm."""
    with changing(request) as (service, session):
        service.running.finish(session)


@router.post("/withdraw", status_code=204, openapi_extra=_BEARER)
def withdraw(request: Request) -> None:
    """The participant does not want their answers to be counted."""
    with changing(request) as (service, session):
        service.store.withdraw(session.id)


@router.get(
    "/pictures/{sha256}",
    response_class=Response,
    responses={200: {"content": {"image/png": {}}}, **MISSING},
    openapi_extra=_BEARER,
)
def picture(request: Request, sha256: Annotated[str, Path(pattern="^[0-9a-f]{64}$")]) -> Response:
    """A picture of the participant's own trials, once they have consented."""
    service = service_of(request)
    session = session_of(service, request)
    if sha256 not in service.running.due(session):
        raise NotAllowed("this picture is not due; allowed: those of one's own trials")
    return service.pictures.response(sha256)
