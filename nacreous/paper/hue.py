"""Hue around and across the rings of interference colour."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous import colour
from nacreous.paper.sight import Sight

__all__ = [
    "FAMILIES",
    "families",
    "family_share",
    "family_ticks",
    "profile",
    "ring_spread",
    "span_deg",
]

Array = NDArray[np.float64]

#: Munsell's ten hue families, in his order.
FAMILIES = ("R", "YR", "Y", "GY", "G", "BG", "B", "PB", "P", "RP")
_GREY_CHROMA = 0.5


def profile(layer: NDArray[np.float32], sight: Sight, rings: int = 48) -> tuple[Array, Array]:
    """Distance from the centre in radii, and mean linear RGB of each ring, [ring, 3].

    Rings are as wide as each other; those that hold no middle of a pixel are left out.
    """
    away = sight.circle.distance(layer.shape)
    whole = np.isfinite(sight.cos_view)
    ring = np.minimum((away[whole] * rings).astype(int), rings - 1)
    count = np.bincount(ring, minlength=rings)
    held = count > 0
    mean = [np.bincount(ring, weights, rings) for weights in (away[whole], *layer[whole].T)]
    distance, *rgb = (sums[held] / count[held] for sums in mean)
    return distance, np.stack(rgb, axis=1)


def hue_deg(rgb: Array) -> Array:
    """Munsell hue as an angle in degrees, continuous along the colours [n, 3]; grey has NaN."""
    hue, _, chroma = np.moveaxis(colour.hvc_from_rgb(rgb), -1, 0)
    turned = np.where(chroma >= _GREY_CHROMA, hue, np.nan)
    known = np.isfinite(turned)
    turned[known] = np.unwrap(turned[known])
    return np.degrees(turned)


def ring_spread(layer: NDArray[np.float32], sight: Sight) -> float:
    """Largest difference of a channel around a ring, over the ring's strongest channel.

    A ring is all pixels whose middles are exactly as far from the centre as each other; the picture
    must have one sample a pixel, in its middle.
    """
    size = layer.shape[0]
    step = 2 * np.arange(size) + 1 - size
    square = step[:, None] ** 2 + step[None, :] ** 2
    whole = sight.circle.distance(layer.shape) < 0.99
    order = np.argsort(square[whole], kind="stable")
    starts = np.flatnonzero(np.diff(square[whole][order], prepend=-1))
    colours = layer[whole][order].astype(np.float64)
    high = np.maximum.reduceat(colours, starts)
    low = np.minimum.reduceat(colours, starts)
    strongest = np.abs(high).max(axis=1)
    return float(((high - low).max(axis=1) / np.maximum(strongest, 1e-12)).max())


def families(rgb: Array) -> list[str]:
    """Munsell's hue family of each colour [n, 3]; "N" for grey.

    >>> families(np.array([[0.5, 0.1, 0.1], [0.1, 0.1, 0.5], [0.2, 0.2, 0.2]]))
    ['R', 'PB', 'N']
    """
    notations = colour.munsell_notation(colour.hvc_from_rgb(rgb))
    return [str(note).split()[0].lstrip("0123456789.") for note in notations]


def family_share(rgb: Array, wanted: tuple[str, ...]) -> float:
    """Share of the colours [n, 3] whose hue belongs to one of the families."""
    found = np.array(families(rgb))
    return float(np.isin(found, wanted).mean()) if found.size else float("nan")


def span_deg(rgb: Array) -> float:
    """The arc of the hue circle, in degrees, that holds all colours [n, 3]: 360 less the widest gap."""
    hue, _, chroma = np.moveaxis(colour.hvc_from_rgb(rgb), -1, 0)
    angles = np.sort(np.degrees(hue[chroma >= _GREY_CHROMA]))
    if angles.size < 2:
        return 0.0
    gaps = np.diff(angles, append=angles[0] + 360)
    return float(360 - gaps.max())


def family_ticks() -> list[tuple[float, str]]:
    """The hue angle in degrees, -180 to 180, at which each family has its middle, such as 5R."""
    angles = np.radians(np.arange(-180, 180, 0.5))
    rings = np.stack([angles, np.full_like(angles, 5.0), np.full_like(angles, 6.0)], axis=1)
    names = np.array(
        [str(note).split()[0].lstrip("0123456789.") for note in colour.munsell_notation(rings)]
    )
    middles = []
    for family in FAMILIES:
        centre = np.angle(np.exp(1j * angles[names == family]).mean())
        middles.append((float(np.degrees(centre)), family))
    return middles
