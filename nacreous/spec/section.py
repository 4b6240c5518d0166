"""What every table of a pearl or scene file has in common."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
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

    def __repr_args__(self) -> Iterator[tuple[str, Any]]:
        """The keys that differ from their defaults, so that the line stays short."""
        for name, field in type(self).model_fields.items():
            value = getattr(self, name)
            if isinstance(value, Section) and not any(value.__repr_args__()):
                continue
            if value != field.get_default(call_default_factory=True, validated_data={}):
                yield name, value

    def __dask_tokenize__(self) -> tuple[str, str]:
        """What Dask knows equal sections by."""
        return type(self).__qualname__, self.model_dump_json()

    def __str__(self) -> str:
        """The same line as its repr."""
        return repr(self)

    def replace(self, **changes: Any) -> Self:
        """The same section with other values of the named keys, checked as a new one is.

        >>> from nacreous.spec import Pearl
        >>> Pearl(shininess=0.2).replace(depth=0.7).shininess
        0.2
        >>> Pearl().replace(depth=7)
        Traceback (most recent call last):
        nacreous.problem.InputError: Pearl: depth is 7; allowed: 0 to 1
        """
        given = {name: getattr(self, name) for name in self.model_fields_set}
        return type(self)(**given | changes)

    def __setattr__(self, name: str, value: Any) -> None:
        """Refused: a section never changes.

        >>> from nacreous.spec import Pearl
        >>> Pearl().depth = 0.7
        Traceback (most recent call last):
        nacreous.problem.InputError: Pearl.depth cannot be set; allowed: replace(depth=...), ...
        """
        raise InputError(
            f"{type(self).__name__}.{name} cannot be set; "
            f"allowed: replace({name}=...), which makes another {type(self).__name__}"
        )

    def __delattr__(self, name: str) -> None:
        """Refused likewise."""
        raise InputError(
            f"{type(self).__name__}.{name} cannot be deleted; allowed: a new {type(self).__name__}"
        )

    #: What `copy.replace` of Python 3.13 calls.
    __replace__ = replace

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """A copy; `update`, whose values pydantic does not check, is refused: see `replace`."""
        if update:
            raise InputError("model_copy(update=...) checks nothing; allowed: replace(key=value)")
        return super().model_copy(deep=deep)

    def __dir__(self) -> list[str]:
        """Keys, and what sections do; pydantic's own names are pydantic's."""
        own = [vars(one) for one in type(self).__mro__ if one.__module__.startswith("nacreous.")]
        does = {name for names in own for name in names if not name.startswith(("_", "model_"))}
        return sorted(does | {*type(self).model_fields})

    def copy(self, **changes: Any) -> Self:
        """The same by pydantic's former name."""
        if changes:
            raise InputError(
                f"copy({', '.join(changes)}) checks nothing; allowed: replace(key=value)"
            )
        return self.model_copy()

    def contradictions(self) -> Iterator[Contradiction]:
        """What is wrong between keys that are each right; sections with such rules override it."""
        yield from ()

    @model_validator(mode="before")
    @classmethod
    def _without_numpy(cls, values: Any) -> Any:
        """The values with NumPy's numbers and arrays as Python's, which strict keys demand."""
        if not isinstance(values, dict):
            return values
        return {
            key: value.tolist() if type(value).__module__ == "numpy" else value
            for key, value in values.items()
        }

    @model_validator(mode="after")
    def _agree(self) -> Self:
        found = list(self.contradictions())
        if found:
            raise contradiction(*found)
        return self


def contradiction(*found: Contradiction) -> PydanticCustomError:
    """The form in which contradictions pass through pydantic on their way to the complaints."""
    return PydanticCustomError("contradiction", "keys disagree", {"found": found})
