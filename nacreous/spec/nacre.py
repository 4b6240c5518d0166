"""The [nacre] of a pearl: what grown and given layers share, and layers given one by one."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any

from pydantic import Field, model_validator

from nacreous.spec.complaint import Contradiction
from nacreous.spec.key import key, quantity
from nacreous.spec.medium import MEDIUM, NAMES, Medium, medium_of
from nacreous.spec.section import Section, contradiction
from nacreous.thinness import thin_layers, thin_protein


class Nacre(Section):
    """What all nacre has: how thick its protein layers are, and what both kinds are made of."""

    protein_nm: float = quantity(
        20.0,
        "Thickness of the protein layer below each aragonite layer.",
        least=0,
        most=200,
        unit="nm",
        source="paper 3.2.1, constant 20 nm",
    )
    aragonite: Medium = key(
        1.53,
        "What the aragonite layers are: an index n, [n, k] for n + ik, the pair along and across "
        "the layers, or a medium by name.",
        allowed=MEDIUM,
        examples=list(NAMES),
        source="paper 3.2.3, the value along the c-axis; about 1.683 is measured across it",
    )
    protein: Medium = key(
        1.43,
        "What the protein layers are, likewise.",
        allowed=MEDIUM,
        examples=list(NAMES),
        source="paper 3.2.3; 1.43 to 1.56 in later work",
    )

    def contradictions(self) -> Iterator[Contradiction]:
        """A protein layer that is thinner than an atom."""
        yield from super().contradictions()
        if (verdict := thin_protein(self.protein_nm)) is not None:
            yield Contradiction("protein_nm", verdict)

    @property
    def aragonite_medium(self) -> complex | tuple[complex, complex] | str:
        """The aragonite as `nacreous.medium.Medium` has it: n + ik, (n_o, n_e) or a name.

        >>> Layers(thickness_nm=[400.0], aragonite={"n_o": 1.683, "n_e": 1.53}).aragonite_medium
        ((1.683+0j), (1.53+0j))
        """
        return medium_of(self.aragonite)

    @property
    def protein_medium(self) -> complex | tuple[complex, complex] | str:
        """The protein likewise.

        >>> Layers(thickness_nm=[400.0], protein=[1.43, 0.01]).protein_medium
        (1.43+0.01j)
        """
        return medium_of(self.protein)


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

    def contradictions(self) -> Iterator[Contradiction]:
        """Layers that are all thinner than two cells of aragonite."""
        yield from super().contradictions()
        if (verdict := thin_layers(self.thickness_nm)) is not None:
            yield Contradiction("thickness_nm", verdict)

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
