"""What every table of a pearl or scene file has in common."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Self

from pydantic import BaseModel, ConfigDict, ValidationError, model_validator
from pydantic_core import PydanticCustomError

from nacreous.problem import InputError
from nacreous.spec.complaint import Contradiction, complaints


class Section(BaseModel):
    """A table of keys: unchangeable, complete and checked.

    No key beyond the declared ones, no silent change of type (`true` is not 1, `"20"` is not 20),
    no NaN and no infinity. A bad value gives an InputError with one line for each problem, whether
    it comes from a file or from Python.
    """

    model_config = ConfigDict(
        frozen=True,
        extra="forbid",
        strict=True,
        allow_inf_nan=False,
        validate_default=True,
        json_schema_serialization_defaults_required=True,  # every key is written out
        defer_build=True,  # most commands read one kind of file, or none
    )

    def __init__(self, **values: Any) -> None:
        try:
            super().__init__(**values)
        except ValidationError as error:
            name = type(self).__name__
            lines = complaints(error, type(self), values, place=lambda _: name)
            raise InputError("\n".join(lines)) from None

    # pydantic then builds nested sections without this __init__, so that all problems of a file
    # arrive together at the outermost one.
    __init__.__pydantic_base_init__ = True  # type: ignore[attr-defined]

    def contradictions(self) -> Iterator[Contradiction]:
        """What is wrong between keys that are each right; sections with such rules override it."""
        yield from ()

    @model_validator(mode="after")
    def _agree(self) -> Self:
        found = list(self.contradictions())
        if found:
            raise contradiction(*found)
        return self


def contradiction(*found: Contradiction) -> PydanticCustomError:
    """The form in which contradictions pass through pydantic on their way to the complaints."""
    return PydanticCustomError("contradiction", "keys disagree", {"found": found})
