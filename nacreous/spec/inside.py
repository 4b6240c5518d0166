"""The [inside] of a pearl: how far light travels below the film."""

from __future__ import annotations

from nacreous.spec.key import quantity
from nacreous.spec.section import Section


class Inside(Section):
    """The way of the light that has entered the pearl (the transport model)."""

    spread: float | None = quantity(
        None,
        "How far light spreads over the ball before it leaves: t of exp(-l (l + 1) t) on its "
        "spherical harmonics. 0 leaves each spot its own light; much of it lights all evenly.",
        least=0,
        most=1000,
        source="**(ours)**; a heat kernel on the sphere",
        left_out="from the knob depth",
    )
