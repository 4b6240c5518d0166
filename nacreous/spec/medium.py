"""What a kind of layer is made of, as a key of a file: a number, a pair, a name or a table."""

from __future__ import annotations

from typing import Annotated, Any, Literal, get_args

from pydantic import BeforeValidator, Discriminator, Field, Tag

from nacreous.spec.key import quantity
from nacreous.spec.section import Section


class Uniaxial(Section):
    """A uniaxial medium, its axis along the normal of the layers; lossless.

    >>> Uniaxial(n_o=1.683, n_e=1.53).indices
    ((1.683+0j), (1.53+0j))
    """

    n_o: float = quantity(
        ...,
        "Index for the electric field along the layers.",
        above=0,
        most=10,
        source="about 1.683 for aragonite",
    )
    n_e: float = quantity(
        ...,
        "Index for the electric field along their normal.",
        above=0,
        most=10,
        source="about 1.53 for aragonite",
    )

    @property
    def indices(self) -> tuple[complex, complex]:
        """The pair (n_o, n_e), as `nacreous.medium.Medium` has it."""
        return complex(self.n_o), complex(self.n_e)


def _pair(value: Any) -> Any:
    """TOML gives lists, models that cannot change hold tuples."""
    return tuple(value) if isinstance(value, list) else value


_N = Annotated[float, Field(gt=0, le=10)]
_K = Annotated[float, Field(ge=0, le=10)]

#: `nc.medium.NAMES`. A test compares the two: reading files needs no compiled room.
Named = Literal["aragonite", "aragonite-isotropic-1.53", "chitin", "silk-fibroin", "protein-1.43"]
NAMES: tuple[str, ...] = get_args(Named)
#: Those of them that are not the same in all directions.
_UNIAXIAL = ("aragonite",)


def _index_or_uniaxial(value: Any) -> str:
    return "uniaxial" if isinstance(value, dict | Uniaxial) else "index"


#: The number n, the pair [n, k] of n + ik with exp(-i w t), a name, or { n_o, n_e }.
Medium = Annotated[
    Annotated[
        Annotated[_N | tuple[_N, _K] | Named, Tag("index")] | Annotated[Uniaxial, Tag("uniaxial")],
        Discriminator(_index_or_uniaxial),
    ],
    BeforeValidator(_pair),
]
MEDIUM = (
    "a number n above 0 to 10, [n, k] with k from 0 to 10, { n_o = ..., n_e = ... }, or "
    + ", ".join(f'"{name}"' for name in NAMES)
)


def medium_of(key: Medium) -> complex | tuple[complex, complex] | str:
    """The medium as `nacreous.medium.Medium` takes it.

    >>> medium_of(1.43), medium_of((1.43, 0.01)), medium_of("chitin")
    ((1.43+0j), (1.43+0.01j), 'chitin')
    """
    if isinstance(key, str):
        return key
    if isinstance(key, Uniaxial):
        return key.indices
    return complex(*key) if isinstance(key, tuple) else complex(key)


def loss(key: Medium) -> float:
    """The imaginary part k of the index; the media known by name have none."""
    return key[1] if isinstance(key, tuple) else 0.0


def is_isotropic(key: Medium) -> bool:
    """Whether the index is the same in all directions.

    >>> is_isotropic("chitin"), is_isotropic("aragonite"), is_isotropic(Uniaxial(n_o=2, n_e=2))
    (True, False, False)
    """
    return not isinstance(key, Uniaxial) and key not in _UNIAXIAL
