"""What went wrong, as HTTP says it: a status and {"problem": one line, "kind": a word}."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from fastapi.exceptions import RequestValidationError
from pydantic import BaseModel, ValidationError
from starlette.exceptions import HTTPException

from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.study.store import Conflict, NotAllowed, OutOfTurn, StoreError, UnknownToken

Kind = Literal[
    "input", "token", "not-allowed", "conflict", "turn", "busy", "store", "missing", "fault"
]

_LONGEST = 400


class Problem(BaseModel):
    """What every refusal looks like."""

    problem: str
    kind: Kind


def described(*statuses: int) -> dict[int | str, dict[str, Any]]:
    """Refusals that a route may give, for its description."""
    return {status: {"model": Problem} for status in statuses}


#: What nearly every route may refuse, and what may be wrong with a body besides.
PROBLEMS = described(400, 401, 403, 409, 429, 503)
BODIES = described(408, 413, 415)
MISSING = described(404)


@dataclass
class Refusal(Exception):  # noqa: N818 (it is no error of the program's)
    """A request that is answered with a problem. `logged`: it stands in the audit log already."""

    status: int
    kind: Kind
    problem: str
    headers: Mapping[str, str] = field(default_factory=dict)
    logged: bool = False


def refusal_of(problem: Exception) -> Refusal | None:
    """How a problem is told; None for one that nobody foresaw.

    >>> refusal_of(InputError("trial is 99; allowed: 0 to 27")).status
    400
    """
    line = _line(str(problem))
    match problem:
        case Refusal():
            return problem
        case UnknownToken():
            return Refusal(401, "token", line, {"WWW-Authenticate": "Bearer"})
        case Conflict():
            return Refusal(409, "conflict", line, logged=True)
        case OutOfTurn():
            return Refusal(409, "turn", line)
        case NotAllowed():
            return Refusal(403, "not-allowed", line)
        case RequestValidationError() | ValidationError():
            return Refusal(400, "input", _first(problem.errors()))
        case InputError():
            return Refusal(400, "input", line)
        case StoreError():
            told = _line(problem.strerror or "the store refuses")
            return Refusal(503, "store", f"not stored: {told}", {"Retry-After": "2"})
        case HTTPException():
            return _of_starlette(problem)
    return None


def _of_starlette(problem: HTTPException) -> Refusal:
    kind: Kind = "missing" if problem.status_code in (404, 405) else "input"
    told = {404: "there is nothing here", 405: "this is not done here; see Allow"}
    line = told.get(problem.status_code, _line(problem.detail))
    return Refusal(problem.status_code, kind, line, problem.headers or {})


def _first(errors: Sequence[Any]) -> str:
    """The first of pydantic's complaints, in one line that may be logged.

    So there is no password in it, and no parameter of an address, which may identify somebody.
    """
    error = errors[0]
    where = ".".join(str(part) for part in error["loc"]) or "body"
    secret = where in ("body", "password") or where.startswith("parameters")
    if secret or error["type"] in ("missing", "extra_forbidden", "json_invalid"):
        return _line(f"{where}: {error['msg']}")
    return _line(f"{where} is {ascii(error['input'])[:60]}; wanted: {error['msg']}")


def _line(text: str) -> str:
    """As one line that a page, a terminal and the audit log can show."""
    return printable(" ".join(text.split()))[:_LONGEST]
