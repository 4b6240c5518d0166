"""What experimenters ask: how far the study is, who may enter, whose answers count."""

from __future__ import annotations

from datetime import datetime
from statistics import median
from typing import Annotated

from fastapi import APIRouter, Depends, Path, Query, Response
from starlette.concurrency import run_in_threadpool
from starlette.exceptions import HTTPException
from starlette.requests import Request

from nacreous.problem import InputError
from nacreous.server.asked import Excluding, Inviting, Opening, Registering, asked, asks
from nacreous.server.login import BODIES, CHANGES, PROBLEMS, READS, experimenter
from nacreous.server.refusal import Problem
from nacreous.server.service import Service, service_of
from nacreous.server.told import (
    EventTold,
    InvitationTold,
    LinksTold,
    PersonTold,
    ProgressTold,
)
from nacreous.study.store import PersonProgress, Session

router = APIRouter(prefix="/lab/api", tags=["experimenters"], responses={**PROBLEMS})

Number = Annotated[int, Path(ge=0, le=2**31 - 1)]
_MISSING = {404: {"model": Problem}}
