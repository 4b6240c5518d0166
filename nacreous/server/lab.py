"""What experimenters ask: how far the study is, who may enter, whose answers count."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from typing import Annotated

from fastapi import APIRouter, Path, Query, Response
from starlette.concurrency import run_in_threadpool
from starlette.exceptions import HTTPException
from starlette.requests import Request

from nacreous.server.analysis import state_of
from nacreous.server.login import CHANGES, READS, Who
from nacreous.server.refusal import BODIES, MISSING, PROBLEMS
from nacreous.server.requests import Excluding, Inviting, Opening, Registering, body_of, body_schema
from nacreous.server.responses import EventTold, InvitationTold, LinksTold, ProgressTold
from nacreous.server.service import Service, service_of
from nacreous.study import results
from nacreous.study.store import Session

router = APIRouter(prefix="/lab/api", tags=["experimenters"], responses=PROBLEMS)

Number = Annotated[int, Path(ge=0, le=2**31 - 1)]
_COUNTS = (
    *("state", "entered", "consented", "finished", "excluded", "erased"),
    *("answers", "simulated", "median_s"),
)


@router.get("/progress", openapi_extra=READS)
async def progress(request: Request, _who: Who) -> ProgressTold:
    """Who, how far, how long; and what is noticed about whom, as far as that is worked out."""
    service = service_of(request)
    running = service.running
    found = await run_in_threadpool(service.store.progress, running.study)
    mark = partial(service.works_out, results.people_flags)
    flags = service.results.so_far("flags", state_of(found), mark)

    def work() -> ProgressTold:
        return ProgressTold(
            name=running.frozen.design.name,
            study=running.study,
            purpose=running.frozen.design.purpose,
            registration=service.store.registration(running.study),
            trials=service.people.trials,
            people=service.people.told(found, flags or {}),
            flags_known=flags is not None,
            **{name: getattr(found, name) for name in _COUNTS},
        )

    return await run_in_threadpool(work)


@router.post(
    "/state", status_code=204, responses=BODIES, openapi_extra={**CHANGES, **body_schema(Opening)}
)
async def state(request: Request, who: Who) -> None:
    """Open, pause or close the study."""
    service = service_of(request)
    store = service.store
    wanted = await body_of(request, Opening)
    change = {"open": store.reopen, "paused": store.pause, "closed": store.close_study}
    await run_in_threadpool(change[wanted.state], service.running.study, who)


@router.post(
    "/registration",
    status_code=204,
    responses=BODIES,
    openapi_extra={**CHANGES, **body_schema(Registering)},
)
async def registration(request: Request, who: Who) -> None:
    """Let anybody enter, or invited people alone."""
    service = service_of(request)
    wanted = await body_of(request, Registering)
    set_it = service.store.set_registration
    await run_in_threadpool(set_it, service.running.study, wanted.registration, who)


@router.get("/invitations", openapi_extra=READS)
def invitations(request: Request, _who: Who) -> list[InvitationTold]:
    """All invitations, without their links, which were told once."""
    service = service_of(request)
    return [
        InvitationTold.model_validate(invitation, from_attributes=True)
        for invitation in service.store.invitations(service.running.study)
    ]


@router.post("/invitations", responses=BODIES, openapi_extra={**CHANGES, **body_schema(Inviting)})
async def invite(request: Request, who: Who) -> LinksTold:
    """Make invitations. The token stands behind #, which browsers send to no server."""
    service = service_of(request)
    wanted = await body_of(request, Inviting)
    invite = service.store.invite
    study = service.running.study
    tokens = await run_in_threadpool(invite, study, wanted.count, wanted.label, who)
    home = service.url or str(request.base_url).rstrip("/")
    return LinksTold(links=[f"{home}/#{token}" for token in tokens])


@router.post(
    "/invitations/{invitation}/revoke",
    status_code=204,
    responses=MISSING,
    openapi_extra=CHANGES,
)
def revoke_invitation(request: Request, who: Who, invitation: Number) -> None:
    """Let nobody enter by it any more."""
    service = service_of(request)
    there = service.store.invitations(service.running.study)
    if all(invitation != one.id for one in there):
        raise HTTPException(404)
    service.store.revoke_invitation(invitation, who)


@router.post(
    "/people/{number}/exclude",
    status_code=204,
    responses={**BODIES, **MISSING},
    openapi_extra={**CHANGES, **body_schema(Excluding)},
)
async def exclude(request: Request, who: Who, number: Number) -> None:
    """Mark somebody's answers as not to be counted."""
    service = service_of(request)
    wanted = await body_of(request, Excluding)

    def work() -> None:
        with _changing(service, number) as session:
            service.store.exclude(session.id, wanted.reason, who)

    await run_in_threadpool(work)


@router.post("/people/{number}/readmit", status_code=204, responses=MISSING, openapi_extra=CHANGES)
def readmit(request: Request, who: Who, number: Number) -> None:
    """Count them after all."""
    service = service_of(request)
    with _changing(service, number) as session:
        service.store.readmit(session.id, who)


@router.post("/people/{number}/revoke", status_code=204, responses=MISSING, openapi_extra=CHANGES)
def revoke(request: Request, who: Who, number: Number) -> None:
    """Make somebody's token worthless."""
    service = service_of(request)
    with _changing(service, number) as session:
        service.store.revoke(session.id, who)


@contextmanager
def _changing(service: Service, number: int) -> Iterator[Session]:
    """A person by number; after the change nothing is remembered of anybody."""
    found = [one for one in service.store.sessions(service.running.study) if one.number == number]
    if not found:
        raise HTTPException(404)
    try:
        yield found[0]
    finally:
        service.sessions.forget()


@router.get(
    "/pictures/{sha256}",
    response_class=Response,
    responses={200: {"content": {"image/png": {}}}, **MISSING},
    openapi_extra=READS,
)
async def picture(
    request: Request, _who: Who, sha256: Annotated[str, Path(pattern="^[0-9a-f]{64}$")]
) -> Response:
    """A picture of the study."""
    service = service_of(request)
    if sha256 not in service.pictures:
        raise HTTPException(404)
    return service.pictures.response(sha256)


@router.get("/events", openapi_extra=READS)
def events(
    request: Request, _who: Who, last: Annotated[int, Query(ge=1, le=10_000)] = 200
) -> list[EventTold]:
    """The end of the study's audit log."""
    service = service_of(request)
    study = service.running.study
    numbers = {session.id: session.number for session in service.store.sessions(study)}
    return [
        EventTold(
            at=event.at,
            who=event.who,
            what=event.what,
            number=None if event.session is None else numbers.get(event.session),
            detail=dict(event.detail),
        )
        for event in service.store.events(study, last)
    ]
