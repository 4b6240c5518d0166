"""The bodies of requests, strict, with bounds, and nothing beside."""

from __future__ import annotations

from typing import Annotated, Any, Literal, TypeVar

from pydantic import AwareDatetime, BaseModel, ConfigDict, Field, JsonValue
from pydantic.json_schema import models_json_schema
from starlette.requests import Request

from nacreous.study.running.screen_check import ScreenCheck
from nacreous.study.task.response import Response
from nacreous.study.task.tasks import Answerable


class RequestBody(BaseModel):
    """A body of JSON."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


Word = Annotated[str, Field(min_length=1, max_length=40)]
Line = Annotated[str, Field(min_length=1, max_length=200)]
Noticed = Annotated[dict[str, JsonValue], Field(max_length=50)]


class Entering(RequestBody):
    """Who comes: the language of the pages, and what was asked of each recorded group.

    parameters: of the address by which they came, those that the study keeps.
    """

    language: Word
    groups: Annotated[dict[Word, Word], Field(max_length=12)]
    parameters: Annotated[dict[Word, Line], Field(max_length=12)] = Field(default_factory=dict)


class Checking(RequestBody):
    """What the browser found out about the screen."""

    content: ScreenCheck


class Answering(RequestBody):
    """The answer to a trial; the trial itself is known."""

    chosen: Answerable
    response_ms: Annotated[float, Field(ge=0, le=86_400_000, allow_inf_nan=False)] | None = None
    shown_at: AwareDatetime | None = None
    answered_at: AwareDatetime | None = None
    flags: Noticed = Field(default_factory=dict)
    simulated: bool = False

    @property
    def response(self) -> Response:
        """The same, as study and store take it."""
        return Response(
            self.chosen,
            self.response_ms,
            self.shown_at,
            self.answered_at,
            self.flags,
            self.simulated,
        )


class LoggingIn(RequestBody):
    """An experimenter's name and password."""

    name: Line
    password: Line


class Opening(RequestBody):
    """Whether people may enter."""

    state: Literal["open", "paused", "closed"]


class Registering(RequestBody):
    """Who may enter."""

    registration: Literal["open", "invited"]


class Inviting(RequestBody):
    """How many invitations, and what experimenters call them."""

    count: Annotated[int, Field(ge=1, le=1000)]
    label: Line


class Excluding(RequestBody):
    """Why a person's answers are not to be counted."""

    reason: Annotated[str, Field(min_length=1, max_length=1000)]


#: Where a description keeps schemas.
_PLACE = "#/components/schemas/{model}"

Body = TypeVar("Body", bound=RequestBody)


async def body_of(request: Request, model: type[Body]) -> Body:
    """The body of a request; pydantic reads JSON more strictly than Python does."""
    return model.model_validate_json(await request.body())


def body_schema(model: type[RequestBody]) -> dict[str, Any]:
    """The body of a route, for its description; `body_schemas` has what it refers to."""
    schema = {"$ref": _PLACE.format(model=model.__name__)}
    return {"requestBody": {"required": True, "content": {"application/json": {"schema": schema}}}}


def body_schemas() -> dict[str, Any]:
    """The JSON Schema of every body, and of the tables in them, by name."""
    wanted: list[tuple[type[BaseModel], Literal["validation"]]] = [
        (model, "validation") for model in RequestBody.__subclasses__()
    ]
    _, made = models_json_schema(wanted, ref_template=_PLACE)
    schemas: dict[str, Any] = made["$defs"]
    return schemas
