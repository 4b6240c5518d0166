"""The [nacre] of a pearl: what grown and given layers share, and layers given one by one."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BeforeValidator, Field, model_validator

from nacreous.spec.complaint import Contradiction
from nacreous.spec.key import key, quantity
from nacreous.spec.section import Section, contradiction


def _pair(value: Any) -> Any:
    """TOML gives lists, models that cannot change hold tuples."""
    return tuple(value) if isinstance(value, list) else value


_N = Annotated[float, Field(gt=0, le=10)]
_K = Annotated[float, Field(ge=0, le=10)]

#: A refractive index: the number n, or the pair [n, k] of n + ik with exp(-i w t).
Index = Annotated[_N | tuple[_N, _K], BeforeValidator(_pair)]
_INDEX = "a number n above 0 to 10, or [n, k] with k from 0 to 10"


class Nacre(Section):
    """What all nacre has: the thickness of its protein layers and the indices of its two kinds."""

    protein_nm: float = quantity(
        20.0,
        "Thickness of the protein layer below each aragonite layer.",
        least=0,
        most=200,
        unit="nm",
        source="paper 3.2.1, constant 20 nm",
    )
    aragonite: Index = key(
        1.53,
        "Refractive index of aragonite, n or [n, k] for n + ik.",
        allowed=_INDEX,
        source="paper 3.2.3, the value along the c-axis; about 1.683 is measured across it",
    )
    protein: Index = key(
        1.43,
        "Refractive index of the protein, n or [n, k] for n + ik.",
        allowed=_INDEX,
        source="paper 3.2.3; 1.43 to 1.56 in later work",
    )

    @property
    def aragonite_index(self) -> complex:
        """The index of aragonite as n + ik."""
        return _complex(self.aragonite)

    @property
    def protein_index(self) -> complex:
        """The index of the protein as n + ik.

        >>> Layers(thickness_nm=[400.0], protein=[1.43, 0.01]).protein_index
        (1.43+0.01j)
        """
        return _complex(self.protein)


def _complex(index: float | tuple[float, float]) -> complex:
    return complex(*index) if isinstance(index, tuple) else complex(index)


class Layers(Nacre):
    """Nacre whose aragonite layers are given one by one.

    >>> Layers(thickness_nm=[400, 410.5, 395]).thickness_nm
    (400.0, 410.5, 395.0)
    """

    thickness_nm: tuple[Annotated[float, Field(gt=0, le=100_000)], ...] = key(
        ...,
        "Thickness of each aragonite layer in nm, the surface first. Instead of growth.",
        allowed="1 to 5000 numbers, each above 0 to 100000 nm",
        unit="nm",
        source="paper 3.1: 60 to 1000 layers of 300 to 800 nm",
        min_length=1,
        max_length=5000,
        strict=False,
    )

    @model_validator(mode="before")
    @classmethod
    def _not_grown(cls, values: Any) -> Any:
        """Growth keys beside the list would be ignored: say so instead."""
        from nacreous.spec.growth import Growth

        grown = set(Growth.model_fields) - set(cls.model_fields)
        found = [name for name in values if name in grown] if isinstance(values, dict) else []
        if found:
            verdict = "cannot stand beside {other}: layers are either listed or grown"
            raise contradiction(*(Contradiction(name, verdict, "thickness_nm") for name in found))
        return values
