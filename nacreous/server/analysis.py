"""What the answers say so far: the scale, the report, the answers themselves."""

from __future__ import annotations

from collections.abc import Hashable, Iterator
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated, Literal

from fastapi import APIRouter, Query, Response
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import StreamingResponse

from nacreous.problem import InputError
from nacreous.server.login import READS, Who
from nacreous.server.refusal import PROBLEMS
from nacreous.server.responses import ScaleTold, TooFew
from nacreous.server.service import Service, service_of
from nacreous.study import results
from nacreous.study.store import Progress, export

router = APIRouter(prefix="/lab/api", tags=["experimenters"], responses=PROBLEMS)

_TABLE = "table.csv"
_PIECE_BYTES = 2**18

Question = Annotated[str, Query(max_length=40)]


def state_of(progress: Progress) -> Hashable:
    """What a scale hangs on: the answers, and whose of them count."""
    left_out = tuple(
        person.session.number
        for person in progress.people
        if person.session.excluded_reason is not None
    )
    return progress.answers, progress.erased, left_out


async def _state(service: Service) -> Hashable:
    return state_of(await run_in_threadpool(service.store.progress, service.running.study))


def _known(service: Service, question: str | None) -> str:
    """A question of the study; the first where none is named."""
    ids = [question.id for question in service.running.frozen.design.questions]
    if question is None:
        return ids[0]
    if question not in ids:
        raise InputError(f"question is {question!a}; allowed: {', '.join(ids)}")
    return question


@router.get("/scale", openapi_extra=READS)
async def scale(
    request: Request, _who: Who, question: Question | None = None, simulated: bool = False
) -> ScaleTold | TooFew:
    """The scale so far, or why there is none yet."""
    service = service_of(request)
    asked = _known(service, question)
    work = partial(_scale, service, asked, simulated)
    return await service.results.get(("scale", asked, simulated), await _state(service), work)


async def _scale(service: Service, question: str, simulated: bool) -> ScaleTold | TooFew:
    try:
        found = await service.works_out(results.scale_so_far, question, simulated)
    except InputError as problem:
        return TooFew(problem=str(problem))
    return ScaleTold.model_validate(found, from_attributes=True)


@router.get(
    "/report",
    response_class=Response,
    responses={200: {"content": {"text/html": {}}}},
    openapi_extra=READS,
)
async def report(
    request: Request,
    _who: Who,
    question: Question | None = None,
    language: Literal["en", "ja"] = "en",
    simulated: bool = False,
) -> Response:
    """The report as one page, to be kept."""
    service = service_of(request)
    asked = _known(service, question)
    work = partial(service.works_out, results.report, asked, language, simulated)
    key = ("report", asked, language, simulated)
    page = await service.results.get(key, await _state(service), work, good_for=0)
    return Response(page, media_type="text/html", headers=_named("report.html"))


@router.get(
    "/answers.csv",
    response_class=Response,
    responses={200: {"content": {"text/csv": {}}}},
    openapi_extra=READS,
)
async def answers(request: Request, _who: Who, bom: bool = False) -> Response:
    """All answers, the excluded, simulated and erased ones marked; bom: as Excel wants it."""
    return await _csv(service_of(request), "answers", bom)


@router.get(
    "/people.csv",
    response_class=Response,
    responses={200: {"content": {"text/csv": {}}}},
    openapi_extra=READS,
)
async def people(request: Request, _who: Who, bom: bool = False) -> Response:
    """Everyone who has entered, with their flags, also who never answered."""
    return await _csv(service_of(request), "people", bom)


async def _csv(service: Service, table: str, bom: bool) -> Response:
    folder = await run_in_threadpool(_exported, service, table, bom)
    named = _named(f"{table}.csv")
    return StreamingResponse(_pieces(folder), media_type="text/csv", headers=named)


def _exported(service: Service, table: str, bom: bool) -> TemporaryDirectory[str]:
    """A folder with the table, whole before the first byte is sent."""
    folder = TemporaryDirectory()
    try:
        path = Path(folder.name) / _TABLE
        export(service.store, service.running.study, path, table=table, bom=bom)
    except BaseException:
        folder.cleanup()
        raise
    return folder


def _pieces(folder: TemporaryDirectory[str]) -> Iterator[bytes]:
    """The file piece by piece; then the folder goes, also where nobody takes the rest."""
    with folder, (Path(folder.name) / _TABLE).open("rb") as stream:
        while piece := stream.read(_PIECE_BYTES):
            yield piece


def _named(name: str) -> dict[str, str]:
    return {"Content-Disposition": f'attachment; filename="{name}"'}
